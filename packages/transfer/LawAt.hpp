// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The law at a point: that of its material, with what its particle has of its own.

#include <new>
#include <type_traits>

#include "stroma/material/OneOf.hpp"
#include "stroma/transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// The laws at the points of an element, one after the other: those of the materials, or a copy of
/// one where particles have anything of their own. The copy stays from point to point as long as the
/// material does, and with it what follows from the step alone.
template <class Law, class Device, bool is_asked = material::is_asked_by_particle<Law>>
class LawAt {
 public:
  /// \param law     (material)
  /// \param points  of the rank
  KOKKOS_INLINE_FUNCTION LawAt(const Kokkos::View<const Law*, Device>& law,
                               const PointSet<Device>& points)
      : law_(law), points_(points) {}
  LawAt(const LawAt&) = delete;
  LawAt& operator=(const LawAt&) = delete;

  /// At a particle; good until the next is asked for.
  KOKKOS_INLINE_FUNCTION const Law& operator()(int p) {
    return at(points_.particles.material(p), p, true);
  }
  /// At a particle or a fictitious point.
  template <class Shape>
  KOKKOS_INLINE_FUNCTION const Law& operator()(const ParticlePoint<Shape>& point) {
    return at(point.material, point.like, point.p != no_particle);
  }

 private:
  /// \param p        the particle whose numbers it has: itself, or of a fictitious point the one
  ///                 whose material it takes
  /// \param is_real  a particle, which has a history and is driven; else neither
  KOKKOS_INLINE_FUNCTION const Law& at(int material, int p, bool is_real) {
    const particles::Particles<Device>& particles = points_.particles;
    const bool has_numbers = particles.own_numbers.extent(1) != 0;
    const bool has_history = is_real && particles.history.extent(1) != 0;
    const bool is_driven = is_real && points_.factors.extent(0) != 0;
    if (!has_numbers && !has_history && !is_driven) return law_(material);
    const bool is_new = own_ == nullptr || material != material_ || is_real != is_real_;
    if (is_new) {
      own_ = new (room_) Law(law_(material));
      material_ = material;
      is_real_ = is_real;
    }
    if constexpr (material::takes_numbers<Law>)
      if (has_numbers) own_->take(&particles.own_numbers(p, 0));
    if (is_driven && (is_new || has_numbers)) drive(*own_, points_.factors(material));
    if constexpr (material::states_of < Law >> 0)
      if (has_history) material::recall(*own_, &particles.history(p, 0), points_.time_step);
    return *own_;
  }

  static_assert(std::is_trivially_copyable_v<Law>, "it is copied as it is, and not destroyed");

  const Kokkos::View<const Law*, Device>& law_;
  const PointSet<Device>& points_;
  Law* own_ = nullptr;  // in the room, which is not touched where there is none
  int material_ = 0;
  bool is_real_ = true;
  alignas(Law) unsigned char room_[sizeof(Law)];
};

/// Where particles have nothing of their own: the law of the material.
template <class Law, class Device>
class LawAt<Law, Device, false> {
 public:
  KOKKOS_INLINE_FUNCTION LawAt(const Kokkos::View<const Law*, Device>& law,
                               const PointSet<Device>& points)
      : law_(law.data()), material_(points.particles.material.data()) {}

  KOKKOS_INLINE_FUNCTION const Law& operator()(int p) const { return law_[material_[p]]; }
  template <class Shape>
  KOKKOS_INLINE_FUNCTION const Law& operator()(const ParticlePoint<Shape>& point) const {
    return law_[point.material];
  }

 private:
  const Law* law_;
  const std::uint8_t* material_;
};

}  // namespace stroma::transfer
