// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The traffic of equal boxes of n x n x n elements against its closed form.

#include <gtest/gtest.h>

#include "stroma/multigrid/GeometricMultigrid.hpp"
#include "stroma/solver/IterationTraffic.hpp"

namespace stroma::test {
namespace {

/// A cube of p x p x p ranks with n x n x n elements each.
grid::Partition cube(std::int64_t p, std::int64_t n) {
  grid::Grid grid;
  grid.elements = {p * n, p * n, p * n};
  std::vector<std::int64_t> cuts;
  for (std::int64_t cut = 0; cut <= p; ++cut) cuts.push_back(cut * n);
  return {grid, {cuts, cuts, cuts}};
}

constexpr int centre = 1 + 3 * (1 + 3 * 1);  // of 27 ranks
constexpr int corner = 0;

TEST(BoxPartition, ProductOfRows) {
  // A rank inside owns n^3 nodes and sends faces, edges and corners to all 26 around it.
  for (const std::int64_t n : {1, 2, 5, 16}) {
    const auto traffic = grid::rows_product_traffic(cube(3, n), centre);
    EXPECT_EQ(traffic.neighbours, 26);
    EXPECT_EQ(traffic.messages, 26);
    EXPECT_EQ(traffic.bytes, 24 * (6 * n * n + 12 * n + 8)) << n;
    EXPECT_EQ(traffic.reductions, 0);
    // The corner at the origin has seven neighbours, all above it.
    const auto less = grid::rows_product_traffic(cube(3, n), corner);
    EXPECT_EQ(less.messages, 7);
    EXPECT_EQ(less.bytes, 24 * (3 * n * n + 3 * n + 1)) << n;
  }
}

// V-TRAFFIC.
TEST(BoxPartition, SumOfBoxes) {
  // A rank touches (n + 1)^3 nodes; a whole face goes to each of six neighbours.
  for (const std::int64_t n : {1, 2, 5, 16}) {
    const auto traffic = grid::box_sum_traffic(grid::LevelGrid(cube(3, n), centre), 4);
    EXPECT_EQ(traffic.neighbours, 6);
    EXPECT_EQ(traffic.messages, 6);
    EXPECT_EQ(traffic.bytes, 6 * 3 * 4 * (n + 1) * (n + 1)) << n;
    const auto less = grid::box_sum_traffic(grid::LevelGrid(cube(3, n), corner), 8);
    EXPECT_EQ(less.messages, 3);
    EXPECT_EQ(less.bytes, 3 * 3 * 8 * (n + 1) * (n + 1)) << n;
  }
}

TEST(BoxPartition, IterationWithJacobi) {
  const auto traffic =
      solver::iteration_traffic(cube(3, 5), centre, solver::PreconditionerKind::jacobi).total();
  EXPECT_EQ(traffic.bytes, 24 * (6 * 25 + 12 * 5 + 8));
  EXPECT_EQ(traffic.reductions, 3);
  EXPECT_EQ(traffic.reduced_bytes, 24);
}

TEST(BoxPartition, OfWhatMueluSendsNothingIsSaid) {
  const auto kind = solver::PreconditionerKind::multigrid;
  EXPECT_FALSE(solver::iteration_traffic(cube(3, 5), centre, kind).preconditioner.has_value());
}

TEST(BoxPartition, OneRankSendsNothing) {
  for (const auto kind :
       {solver::PreconditionerKind::jacobi, solver::PreconditionerKind::geometric_multigrid}) {
    const auto traffic = solver::iteration_traffic(cube(1, 40), 0, kind).total();
    EXPECT_EQ(traffic.messages, 0);
    EXPECT_EQ(traffic.bytes, 0);
  }
}

TEST(BoxPartition, ALevelBelowSendsAQuarter) {
  // Three levels of 3 x 3 x 3 boxes: 8, 4, 2 elements, the last one solved by factors.
  const grid::Partition partition = cube(3, 8);
  const multigrid::MultigridSettings settings;
  const auto levels =
      multigrid::plan_levels(grid::LevelGrid(partition, centre), {1.0, 1.0, 1.0}, settings);
  const auto cycle =
      *solver::iteration_traffic(partition, centre, solver::PreconditionerKind::geometric_multigrid)
           .preconditioner;
  ASSERT_TRUE(levels.back().is_direct);
  std::int64_t bytes = 0;
  const int degree = settings.smoother_degree;
  for (std::size_t n = 0; n < levels.size(); ++n) {
    const std::int64_t side = (8 >> n) + 1;
    const int sums = 1 + (n + 1 < levels.size() ? 2 * degree - 1 : 0);
    bytes += sums * 6 * 3 * 4 * side * side;
  }
  EXPECT_EQ(cycle.bytes, bytes);
  const std::int64_t coarsest = 3 * (8 >> (levels.size() - 1)) + 1;
  EXPECT_EQ(cycle.reductions, 1);
  EXPECT_EQ(cycle.reduced_bytes, 24 * coarsest * coarsest * coarsest);
}

}  // namespace
}  // namespace stroma::test
