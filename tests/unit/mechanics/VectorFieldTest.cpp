// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/mechanics/problem/VectorField.hpp"

namespace stroma::mechanics {
namespace {

using Vector = std::array<double, 3>;

/// A block of a lattice with u_y = f(centre of the voxel).
template <class Function>
VectorField::Block block_of(const VoxelLattice& lattice, const voxels::Box& box,
                            const Function& f) {
  VectorField::Block block{box, {}};
  for (std::int64_t k = box.first[2]; k < box.first[2] + box.count[2]; ++k)
    for (std::int64_t j = box.first[1]; j < box.first[1] + box.count[1]; ++j)
      for (std::int64_t i = box.first[0]; i < box.first[0] + box.count[0]; ++i) {
        Vector centre;
        const std::array<std::int64_t, 3> voxel{i, j, k};
        for (std::size_t d = 0; d < 3; ++d)
          centre[d] =
              lattice.corner[d] + (static_cast<double>(voxel[d]) + 0.5) * lattice.voxel_size[d];
        block.values[1].push_back(f(centre));
      }
  return block;
}

// V-DVC-1. Trilinear between the centres, and on in the same lines beyond the outermost.
TEST(VectorField, MeetsATrilinearFieldOnItsWholeImageAndBeyond) {
  const VoxelLattice lattice{{4, 5, 3}, {2.0, 1.0, 3.0}, {-1.0, 2.0, 0.5}};
  const auto linear = [](const Vector& X) { return 3.0 + 0.5 * X[0] - 2.0 * X[1] + 0.25 * X[2]; };
  const VectorField field("here", lattice, {block_of(lattice, {{0, 0, 0}, {4, 5, 3}}, linear)},
                          1.0);
  for (const Vector& X : {Vector{0, 2.5, 2}, Vector{-1, 2, 0.5}, Vector{7, 7, 9.5},
                          Vector{3.3, 4.1, 5.2}, Vector{-1.7, 7.4, 10}})
    EXPECT_NEAR(field.at(1, X), linear(X), 1e-13);
}

TEST(VectorField, IsConstantAlongAnAxisWithOneVoxel) {
  const VoxelLattice slice{{3, 3, 1}, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}};
  const auto linear = [](const Vector& X) { return X[0] + 10.0 * X[1]; };
  const VectorField field("here", slice, {block_of(slice, {{0, 0, 0}, {3, 3, 1}}, linear)}, 1.0);
  for (const double z : {0.0, 0.5, 1.0}) EXPECT_NEAR(field.at(1, {1.2, 2.9, z}), 30.2, 1e-13);
}

// What is held around a box of points is what they need, from whichever block.
TEST(VectorField, NeedsTheVoxelsAroundItsPointsAlone) {
  const VoxelLattice lattice{{10, 10, 10}, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}};
  const voxels::Box lower = lattice.around({0, 0, 0}, {10, 0, 10}),
                    upper = lattice.around({0, 10, 0}, {10, 10, 10});
  EXPECT_EQ(lower.first[1], 0);
  EXPECT_EQ(lower.count[1], 2);
  EXPECT_EQ(upper.first[1], 8);
  EXPECT_EQ(upper.count[1], 2);
  EXPECT_EQ(lower.count[0], 10);
  const auto product = [](const Vector& X) { return X[0] * X[1] * X[2]; };
  const VectorField field(
      "here", lattice, {block_of(lattice, lower, product), block_of(lattice, upper, product)}, 1.0);
  EXPECT_NEAR(field.at(1, {4.3, 0.2, 7.7}), 4.3 * 0.2 * 7.7, 1e-12);
  EXPECT_NEAR(field.at(1, {0.1, 10.0, 9.9}), 0.1 * 10.0 * 9.9, 1e-11);
  EXPECT_THROW(field.at(1, {5, 5, 5}), std::logic_error);
}

// A voxel that is no number is an error where it counts, and nowhere else.
TEST(VectorField, NamesTheVoxelThatIsNoNumber) {
  const VoxelLattice lattice{{4, 4, 4}, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}};
  const VectorField field("here", lattice,
                          {block_of(lattice, {{0, 0, 0}, {4, 4, 4}},
                                    [](const Vector& X) { return X[0] > 3.0 ? NAN : 1.0; })},
                          1.0);
  EXPECT_EQ(field.at(1, {2.5, 1.0, 1.0}), 1.0);
  try {
    field.at(1, {2.75, 0.5, 0.5});
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("voxel (3, 0, 0)"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace stroma::mechanics
