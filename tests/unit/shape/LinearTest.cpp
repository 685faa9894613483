// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Trilinear hats: what every shape function owes the method. Claim V-SHA-1, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "stroma/shape/Linear.hpp"

namespace stroma::shape {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const double h[3] = {2.1, 0.7, 3.3};
const double inverse_h[3] = {1 / h[0], 1 / h[1], 1 / h[2]};

struct Values {
  double xi[3];
  double N[Linear::nodes];
  double gradient[3][Linear::nodes];
};

Values at(double x, double y, double z) {
  Values v{{x, y, z}, {}, {}};
  const Place place{{x, y, z}, {}, {}, {inverse_h[0], inverse_h[1], inverse_h[2]}, {{}, {}, {}}};
  Linear::evaluate(place, v.N, v.gradient);
  return v;
}

/// Corners, faces and points inside of an element.
template <class Check>
void for_points(const Check& check) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> inside(0.0, 1.0);
  for (const double x : {0.0, 1.0, 0.5}) check(at(x, 1.0 - x, 0.0));
  for (int n = 0; n < 50; ++n) check(at(inside(random), inside(random), inside(random)));
}

double node(int a, int d) { return h[d] * (d == 0 ? a & 1 : d == 1 ? a >> 1 & 1 : a >> 2); }

TEST(Linear, ValuesSumToOneAndGradientsToZero) {
  for_points([](const Values& v) {
    double sum = 0.0, slope[3] = {};
    for (int a = 0; a < Linear::nodes; ++a) {
      EXPECT_GE(v.N[a], 0.0);
      sum += v.N[a];
      for (int d = 0; d < 3; ++d) slope[d] += v.gradient[d][a];
    }
    EXPECT_NEAR(sum, 1.0, 8 * eps);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(slope[d], 0.0, 8 * eps * inverse_h[d]);
  });
}

TEST(Linear, LinearFieldsAreReproduced) {
  const double slope[3] = {0.3, -1.7, 0.9};
  for_points([&](const Values& v) {
    double value = 0.0, gradient[3] = {}, exact = 0.4;
    for (int d = 0; d < 3; ++d) exact += slope[d] * v.xi[d] * h[d];
    for (int a = 0; a < Linear::nodes; ++a) {
      double nodal = 0.4;
      for (int d = 0; d < 3; ++d) nodal += slope[d] * node(a, d);
      value += v.N[a] * nodal;
      for (int d = 0; d < 3; ++d) gradient[d] += v.gradient[d][a] * nodal;
    }
    EXPECT_NEAR(value, exact, 16 * eps * 4.0);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(gradient[d], slope[d], 64 * eps * 4.0);
  });
}

TEST(Linear, EachNodeHasItsOwnCorner) {
  for (int a = 0; a < Linear::nodes; ++a) {
    const Values v = at(a & 1, a >> 1 & 1, a >> 2);
    for (int b = 0; b < Linear::nodes; ++b) EXPECT_EQ(v.N[b], a == b ? 1.0 : 0.0);
  }
}

TEST(Linear, GradientIsTheDerivativeOfTheValue) {
  // The values are linear in each coordinate, so differences are exact but for rounding.
  const double step = 0.25;
  for (int d = 0; d < 3; ++d) {
    double lower[3] = {0.3, 0.4, 0.5}, upper[3] = {0.3, 0.4, 0.5};
    lower[d] -= step;
    upper[d] += step;
    const Values middle = at(0.3, 0.4, 0.5), low = at(lower[0], lower[1], lower[2]),
                 high = at(upper[0], upper[1], upper[2]);
    for (int a = 0; a < Linear::nodes; ++a)
      EXPECT_NEAR((high.N[a] - low.N[a]) / (2 * step * h[d]), middle.gradient[d][a], 16 * eps);
  }
}

}  // namespace
}  // namespace stroma::shape
