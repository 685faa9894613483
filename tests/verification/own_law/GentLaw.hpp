// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A law that Stroma does not have, as an application outside packages/ writes it.

#include "stroma/material/Law.hpp"

namespace stroma::example {

using material::Tensor3;

/// Gent's solid, whose chains lock at Ibar1 = 3 + Jm:
///
///     W = -mu Jm / 2 ln(1 - (Ibar1 - 3) / Jm) + K/2 (ln J)^2.
///
/// Source: A. N. Gent, Rubber Chem. Technol. 69 (1996) 59.
struct GentLaw {
  double shear_modulus;  ///< mu [Pa]
  double limit;          ///< Jm [-]
  double bulk_modulus;   ///< K [Pa]

  using Tangent = material::FullTangent;

  KOKKOS_INLINE_FUNCTION material::SmallStrainModuli small_strain() const {
    return {shear_modulus, bulk_modulus};
  }
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    return 0.5 * bulk_modulus * log_j * log_j;
  }
  KOKKOS_INLINE_FUNCTION material::VolumetricStress stress_of_volume(double log_j) const {
    return {bulk_modulus * log_j, bulk_modulus};
  }

  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    const double stretched = material::isochoric_first_invariant_minus_3(H);
    return -0.5 * shear_modulus * limit * log1p(-stretched / limit) + of_volume;
  }

  /// dW/dIbar1 = mu/2 Jm / (Jm - (Ibar1 - 3)).
  KOKKOS_INLINE_FUNCTION double slope(const Tensor3& H) const {
    return 0.5 * shear_modulus * limit / (limit - material::isochoric_first_invariant_minus_3(H));
  }

  /// tau = 2 dW/dIbar1 dev(bbar) + p I.
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const material::VolumetricStress& volume) const {
    Tensor3 tau = (2.0 * slope(H) * exp(-2.0 / 3.0 * log_j)) *
                  tensor::deviator(tensor::left_cauchy_green_minus_identity(H));
    for (int i = 0; i < 3; ++i) tau(i, i) += volume.pressure;
    return tau;
  }

  /// That of a neo-Hookean solid with mu = 2 dW/dIbar1, and 4 d2W/dIbar1^2 dev(bbar) x dev(bbar).
  KOKKOS_INLINE_FUNCTION Tangent tangent(const Tensor3& H, double log_j,
                                         const material::VolumetricStress& volume) const {
    const double w1 = slope(H), w11 = 2.0 * w1 * w1 / (shear_modulus * limit);
    const double factor = exp(-2.0 / 3.0 * log_j);
    const Tensor3 b_minus_identity = tensor::left_cauchy_green_minus_identity(H);
    const Tensor3 dev_b = factor * tensor::deviator(b_minus_identity);
    const double m = 2.0 * w1 * factor * (1.0 + tensor::trace(b_minus_identity) / 3.0);
    Tangent result(material::IsotropicTangent{kirchhoff_stress(H, log_j, volume), 2.0 * w1 * dev_b,
                                              volume.modulus - 2.0 / 3.0 * m, m - volume.pressure});
    result.c.add_dyad(4.0 * w11, dev_b);
    return result;
  }
};

}  // namespace stroma::example
