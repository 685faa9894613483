// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A law that remembers, as an application outside packages/ writes it.

#include "stroma/material/NeoHookean.hpp"

namespace stroma::example {

using material::Tensor3;

/// A neo-Hookean solid that softens with the largest energy of shape that it has borne,
///
///     tau = g(m) dev tau0 + p I,   m = max(w0, state),   g(m) = 1 - D (1 - exp(-m / scale)),
///
/// with w0 and tau0 those of the undamaged solid. The state is the largest w0 of accepted steps.
/// Source: J. C. Simo, Comput. Methods Appl. Mech. Engrg. 60 (1987) 153.
struct DamagedLaw {
  material::NeoHookean undamaged;
  double most;   ///< D, < 1 [-]
  double scale;  ///< [Pa]

  using Tangent = material::FullTangent;
  static constexpr int states = 1;
  double state[states] = {};

  KOKKOS_INLINE_FUNCTION double shape_energy(const Tensor3& H) const {
    return undamaged.energy(H, 0.0);
  }
  KOKKOS_INLINE_FUNCTION double damage_energy(const Tensor3& H) const {
    return fmax(state[0], shape_energy(H));
  }
  KOKKOS_INLINE_FUNCTION double left(double m) const { return 1.0 + most * expm1(-m / scale); }

  KOKKOS_INLINE_FUNCTION void new_state(const Tensor3& H, double, double, double* next) const {
    next[0] = damage_energy(H);
  }

  KOKKOS_INLINE_FUNCTION material::SmallStrainModuli small_strain() const {
    return undamaged.small_strain();
  }
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    return undamaged.energy_of_volume(log_j);
  }
  KOKKOS_INLINE_FUNCTION material::VolumetricStress stress_of_volume(double log_j) const {
    return undamaged.stress_of_volume(log_j);
  }
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return left(damage_energy(H)) * shape_energy(H) + of_volume;
  }
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const material::VolumetricStress& volume) const {
    Tensor3 tau = left(damage_energy(H)) * undamaged.kirchhoff_stress(H, log_j, {0.0, 0.0});
    for (int i = 0; i < 3; ++i) tau(i, i) += volume.pressure;
    return tau;
  }
  /// g c0 + volume; and where m grows, dg = g'(m) dev tau0 : D.
  KOKKOS_INLINE_FUNCTION Tangent tangent(const Tensor3& H, double log_j,
                                         const material::VolumetricStress& volume) const {
    const double m = damage_energy(H), g = left(m);
    material::IsotropicTangent t = undamaged.tangent(H, log_j, {0.0, 0.0});
    const Tensor3 s = t.s;
    t.s = g * t.s;
    t.tau = g * t.tau;
    for (int i = 0; i < 3; ++i) t.tau(i, i) += volume.pressure;
    t.volumetric = g * t.volumetric + volume.modulus;
    t.symmetric = g * t.symmetric - volume.pressure;
    Tangent result(t);
    if (!(shape_energy(H) > state[0])) return result;
    const double slope = -most / scale * exp(-m / scale);
    result.c.add_dyad(slope, s);
    return result;
  }
};

}  // namespace stroma::example
