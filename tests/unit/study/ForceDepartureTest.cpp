// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// How forces depart from one another, by figures computed by hand.

#include <gtest/gtest.h>

#include <cmath>

#include "study/ForceDeparture.hpp"

namespace stroma {
namespace {

const ForceRecord straight{{0.0, 0.25, 0.5, 0.75, 1.0}, {0.0, 5.0, 10.0, 15.0, 20.0}};

// V-STUDY-COMPARE.
TEST(ForceDeparture, InterpolatesInLoad) {
  const ForceRecord record{{0.0, 0.5, 1.0}, {0.0, 8.0, 10.0}};
  EXPECT_EQ(force_at(record, 0.0), 0.0);
  EXPECT_EQ(force_at(record, 0.5), 8.0);
  EXPECT_EQ(force_at(record, 1.0), 10.0);
  EXPECT_DOUBLE_EQ(force_at(record, 0.25), 4.0);
  EXPECT_DOUBLE_EQ(force_at(record, 0.75), 9.0);
}

TEST(ForceDeparture, SecantIsTheLargestOverTheSteps) {
  EXPECT_EQ(secant_departure(straight), 0.0);
  // At loads 0.25, 0.5, 0.75 the line is at 2.5, 5, 7.5: the force is off by 1, 3, -0.5.
  EXPECT_DOUBLE_EQ(*secant_departure({straight.load, {0.0, 3.5, 8.0, 7.0, 10.0}}), 0.3);
  EXPECT_DOUBLE_EQ(*secant_departure({straight.load, {0.0, -3.5, -8.0, -7.0, -10.0}}), 0.3);
  EXPECT_EQ(secant_departure({{0.0, 1.0}, {0.0, 0.0}}), std::nullopt);
  EXPECT_EQ(secant_departure({}), std::nullopt);
  EXPECT_EQ(secant_departure({{0.0, 1.0}, {0.0, 7.0}}), std::nullopt) << "one step is no curve";
}

TEST(ForceDeparture, RmsOverTheStepsButTheUnloaded) {
  EXPECT_EQ(force_departure_rms(straight, straight), 0.0);
  // Off by 1, -1, 3, 1 (12 / 4 = 3) of a reference that ends at 20.
  const ForceRecord record{straight.load, {0.0, 6.0, 9.0, 18.0, 21.0}};
  EXPECT_DOUBLE_EQ(*force_departure_rms(record, straight), std::sqrt(3.0) / 20.0);
  EXPECT_DOUBLE_EQ(*force_departure_end(record, straight), 0.05);
  EXPECT_DOUBLE_EQ(*force_departure_end(straight, record), -1.0 / 21.0);
}

// A reference in other steps is interpolated: it is at 2 and 6 where the record has 3 and 5.
TEST(ForceDeparture, StepsMayDiffer) {
  const ForceRecord reference{{0.0, 0.5, 1.0}, {0.0, 4.0, 8.0}};
  const ForceRecord record{{0.0, 0.25, 0.75, 1.0}, {0.0, 3.0, 5.0, 8.0}};
  EXPECT_DOUBLE_EQ(*force_departure_rms(record, reference), std::sqrt(2.0 / 3.0) / 8.0);
}

TEST(ForceDeparture, IsUndefinedAgainstNoForce) {
  const ForceRecord none{{0.0, 1.0}, {0.0, 0.0}};
  EXPECT_EQ(force_departure_rms(straight, none), std::nullopt);
  EXPECT_EQ(force_departure_end(straight, none), std::nullopt);
  EXPECT_EQ(force_departure_rms({}, straight), std::nullopt);
  EXPECT_EQ(force_departure_end({}, straight), std::nullopt);
}

}  // namespace
}  // namespace stroma
