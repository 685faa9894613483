// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// x - ln(1 + x) and exp(x) - 1 - x to full precision. Claim V-TEN-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "stroma/tensor/SmallDifference.hpp"

namespace stroma::tensor {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Taylor's series sum_{n >= 2} coefficient(n) x^n in long double, for |x| <= 0.01.
template <class Coefficient>
long double series(long double x, const Coefficient& coefficient) {
  long double sum = 0.0L, power = x;
  for (int n = 2; n <= 14; ++n) {
    power *= x;
    sum += coefficient(n) * power;
  }
  return sum;
}

long double reference_x_minus_log1p(double x) {
  if (std::abs(x) > 0.01) return static_cast<long double>(x) - log1pl(x);
  return series(x, [](int n) { return (n % 2 == 0 ? 1.0L : -1.0L) / n; });
}

long double reference_expm1_minus_x(double x) {
  if (std::abs(x) > 0.01) return expm1l(x) - static_cast<long double>(x);
  return series(x, [](int n) { return 1.0L / tgammal(n + 1.0L); });
}

std::vector<double> arguments() {
  std::vector<double> all{0.1999999, 0.2, 0.2000001, -0.1999999, -0.2, -0.2000001};
  for (double size = 0.9; size > 1e-140; size *= 0.37) {
    all.push_back(size);
    all.push_back(-size);
  }
  return all;
}

// Beyond |x| = 0.2 the plain difference is used; it loses a factor of at most |x| / (x^2 / 3) = 15.
TEST(SmallDifference, XMinusLog1pHasFullPrecision) {
  for (const double x : arguments()) {
    const auto expected = static_cast<double>(reference_x_minus_log1p(x));
    const double digits = std::abs(x) < 0.2 ? 4 * eps : 16 * eps;
    EXPECT_NEAR(x_minus_log1p(x), expected, digits * expected) << "x = " << x;
  }
  EXPECT_EQ(x_minus_log1p(0.0), 0.0);
  EXPECT_TRUE(std::isnan(x_minus_log1p(-1.5)));
}

TEST(SmallDifference, Expm1MinusXHasFullPrecision) {
  for (const double x : arguments()) {
    const auto expected = static_cast<double>(reference_expm1_minus_x(x));
    const double digits = std::abs(x) < 0.2 ? 4 * eps : 16 * eps;
    EXPECT_NEAR(expm1_minus_x(x), expected, digits * expected) << "x = " << x;
  }
  EXPECT_EQ(expm1_minus_x(0.0), 0.0);
}

}  // namespace
}  // namespace stroma::tensor
