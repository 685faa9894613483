// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The law at a point: that of its material, with what its particle has of its own.

#include "stroma/material/OneOf.hpp"
#include "stroma/transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// \param law        (material)
/// \param particles  of the rank
/// \param material   of the point
/// \param p          the particle whose stiffness it has: itself, or of a fictitious point the one
///                   whose material it takes
/// \param remembers  whether it has that particle's history, too; else none, zeros
/// \param time_step  length of the step [s]
/// \return the law, or a reference to the material's where particles have nothing of their own
template <class Law, class Device>
KOKKOS_INLINE_FUNCTION decltype(auto) law_at(const Kokkos::View<const Law*, Device>& law,
                                             const particles::Particles<Device>& particles,
                                             int material, int p, bool remembers,
                                             double time_step) {
  if constexpr (material::is_asked_by_particle<Law>) {
    Law own = law(material);
    if constexpr (material::may_vary_in_stiffness<Law>)
      if (particles.shear_modulus.extent(0) != 0)
        own = own.with_shear_modulus(particles.shear_modulus(p));
    if constexpr (material::states_of < Law >> 0)
      if (remembers && particles.history.extent(1) != 0)
        material::recall(own, &particles.history(p, 0), time_step);
    return own;
  } else {
    return (law(material));
  }
}

/// At a particle.
template <class Law, class Device>
KOKKOS_INLINE_FUNCTION decltype(auto) law_at(const Kokkos::View<const Law*, Device>& law,
                                             const particles::Particles<Device>& particles, int p,
                                             double time_step) {
  return law_at(law, particles, particles.material(p), p, true, time_step);
}

/// At a particle or a fictitious point.
template <class Law, class Device, class Shape>
KOKKOS_INLINE_FUNCTION decltype(auto) law_at(const Kokkos::View<const Law*, Device>& law,
                                             const particles::Particles<Device>& particles,
                                             const ParticlePoint<Shape>& point, double time_step) {
  return law_at(law, particles, point.material, point.like, point.p != no_particle, time_step);
}

}  // namespace stroma::transfer
