// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The law at a point: that of its material, with what its particle has of its own.

#include "stroma/material/OneOf.hpp"
#include "stroma/transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// \param law        (material)
/// \param points     of the rank
/// \param material   of the point
/// \param p          the particle whose numbers it has: itself, or of a fictitious point the one
///                   whose material it takes
/// \param is_real    a particle, which has a history and is driven; else neither
/// \return the law, or a reference to the material's where particles have nothing of their own
template <class Law, class Device>
KOKKOS_INLINE_FUNCTION decltype(auto) law_at(const Kokkos::View<const Law*, Device>& law,
                                             const PointSet<Device>& points, int material, int p,
                                             bool is_real) {
  if constexpr (material::is_asked_by_particle<Law>) {
    const particles::Particles<Device>& particles = points.particles;
    Law own = law(material);
    if constexpr (material::takes_numbers<Law>)
      if (particles.own_numbers.extent(1) != 0) own.take(&particles.own_numbers(p, 0));
    if constexpr (material::states_of < Law >> 0)
      if (is_real && particles.history.extent(1) != 0)
        material::recall(own, &particles.history(p, 0), points.time_step);
    if (is_real && points.factors.extent(0) != 0) drive(own, points.factors(material));
    return own;
  } else {
    return (law(material));
  }
}

/// At a particle.
template <class Law, class Device>
KOKKOS_INLINE_FUNCTION decltype(auto) law_at(const Kokkos::View<const Law*, Device>& law,
                                             const PointSet<Device>& points, int p) {
  return law_at(law, points, points.particles.material(p), p, true);
}

/// At a particle or a fictitious point.
template <class Law, class Device, class Shape>
KOKKOS_INLINE_FUNCTION decltype(auto) law_at(const Kokkos::View<const Law*, Device>& law,
                                             const PointSet<Device>& points,
                                             const ParticlePoint<Shape>& point) {
  return law_at(law, points, point.material, point.like, point.p != no_particle);
}

}  // namespace stroma::transfer
