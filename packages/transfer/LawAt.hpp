// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The law at a point: that of its material, with what its particle has of its own.

#include <new>
#include <type_traits>

#include "stroma/material/OneOf.hpp"
#include "stroma/transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// Points to the law of the material, or to a copy of it where the particle has anything of its own;
/// it stays where it is made.
template <class Law>
class LawAt {
 public:
  /// \param law        (material)
  /// \param points     of the rank
  /// \param material   of the point
  /// \param p          the particle whose numbers it has: itself, or of a fictitious point the one
  ///                   whose material it takes
  /// \param is_real    a particle, which has a history and is driven; else neither
  template <class Device>
  KOKKOS_INLINE_FUNCTION LawAt(const Kokkos::View<const Law*, Device>& law,
                               const PointSet<Device>& points, int material, int p, bool is_real)
      : law_(&law(material)) {
    if constexpr (material::is_asked_by_particle<Law>) {
      const particles::Particles<Device>& particles = points.particles;
      if constexpr (material::takes_numbers<Law>)
        if (particles.own_numbers.extent(1) != 0) own().take(&particles.own_numbers(p, 0));
      if constexpr (material::states_of < Law >> 0)
        if (is_real && particles.history.extent(1) != 0)
          material::recall(own(), &particles.history(p, 0), points.time_step);
      if (is_real && points.factors.extent(0) != 0) drive(own(), points.factors(material));
    }
  }
  /// At a particle.
  template <class Device>
  KOKKOS_INLINE_FUNCTION LawAt(const Kokkos::View<const Law*, Device>& law,
                               const PointSet<Device>& points, int p)
      : LawAt(law, points, points.particles.material(p), p, true) {}
  /// At a particle or a fictitious point.
  template <class Device, class Shape>
  KOKKOS_INLINE_FUNCTION LawAt(const Kokkos::View<const Law*, Device>& law,
                               const PointSet<Device>& points, const ParticlePoint<Shape>& point)
      : LawAt(law, points, point.material, point.like, point.p != no_particle) {}
  LawAt(const LawAt&) = delete;
  LawAt& operator=(const LawAt&) = delete;

  KOKKOS_INLINE_FUNCTION const Law* operator->() const { return law_; }

 private:
  static_assert(std::is_trivially_copyable_v<Law>, "it is copied as it is, and not destroyed");
  struct Room {
    alignas(Law) unsigned char bytes[sizeof(Law)];
  };
  struct Nothing {};

  /// The copy, in room that is not touched where there is none.
  KOKKOS_INLINE_FUNCTION Law& own() {
    if (own_ == nullptr) law_ = own_ = new (&room_) Law(*law_);
    return *own_;
  }

  const Law* law_;
  Law* own_ = nullptr;
  std::conditional_t<material::is_asked_by_particle<Law>, Room, Nothing> room_;
};

}  // namespace stroma::transfer
