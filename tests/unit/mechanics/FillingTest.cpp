// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Which elements are barely filled, on any number of ranks.

#include <gtest/gtest.h>

#include "Refusal.hpp"
#include "stroma/mechanics/BarelyFilled.hpp"
#include "support/ShapeChoices.hpp"

namespace stroma::mechanics {
namespace {

/// A block of which every other voxel is empty, as on a chess board, and one more if so asked.
test::Specimen chess_board(const std::array<double, 3>& spacing, bool lacks_one) {
  test::Specimen specimen;
  specimen.elements = {4, 5, 6};
  specimen.spacing = spacing;
  specimen.layout = {particles::Layout::voxel_centers, 1, 2};
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")}};
  specimen.label = [lacks_one](const grid::Index3& voxel) {
    const bool is_lacking = lacks_one && voxel == grid::Index3{4, 4, 6};
    return (voxel[0] + voxel[1] + voxel[2]) % 2 == 0 && !is_lacking ? 0 : -1;
  };
  return specimen;
}

std::vector<std::array<double, 3>> spacings() {
  return {{2.1, 2.1, 2.0}, {0.7, 1.1, 1.3}, {0.596, 1.79, 1.95}, {0.3, 0.1, 0.2}};
}

// Every element is filled by a half, to rounding, which the order of ranks decides.
TEST(Filling, OfAHalfIsEnoughWhateverIsRounded) {
  for (const test::ShapeChoice& choice : test::shape_choices())
    for (const std::array<double, 3>& spacing : spacings()) {
      SCOPED_TRACE(choice.name + " " + std::to_string(spacing[0]));
      test::Specimen specimen = chess_board(spacing, false);
      choice.apply_to(specimen);
      EXPECT_EQ(count_barely_filled(*specimen.balance(world())), 0);
    }
}

TEST(Filling, OfAVoxelLessIsNot) {
  for (const test::ShapeChoice& choice : test::shape_choices()) {
    SCOPED_TRACE(choice.name);
    test::Specimen specimen = chess_board(spacings().front(), true);
    choice.apply_to(specimen);
    EXPECT_EQ(count_barely_filled(*specimen.balance(world())), 1);
  }
}

}  // namespace
}  // namespace stroma::mechanics
