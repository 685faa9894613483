// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Load curves: their values and slopes between and beyond their points. Claim V-TIME-1,
/// docs/verification.md.

#include <gtest/gtest.h>

#include "stroma/mechanics/problem/LoadCurve.hpp"

namespace stroma::mechanics {
namespace {

LoadCurve ramp_and_hold(Interpolation interpolation, Beyond beyond = Beyond::hold) {
  return load_curve({{0.0, 1.0, 4.0}, {0.0, 2.0, -1.0}, interpolation, beyond}, 10.0);
}

TEST(LoadCurve, WithoutPointsIsTheLoad) {
  const LoadCurve curve;
  EXPECT_EQ(curve.at(0.3), 0.3);
  EXPECT_EQ(curve.slope(0.3), 1.0);
  EXPECT_TRUE(curve.is_load());
}

TEST(LoadCurve, IsStraightBetweenItsPoints) {
  const LoadCurve curve = ramp_and_hold(Interpolation::linear);
  EXPECT_DOUBLE_EQ(curve.at(0.05), 1.0);
  EXPECT_DOUBLE_EQ(curve.at(0.1), 2.0);
  EXPECT_DOUBLE_EQ(curve.at(0.25), 0.5);
  EXPECT_DOUBLE_EQ(curve.slope(0.05), 20.0);  // by the load factor
  EXPECT_DOUBLE_EQ(curve.slope(0.25), -10.0);
  EXPECT_EQ(curve.at(0.9), -1.0);
  EXPECT_EQ(curve.slope(0.9), 0.0);
}

TEST(LoadCurve, StepsAtItsPoints) {
  const LoadCurve curve = ramp_and_hold(Interpolation::step);
  EXPECT_EQ(curve.at(0.0999), 0.0);
  EXPECT_EQ(curve.at(0.1), 2.0);
  EXPECT_EQ(curve.at(0.4), -1.0);
  EXPECT_EQ(curve.slope(0.2), 0.0);
}

TEST(LoadCurve, SmoothHasNoSlopeAtItsPoints) {
  const LoadCurve curve = ramp_and_hold(Interpolation::smooth);
  EXPECT_DOUBLE_EQ(curve.at(0.05), 1.0);
  EXPECT_EQ(curve.slope(0.0), 0.0);
  EXPECT_NEAR(curve.slope(0.1), 0.0, 1e-12);
  const double h = 1e-6;
  EXPECT_NEAR((curve.at(0.27 + h) - curve.at(0.27 - h)) / (2.0 * h), curve.slope(0.27), 1e-7);
}

TEST(LoadCurve, RepeatsFromItsFirstPoint) {
  const LoadCurve curve = ramp_and_hold(Interpolation::linear, Beyond::repeat);
  for (const double load : {0.05, 0.2, 0.39}) {
    EXPECT_NEAR(curve.at(load + 0.4), curve.at(load), 1e-12) << load;
    EXPECT_NEAR(curve.slope(load + 0.4), curve.slope(load), 1e-12) << load;
  }
}

TEST(LoadCurve, BeforeItsFirstPointIsTheFirstValue) {
  const LoadCurve curve = load_curve({{2.0, 3.0}, {5.0, 6.0}}, 10.0);
  EXPECT_EQ(curve.at(0.1), 5.0);
  EXPECT_EQ(curve.slope(0.1), 0.0);
}

}  // namespace
}  // namespace stroma::mechanics
