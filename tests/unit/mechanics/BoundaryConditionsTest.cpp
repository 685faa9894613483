// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What a face condition asks of a point.

#include <gtest/gtest.h>

#include "stroma/mechanics/problem/BoundaryConditions.hpp"
#include "support/Specimen.hpp"

namespace stroma::mechanics {
namespace {

using test::hold;
using test::stretch;

const std::array<double, 3> corner{1.0, 2.0, 3.0};
const std::array<double, 3> length{8.0, 10.0, 4.0};
const std::array<double, 3> point{5.0, 12.0, 4.0};

TEST(BoundaryCondition, StrainActsOutwards) {
  const auto up = stretch(Face::y_upper, "xyz", 0.1);
  EXPECT_DOUBLE_EQ(up.full(1, point, corner, length), 1.0);
  EXPECT_EQ(up.full(0, point, corner, length), 0.0);
  const auto down = stretch(Face::y_lower, "xyz", 0.1);
  EXPECT_DOUBLE_EQ(down.full(1, point, corner, length), -1.0);
  EXPECT_EQ(up.loaded_component(length), 1);
}

TEST(BoundaryCondition, GradientActsFromTheCorner) {
  BoundaryCondition shear = hold(Face::all, "xyz");
  shear.displacement_gradient = {{0, 0.2, 0, 0, 0, 0, 0, 0, -0.5}};
  EXPECT_DOUBLE_EQ(shear.full(0, point, corner, length), 0.2 * 10.0);
  EXPECT_EQ(shear.full(1, point, corner, length), 0.0);
  EXPECT_DOUBLE_EQ(shear.full(2, point, corner, length), -0.5);
  EXPECT_EQ(shear.full(0, corner, corner, length), 0.0);
}

TEST(BoundaryCondition, WithoutAValueItHolds) {
  const auto held = hold(Face::z_lower, "xz");
  for (int c = 0; c < 3; ++c) EXPECT_EQ(held.full(c, point, corner, length), 0.0);
  EXPECT_TRUE(held.prescribes(0));
  EXPECT_FALSE(held.prescribes(1));
  EXPECT_EQ(held.loaded_component(length), -1);
}

TEST(BoundaryCondition, FacesHaveAxesAndSides) {
  EXPECT_EQ(axis_of(Face::x_lower), 0);
  EXPECT_EQ(axis_of(Face::z_upper), 2);
  EXPECT_EQ(axis_of(Face::all), -1);
  EXPECT_TRUE(is_upper(Face::y_upper));
  EXPECT_FALSE(is_upper(Face::y_lower));
}

TEST(BoundaryCondition, AnAxisMayHaveAnyLength) {
  BoundaryCondition turning = hold(Face::z_lower, "xyz");
  turning.rotation = 1.0;
  turning.center = {{0.0, 0.0, 0.0}};
  for (const double size : {1e-200, 1.0, 1e308}) {
    turning.axis = {{0.0, -size, 0.0}};
    EXPECT_EQ(turning.lever({2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {4.0, 4.0, 4.0}),
              (std::array<double, 3>{0.0, 0.0, 2.0}));
  }
}

}  // namespace
}  // namespace stroma::mechanics
