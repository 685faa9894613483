// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The paper's neo-Hookean solid.

#include "stroma/material/LawParameters.hpp"

namespace stroma::material {

/// Isotropic hyperelastic solid,
///
///     W = mu/2 (Ibar1 - 3) + U(J),   Ibar1 = J^(-2/3) tr b,  b = F F^T.
///
/// Source: the paper's equation (12); Simo & Hughes (1998), section 9.2 (quadratic U), 9.3
/// (isochoric part of the tangent). Symbols and units: docs/notation.md.
struct NeoHookean {
  double shear_modulus;  ///< mu [Pa], > 0
  double bulk_modulus;   ///< K [Pa], > 0
  VolumetricEnergy volumetric_energy = VolumetricEnergy::logarithmic;

  static const char* name() { return "Neo-Hookean"; }
  static const char* meaning() { return "W = mu/2 (J^(-2/3) tr C - 3) + U(J)"; }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("Shear Modulus [Pa]", &NeoHookean::shear_modulus, Range::positive(),
                      "Shear modulus mu.");
    declare_bulk_modulus(parameters, &NeoHookean::bulk_modulus);
    parameters.volumetric_energy(&NeoHookean::volumetric_energy);
  }

  using Tangent = IsotropicTangent;

  KOKKOS_FORCEINLINE_FUNCTION SmallStrainModuli small_strain() const {
    return {shear_modulus, bulk_modulus};
  }
  KOKKOS_FORCEINLINE_FUNCTION double energy_of_volume(double log_j) const {
    return material::energy_of_volume(volumetric_energy, bulk_modulus, log_j);
  }
  KOKKOS_FORCEINLINE_FUNCTION VolumetricStress stress_of_volume(double log_j) const {
    return material::stress_of_volume(volumetric_energy, bulk_modulus, log_j);
  }

  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return 0.5 * shear_modulus * isochoric_first_invariant_minus_3(H) + of_volume;
  }

  /// tau = mu J^(-2/3) dev(b) + p I,  dev(b) = dev(b - I).
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    Tensor3 tau = (shear_modulus * exp(-2.0 / 3.0 * log_j)) *
                  tensor::deviator(tensor::left_cauchy_green_minus_identity(H));
    for (int i = 0; i < 3; ++i) tau(i, i) += volume.pressure;
    return tau;
  }

  /// c = 2 m (I4 - 1/3 I x I) - 2/3 (s x I + I x s) + M I x I - 2 p I4,
  ///
  /// with s = dev tau, m = mu/3 J^(-2/3) tr b: vol = M - 2/3 m, sym = m - p.
  KOKKOS_FORCEINLINE_FUNCTION IsotropicTangent tangent(const Tensor3& H, double log_j,
                                                       const VolumetricStress& volume) const {
    const double factor = shear_modulus * exp(-2.0 / 3.0 * log_j);
    const Tensor3 b_minus_identity = tensor::left_cauchy_green_minus_identity(H);
    IsotropicTangent t;
    t.s = factor * tensor::deviator(b_minus_identity);
    t.tau = t.s;
    for (int i = 0; i < 3; ++i) t.tau(i, i) += volume.pressure;
    const double m = factor * (1.0 + tensor::trace(b_minus_identity) / 3.0);
    t.volumetric = volume.modulus - 2.0 / 3.0 * m;
    t.symmetric = m - volume.pressure;
    return t;
  }
};

}  // namespace stroma::material
