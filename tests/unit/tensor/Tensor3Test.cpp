// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Laws of 3 x 3 algebra, and the digits of the forms for small strains. Claims V-TEN-1 and
/// V-TEN-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stroma/tensor/Tensor3.hpp"

namespace stroma::tensor {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

const Tensor3 A{{{1.2, -0.7, 0.4}, {0.3, 2.1, -1.1}, {-0.6, 0.5, 0.9}}};
const Tensor3 B{{{-0.4, 1.3, 0.2}, {0.8, 0.1, -0.9}, {1.7, -0.5, 0.6}}};

double largest_difference(const Tensor3& a, const Tensor3& b) {
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(a(i, j) - b(i, j)));
  return largest;
}

TEST(Tensor3, InverseUndoesTheProduct) {
  EXPECT_LT(largest_difference(A * inverse(A), identity()), 10 * eps);
  EXPECT_LT(largest_difference(inverse(A) * A, identity()), 10 * eps);
}

TEST(Tensor3, DeterminantIsMultiplicative) {
  EXPECT_NEAR(det(A * B), det(A) * det(B), 20 * eps * std::abs(det(A) * det(B)));
  EXPECT_NEAR(det(transpose(A)), det(A), 10 * eps);
}

TEST(Tensor3, CofactorIsTheDerivativeOfTheDeterminant) {
  // det is cubic in h, so its central difference departs from the derivative by det(B) h^2 exactly.
  const double h = 1e-3;
  const double slope = (det(A + h * B) - det(A - h * B)) / (2.0 * h);
  EXPECT_NEAR(slope - det(B) * h * h, contract(cofactor(A), B), 1e-12);
}

TEST(Tensor3, SecondInvariantIsTheSumOfPrincipalMinors) {
  const double by_traces = 0.5 * (trace(A) * trace(A) - trace(A * A));
  EXPECT_NEAR(second_invariant(A), by_traces, 20 * eps);
}

TEST(Tensor3, TransposeReversesProducts) {
  EXPECT_LT(largest_difference(transpose(A * B), transpose(B) * transpose(A)), 4 * eps);
}

/// det(I + H) - 1 in long double, by the definition: the entries of I + h are exact there, and for
/// the strains below 64 bits leave enough digits only if the sum is arranged; hence the expansion
/// in minors, in long double.
long double reference_det_minus_one(const Tensor3& H) {
  const auto h = [&](int i, int j) { return static_cast<long double>(H(i, j)); };
  const auto minor = [&](int i, int j) { return h(i, i) * h(j, j) - h(i, j) * h(j, i); };
  const long double first = h(0, 0) + h(1, 1) + h(2, 2);
  const long double second = minor(0, 1) + minor(1, 2) + minor(0, 2);
  const long double third = h(0, 0) * (h(1, 1) * h(2, 2) - h(1, 2) * h(2, 1)) -
                            h(0, 1) * (h(1, 0) * h(2, 2) - h(1, 2) * h(2, 0)) +
                            h(0, 2) * (h(1, 0) * h(2, 1) - h(1, 1) * h(2, 0));
  return first + second + third;
}

TEST(Tensor3, DetMinusOneKeepsTheDigitsOfSmallStrains) {
  for (double scale = 0.3; scale > 1e-15; scale *= 0.1) {
    const Tensor3 H = scale * A;
    const auto expected = static_cast<double>(reference_det_minus_one(H));
    EXPECT_NEAR(det_minus_one(H), expected, 8 * eps * std::abs(expected)) << "strain " << scale;
  }
}

TEST(Tensor3, DetMinusOneIsTheDeterminantAtLargeStrains) {
  EXPECT_NEAR(det_minus_one(A - identity()), det(A) - 1.0, 20 * eps);
}

TEST(Tensor3, LeftCauchyGreenKeepsTheDigitsOfSmallStrains) {
  for (double scale = 0.3; scale > 1e-15; scale *= 0.1) {
    const Tensor3 H = scale * A;
    const Tensor3 b = left_cauchy_green_minus_identity(H);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        long double expected = static_cast<long double>(H(i, j)) + H(j, i);
        for (int k = 0; k < 3; ++k) expected += static_cast<long double>(H(i, k)) * H(j, k);
        EXPECT_NEAR(b(i, j), static_cast<double>(expected), 8 * eps * scale);
        EXPECT_EQ(b(i, j), b(j, i));
      }
  }
}

TEST(Tensor3, VonMisesOfKnownStates) {
  Tensor3 uniaxial, shear;
  uniaxial(1, 1) = -3.0;
  shear(0, 1) = shear(1, 0) = 2.0;
  EXPECT_NEAR(von_mises(uniaxial), 3.0, 8 * eps);
  EXPECT_NEAR(von_mises(shear), 2.0 * std::sqrt(3.0), 8 * eps);
  EXPECT_NEAR(von_mises(-7.0 * identity()), 0.0, 8 * eps);
  EXPECT_NEAR(von_mises(uniaxial + 5.0 * identity()), 3.0, 20 * eps);  // pressure has no part in it
  EXPECT_NEAR(trace(deviator(A)), 0.0, 4 * eps);
}

}  // namespace
}  // namespace stroma::tensor
