// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Fibres that buckle under compression and stiffen in tension.

#include "stroma/material/FiberLaw.hpp"
#include "stroma/tensor/SmallDifference.hpp"

namespace stroma::material {

/// Collagen fibres of cell-traction laboratories: energy w(s), s = lambda - 1, w(0) = w'(0) = 0,
///
///     w'' = K exp(s / D0)                 s < 0: they buckle
///           K                             0 < s < Lambda S
///           K exp((s - Lambda S) / DS)    beyond: they stiffen.
///
/// Source: Steinwachs et al. (2016), Nat Methods 13:171.
struct BucklingStiffening {
  double k;         ///< K [Pa], > 0
  double d0;        ///< [-], > 0
  double lambda_s;  ///< [-], >= 0
  double ds;        ///< [-], > 0

  static const char* name() { return "Buckling-Stiffening"; }
  static const char* meaning() {
    return "w(s), s = l - 1: w'' = K exp(s/D0) in compression, K to Lambda S, K exp((s - Lambda "
           "S)/DS) beyond";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("K [Pa]", &BucklingStiffening::k, Range::positive(),
                      "Modulus K of straight fibres.");
    parameters.number("D0", &BucklingStiffening::d0, Range::positive(),
                      "Strain over which fibres buckle.");
    parameters.number("Lambda S", &BucklingStiffening::lambda_s, Range::at_least(0.0),
                      "Strain at which fibres begin to stiffen.");
    parameters.number("DS", &BucklingStiffening::ds, Range::positive(),
                      "Strain over which fibres stiffen by a factor e.");
  }

  KOKKOS_INLINE_FUNCTION FiberResponse at(double x) const {
    const double s = stretch_minus_one(x), l = 1.0 + s;
    if (s <= 0.0) {
      const double y = s / d0;
      return by_square(k * d0 * d0 * tensor::expm1_minus_x(y), k * d0 * expm1(y), k * exp(y), l);
    }
    if (s <= lambda_s) return by_square(0.5 * k * s * s, k * s, k, l);
    const double beyond = s - lambda_s, y = beyond / ds;
    return by_square(
        k * (0.5 * lambda_s * lambda_s + lambda_s * beyond + ds * ds * tensor::expm1_minus_x(y)),
        k * (lambda_s + ds * expm1(y)), k * exp(y), l);
  }
  KOKKOS_INLINE_FUNCTION double small_strain_modulus() const { return k; }
};

}  // namespace stroma::material
