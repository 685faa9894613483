// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Differences of elementary functions from their linear part, without cancellation near zero.

#include <Kokkos_Core.hpp>
#include <cmath>

namespace stroma::tensor {

/// x - ln(1 + x) for x > -1; NaN below. Second order in x, and accurate to rounding for small x.
///
/// Near zero the series with y = x / (2 + x), ln(1 + x) = 2 (y + y^3/3 + y^5/5 + ...), and
/// x - 2 y = x y give  x y - 2 y^3 (1/3 + y^2/5 + ...).
KOKKOS_INLINE_FUNCTION double x_minus_log1p(double x) {
  if (!(x > -0.2 && x < 0.2)) return x - log1p(x);
  const double y = x / (2.0 + x);
  const double z = y * y;
  double series = 0.0;  // |y| < 1/9: the first term left out is below 1e-17 of the first
  for (int n = 19; n >= 3; n -= 2) series = series * z + 1.0 / n;
  return x * y - 2.0 * y * z * series;
}

/// exp(x) - 1 - x; second order in x, and accurate to rounding for small x.
KOKKOS_INLINE_FUNCTION double expm1_minus_x(double x) {
  if (!(x > -0.2 && x < 0.2)) return expm1(x) - x;
  double series = 1.0;  // x^2/2 (1 + x/3 (1 + x/4 (1 + ...)))
  for (int n = 14; n >= 3; --n) series = 1.0 + x / n * series;
  return 0.5 * x * x * series;
}

}  // namespace stroma::tensor
