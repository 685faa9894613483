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

  KOKKOS_INLINE_FUNCTION double energy(double x) const {
    const Stretch at(*this, x);
    return k * (d0 * d0 * tensor::expm1_minus_x(at.buckled) + 0.5 * at.straight * at.straight +
                ds * (lambda_s * at.stiffened + ds * tensor::expm1_minus_x(at.stiffened)));
  }
  KOKKOS_INLINE_FUNCTION FiberSlopes slopes(double x) const {
    const Stretch at(*this, x);
    const double buckled = tensor::vector_expm1(at.buckled),
                 stiffened = tensor::vector_expm1(at.stiffened);
    return by_square(k * (d0 * buckled + at.straight + ds * stiffened),
                     k * (1.0 + buckled) * (1.0 + stiffened), 1.0 + at.s);
  }
  KOKKOS_INLINE_FUNCTION double small_strain_modulus() const { return k; }

 private:
  /// s, and its parts in each of the three ranges, those that are exponents by their strains.
  struct Stretch {
    double s, buckled, straight, stiffened;

    KOKKOS_INLINE_FUNCTION Stretch(const BucklingStiffening& law, double x)
        : s(stretch_minus_one(x)) {
      const double pulled = in_tension(s) * s;
      const double beyond = in_tension(s - law.lambda_s) * (s - law.lambda_s);
      straight = pulled - beyond;
      buckled = (s - pulled) / law.d0;
      stiffened = beyond / law.ds;
    }
  };
};

}  // namespace stroma::material
