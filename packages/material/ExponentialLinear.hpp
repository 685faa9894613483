// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Fibres that stiffen exponentially until they are straight.

#include "stroma/material/FiberLaw.hpp"

namespace stroma::material {

/// Fibres that pull only, of tendon and ligament: with the stretch l > 1,
///
///     l dpsi/dl = C3 (exp(C4 (l - 1)) - 1)   to l = Lambda Max,
///                 C5 l + C6                  beyond, C6 by continuity.
///
/// Source: Weiss, Maker, Govindjee (1996), Comput Methods Appl Mech Eng 135:107;
/// "fiber-exp-linear" of FEBio.
struct ExponentialLinear {
  double c3;          ///< [Pa], > 0
  double c4;          ///< [-], > 0
  double c5;          ///< [Pa], >= 0
  double lambda_max;  ///< [-], > 1

  static const char* name() { return "Exponential-Linear"; }
  static const char* meaning() {
    return "l dW/dl = C3 (exp(C4 (l - 1)) - 1) to Lambda Max, C5 l + C6 beyond, in tension "
           "(\"fiber-exp-linear\" of FEBio)";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("C3 [Pa]", &ExponentialLinear::c3, Range::positive(), "Modulus C3.");
    parameters.number("C4", &ExponentialLinear::c4, Range::positive(), "Exponent C4 of l - 1.");
    parameters.number("C5 [Pa]", &ExponentialLinear::c5, Range::at_least(0.0),
                      "Modulus C5 of straight fibres.");
    parameters.number("Lambda Max", &ExponentialLinear::lambda_max, Range::above(1.0),
                      "Stretch at which fibres are straight.");
  }

  KOKKOS_INLINE_FUNCTION double energy(double x) const {
    if (!(x > 0.0)) return 0.0;
    const double s = stretch_minus_one(x), s_max = lambda_max - 1.0;
    if (s <= s_max) return crimped_energy(s);
    const double c6 = c3 * expm1(c4 * s_max) - c5 * lambda_max;
    return crimped_energy(s_max) + c5 * (s - s_max) + c6 * log((1.0 + s) / lambda_max);
  }
  KOKKOS_INLINE_FUNCTION FiberSlopes slopes(double x) const {
    const double tension = in_tension(x), s = stretch_minus_one(tension * x), l = 1.0 + s;
    const double s_max = lambda_max - 1.0, is_straight = in_tension(s - s_max);
    const double beyond = is_straight * (s - s_max);
    const double growth = c3 * tensor::vector_expm1(c4 * (s - beyond));
    const double force = (growth + c5 * beyond) / l;  // dpsi/dl
    const double slope = tension * (is_straight * c5 + (1.0 - is_straight) * c4 * (c3 + growth));
    return by_square(force, (slope - force) / l, l);
  }
  KOKKOS_INLINE_FUNCTION double small_strain_modulus() const { return c3 * c4; }

 private:
  /// The integral of C3 (exp(C4 t) - 1) / (1 + t) over t from 0 to s, by Gauss's rule of 8 points on
  /// pieces over which the exponent grows by at most 1: exact to rounding.
  KOKKOS_INLINE_FUNCTION double crimped_energy(double s) const {
    constexpr double place[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                 0.9602898564975363};
    constexpr double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                  0.1012285362903763};
    const int pieces = 1 + static_cast<int>(fmin((c4 + 1.0) * s, 1000.0));
    const double half = 0.5 * s / pieces;
    double sum = 0.0;
    for (int piece = 0; piece < pieces; ++piece)
      for (int n = 0; n < 4; ++n)
        for (const double side : {-1.0, 1.0}) {
          const double t = half * (2.0 * piece + 1.0 + side * place[n]);
          sum += weight[n] * expm1(c4 * t) / (1.0 + t);
        }
    return c3 * half * sum;
  }
};

}  // namespace stroma::material
