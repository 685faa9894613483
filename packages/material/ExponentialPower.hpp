// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Fibres that stiffen as an exponential of a power.

#include "stroma/material/FiberLaw.hpp"

namespace stroma::material {

/// Fibres that pull only,
///
///     psi = Xi/(Alpha Beta) (exp(Alpha (I - 1)^Beta) - 1) for I > 1, else 0;
///     Alpha = 0: Xi/Beta (I - 1)^Beta.
///
/// "fiber-exp-pow" of FEBio.
struct ExponentialPower {
  double xi;     ///< [Pa], > 0
  double alpha;  ///< [-], >= 0
  double beta;   ///< [-], >= 2

  static const char* name() { return "Exponential-Power"; }
  static const char* meaning() {
    return "Xi/(Alpha Beta) (exp(Alpha (I_n - 1)^Beta) - 1) in tension, Alpha = 0: Xi/Beta (I_n - "
           "1)^Beta (\"fiber-exp-pow\" of FEBio)";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("Xi [Pa]", &ExponentialPower::xi, Range::positive(), "Modulus Xi.");
    parameters.number("Alpha", &ExponentialPower::alpha, Range::at_least(0.0),
                      "Factor Alpha of the exponent.");
    parameters.number("Beta", &ExponentialPower::beta, Range::at_least(2.0),
                      "Power Beta of I_n - 1.");
  }

  KOKKOS_INLINE_FUNCTION double energy(double x) const {
    if (!(x > 0.0)) return 0.0;
    const double power = pow(x, beta);
    return alpha > 0.0 ? xi / (alpha * beta) * expm1(alpha * power) : xi / beta * power;
  }
  KOKKOS_INLINE_FUNCTION FiberSlopes slopes(double x) const {
    const double tension = in_tension(x), y = tension * x;
    const double power = tensor::vector_pow(y, beta - 2.0), growth = alpha * power * y * y;
    const double factor = tension * xi * power * tensor::vector_exp(growth);
    return {factor * y, factor * (beta - 1.0 + beta * growth)};
  }
  /// 4 psi'' at x = 0: of beta = 2 alone not zero.
  KOKKOS_INLINE_FUNCTION double small_strain_modulus() const {
    return beta == 2.0 ? 4.0 * xi : 0.0;
  }
};

}  // namespace stroma::material
