// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Energy of a change of volume, for laws that share it.

#include "stroma/tensor/SmallDifference.hpp"

namespace stroma::material {

/// A function U(J) with bulk modulus K, in x = ln J alone; both are K/2 x^2 in small strain.
enum class VolumetricEnergy {
  logarithmic,  ///< U = K/2 (ln J)^2
  quadratic     ///< U = K/4 (J^2 - 1 - 2 ln J)
};

/// The part of stress and tangent that comes of the volume: p I, and p, M in a tangent.
struct VolumetricStress {
  double pressure;  ///< p [Pa], tension positive; of the law itself, dU/d ln J
  double modulus;   ///< M [Pa]; of the law itself, dp/d ln J
};

/// U [Pa] at x = ln J; the quadratic one is K/4 (exp(2 x) - 1 - 2 x). Accurate to rounding for
/// small x.
KOKKOS_FORCEINLINE_FUNCTION double energy_of_volume(VolumetricEnergy form, double bulk_modulus,
                                                    double log_j) {
  return form == VolumetricEnergy::logarithmic
             ? 0.5 * bulk_modulus * log_j * log_j
             : 0.25 * bulk_modulus * tensor::expm1_minus_x(2.0 * log_j);
}

/// The first two derivatives of U by ln J [Pa]: K ln J and K, or K/2 (J^2 - 1) and K J^2.
KOKKOS_FORCEINLINE_FUNCTION VolumetricStress stress_of_volume(VolumetricEnergy form,
                                                              double bulk_modulus, double log_j) {
  if (form == VolumetricEnergy::logarithmic) return {bulk_modulus * log_j, bulk_modulus};
  const double growth = expm1(2.0 * log_j);
  return {0.5 * bulk_modulus * growth, bulk_modulus * (1.0 + growth)};
}

}  // namespace stroma::material
