// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Principal values against tensors built from known ones, to rounding.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "stroma/tensor/PrincipalValues.hpp"

namespace stroma {
namespace {

using tensor::Tensor3;

/// Rotation about an axis that is none of the coordinate axes (Rodrigues).
Tensor3 rotation(double angle) {
  const double n[3] = {2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0};
  const Tensor3 cross{{{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}}};
  return tensor::identity() + std::sin(angle) * cross + (1.0 - std::cos(angle)) * (cross * cross);
}

/// The largest error of the principal values of R diag(a, b, c) R^T, relative to the largest of
/// them.
double error_of(double a, double b, double c, double angle) {
  const Tensor3 R = rotation(angle);
  const Tensor3 diagonal{{{a, 0, 0}, {0, b, 0}, {0, 0, c}}};
  const auto found = tensor::principal_values(R * diagonal * tensor::transpose(R));
  double expected[3] = {a, b, c};
  std::sort(expected, expected + 3, std::greater<double>());
  double error = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    error = std::max(error, std::abs(found(i) - expected[i]));
    size = std::max(size, std::abs(expected[i]));
  }
  return error / size;
}

constexpr double rounding = 2e-15;  // about ten times eps: the product R D R^T rounds too

TEST(PrincipalValues, AreExactToRoundingWhetherRepeatedOrNot) {
  const double triples[][3] = {{3, 1, -2},       {1, 1, -2},       {-2, 1, 1}, {5, 5, 5},
                               {1, 1 + 1e-9, 3}, {1, 1e-8, 0},     {1, 0, 0},  {1e6, 1, 1e-6},
                               {-1, -2, -3},     {1, 1, 1 + 1e-15}};
  for (const auto& t : triples) {
    for (const double angle : {0.0, 1e-9, 0.3, 1.0, 2.5, 3.14159265358979}) {
      for (const double scale : {1.0, 1e-12, 1e12, 1e-150}) {
        EXPECT_LT(error_of(scale * t[0], scale * t[1], scale * t[2], angle), rounding)
            << t[0] << ' ' << t[1] << ' ' << t[2] << " angle " << angle << " scale " << scale;
      }
    }
  }
}

// Axes of values that are far apart, nearly equal and equal: unit vectors across each other, of which
// the tensor can be made again.
TEST(PrincipalAxes, AreOrthonormalAndMakeTheTensor) {
  for (const double apart : {1.0, 1e-4, 1e-8, 1e-12, 1e-16, 0.0})
    for (const double angle : {0.0, 1e-9, 0.3, 1.0, 2.5, 3.14159265358979}) {
      const Tensor3 R = rotation(angle);
      const Tensor3 a = R * Tensor3{{{2, 0, 0}, {0, 2 + apart, 0}, {0, 0, -1}}} * transpose(R);
      const tensor::PrincipalAxes found = tensor::principal_axes(a);
      const Tensor3 values{
          {{found.value[0], 0, 0}, {0, found.value[1], 0}, {0, 0, found.value[2]}}};
      const Tensor3 again = found.axes * values * transpose(found.axes);
      const Tensor3 one = found.axes * transpose(found.axes);
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
          EXPECT_NEAR(one(i, j), i == j ? 1.0 : 0.0, rounding) << apart << ", angle " << angle;
          EXPECT_NEAR(again(i, j), a(i, j), 3.0 * rounding) << apart << ", angle " << angle;
        }
    }
}

TEST(PrincipalValues, OfZeroAreZero) {
  const auto values = tensor::principal_values(Tensor3{});
  for (int i = 0; i < 3; ++i) EXPECT_EQ(values(i), 0.0);
}

// Half the distance of the outer values is the largest shear stress: pure shear gives tau, 0, -tau.
TEST(PrincipalValues, OfPureShear) {
  const double tau = 1e-12;
  const auto values = tensor::principal_values({{{0, 0, tau}, {0, 0, 0}, {tau, 0, 0}}});
  EXPECT_DOUBLE_EQ(values(0), tau);
  EXPECT_NEAR(values(1), 0.0, 1e-28);
  EXPECT_DOUBLE_EQ(values(2), -tau);
}

TEST(PrincipalValues, ReadOnlyTheUpperTriangle) {
  const Tensor3 symmetric{{{2, 0.5, -1}, {0.5, 1, 0.25}, {-1, 0.25, -3}}};
  Tensor3 spoilt = symmetric;
  spoilt(1, 0) = spoilt(2, 0) = spoilt(2, 1) = 1e9;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(tensor::principal_values(spoilt)(i), tensor::principal_values(symmetric)(i));
  }
}

TEST(PrincipalValues, OfSomethingNotFiniteAreNotFinite) {
  Tensor3 bad = tensor::identity();
  bad(0, 1) = bad(1, 0) = std::nan("");
  const auto values = tensor::principal_values(bad);
  EXPECT_FALSE(std::isfinite(values(0)) && std::isfinite(values(1)) && std::isfinite(values(2)));
}

}  // namespace
}  // namespace stroma
