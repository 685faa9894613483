// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// From the deck's element size to a grid over the specimen.

#include <gtest/gtest.h>

#include "stroma/base/Error.hpp"
#include "stroma/mechanics/problem/GridParameters.hpp"

namespace stroma::mechanics {

using grid::Grid;
using grid::Index3;

namespace {

TEST(MakeGrid, ElementSizeDividesTheBox) {
  GridParameters parameters;
  parameters.element_size = {{2.1, 2.1, 2.0}};
  const Grid grid = make_grid(parameters, {16.8, 8.4, 2.0});
  EXPECT_EQ(grid.elements, (Index3{8, 4, 1}));
  EXPECT_DOUBLE_EQ(grid.spacing[0], 2.1);
  EXPECT_DOUBLE_EQ(grid.length(1), 8.4);
}

TEST(MakeGrid, ElementsAreCounted) {
  GridParameters parameters;
  parameters.elements = {{50, 50, 33}};
  const Grid grid = make_grid(parameters, {93.0, 93.0, 92.07});
  EXPECT_EQ(grid.elements, (Index3{50, 50, 33}));
  EXPECT_DOUBLE_EQ(grid.spacing[2], 2.79);
}

TEST(MakeGrid, ASizeThatDoesNotDivideIsNamedWithTheNearestThatDo) {
  GridParameters parameters;
  parameters.element_size = {{2.0, 3.0, 2.0}};
  try {
    make_grid(parameters, {10.0, 10.0, 10.0});
    FAIL() << "3 um does not divide 10 um";
  } catch (const base::InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("Element Size"), std::string::npos) << message;
    EXPECT_NE(message.find("along y"), std::string::npos) << message;
    EXPECT_NE(message.find("2.5 um"), std::string::npos) << message;
    EXPECT_EQ(message.find("along x"), std::string::npos) << message;
  }
}

TEST(MakeGrid, PlaneStrainNeedsOneElementThroughZ) {
  GridParameters parameters;
  parameters.elements = {{4, 4, 2}};
  parameters.plane_strain = true;
  EXPECT_THROW(make_grid(parameters, {4.0, 4.0, 2.0}), base::InputError);
  parameters.elements = {{4, 4, 1}};
  EXPECT_NO_THROW(make_grid(parameters, {4.0, 4.0, 2.0}));
}

}  // namespace
}  // namespace stroma::mechanics
