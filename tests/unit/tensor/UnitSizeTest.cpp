// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Vectors of any length, brought to one whose square is a number.

#include <gtest/gtest.h>

#include "stroma/tensor/UnitSize.hpp"

namespace stroma::tensor {
namespace {

using Vector = std::array<double, 3>;

TEST(UnitSize, IsAPowerOfTwoAway) {
  EXPECT_EQ(of_unit_size({3.0, -10.0, 0.3}), (Vector{0.375, -1.25, 0.0375}));
  EXPECT_EQ(of_unit_size({0.0, 1.0, 0.0}), (Vector{0.0, 1.0, 0.0}));
  EXPECT_EQ(of_unit_size({}), Vector{});
}

TEST(UnitSize, IsThatOfTheShortestAndTheLongest) {
  const double shortest = 4.9406564584124654e-324, longest = 0x1.8p1023;
  EXPECT_EQ(of_unit_size({0.0, 0.0, -shortest}), (Vector{0.0, 0.0, -1.0}));
  EXPECT_EQ(of_unit_size({longest, -longest, 0.0}), (Vector{1.5, -1.5, 0.0}));
  EXPECT_EQ(of_unit_size({longest, shortest, 0.0})[0], 1.5);
}

}  // namespace
}  // namespace stroma::tensor
