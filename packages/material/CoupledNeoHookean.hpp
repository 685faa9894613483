// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The compressible neo-Hookean solid whose energy is not split into shape and volume.

#include "stroma/material/LawParameters.hpp"

namespace stroma::material {

/// Isotropic hyperelastic solid,
///
///     W = mu/2 (tr b - 3) - mu ln J + lambda/2 (ln J)^2,   b = F F^T.
///
/// The last term counts as the energy of volume U. Source: Bonet & Wood (2008), section 6.4.3;
/// "neo-Hookean" of FEBio.
struct CoupledNeoHookean {
  double shear_modulus;  ///< mu [Pa], > 0
  double lame_modulus;   ///< lambda [Pa], > -2/3 mu

  static constexpr bool is_isochoric = false;

  static const char* name() { return "Coupled Neo-Hookean"; }
  static const char* meaning() {
    return "W = mu/2 (tr C - 3) - mu ln J + lambda/2 (ln J)^2 (\"neo-Hookean\" of FEBio)";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("Shear Modulus [Pa]", &CoupledNeoHookean::shear_modulus, Range::positive(),
                      "Shear modulus mu.");
    declare_lame_modulus(parameters, &CoupledNeoHookean::lame_modulus);
  }

  using Tangent = IsotropicTangent;

  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const {
    return {shear_modulus, lame_modulus + 2.0 / 3.0 * shear_modulus};
  }
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    return material::energy_of_volume(VolumetricEnergy::logarithmic, lame_modulus, log_j);
  }
  KOKKOS_INLINE_FUNCTION VolumetricStress stress_of_volume(double log_j) const {
    return material::stress_of_volume(VolumetricEnergy::logarithmic, lame_modulus, log_j);
  }

  /// tr b - 3 - 2 ln J = H:H - 2 II - 2 III + 2 (j - ln J), with j = J - 1 and the invariants of H.
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return 0.5 * shear_modulus *
               (tensor::contract(H, H) - 2.0 * tensor::second_invariant(H) - 2.0 * tensor::det(H) +
                2.0 * tensor::x_minus_log1p(tensor::det_minus_one(H))) +
           of_volume;
  }

  /// tau = mu (b - I) + p I.
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double,
                                                  const VolumetricStress& volume) const {
    Tensor3 tau = shear_modulus * tensor::left_cauchy_green_minus_identity(H);
    for (int i = 0; i < 3; ++i) tau(i, i) += volume.pressure;
    return tau;
  }

  /// c = 2 mu I4 + M I x I - 2 p I4.
  KOKKOS_INLINE_FUNCTION IsotropicTangent tangent(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    return {
        kirchhoff_stress(H, log_j, volume), {}, volume.modulus, shear_modulus - volume.pressure};
  }
};

}  // namespace stroma::material
