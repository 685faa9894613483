// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Who owns what: every element and node exactly once, in boxes, numbered without gaps.

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "stroma/base/Error.hpp"
#include "stroma/grid/Partition.hpp"

namespace stroma::grid {
namespace {

Grid grid_of(const Index3& elements) {
  Grid grid;
  grid.elements = elements;
  grid.spacing = {2.1, 1.0, 0.5};
  return grid;
}

std::array<std::vector<double>, 3> even_weights(const Grid& grid) {
  std::array<std::vector<double>, 3> weights;
  for (int d = 0; d < 3; ++d) weights[d].assign(static_cast<std::size_t>(grid.elements[d]), 1.0);
  return weights;
}

/// Grids with room for the ranks, long, flat and odd ones among them.
template <class Check>
void for_partitions(const Check& check) {
  for (const Index3& elements :
       {Index3{8, 8, 8}, Index3{5, 1, 3}, Index3{1, 1, 13}, Index3{7, 6, 1}})
    for (const int ranks : {1, 2, 3, 4, 6}) {
      const Grid grid = grid_of(elements);
      SCOPED_TRACE(testing::Message() << elements[0] << " x " << elements[1] << " x " << elements[2]
                                      << " elements, " << ranks << " ranks");
      bool room = false;
      for (int px = 1; px <= ranks; ++px)
        for (int py = 1; px * py <= ranks; ++py)
          if (ranks % (px * py) == 0 && px <= elements[0] && py <= elements[1] &&
              ranks / (px * py) <= elements[2])
            room = true;
      if (!room) {
        EXPECT_THROW(Partition::balanced(grid, ranks, even_weights(grid)), base::InputError);
        continue;
      }
      const Partition partition = Partition::balanced(grid, ranks, even_weights(grid));
      ASSERT_EQ(partition.ranks(), ranks);
      check(grid, partition);
    }
}

TEST(Partition, EveryElementIsOwnedOnce) {
  for_partitions([](const Grid& grid, const Partition& partition) {
    std::int64_t count = 0;
    for (int rank = 0; rank < partition.ranks(); ++rank) {
      EXPECT_GT(partition.elements(rank).count(), 0);
      count += partition.elements(rank).count();
      for_each_index(partition.elements(rank), [&](const Index3& element) {
        EXPECT_EQ(partition.owner_of_element(element), rank);
      });
    }
    EXPECT_EQ(count, grid.all_elements().count());
  });
}

TEST(Partition, EveryNodeIsOwnedOnceAndNumberedWithoutGaps) {
  for_partitions([](const Grid& grid, const Partition& partition) {
    std::set<std::int64_t> numbers;
    for (int rank = 0; rank < partition.ranks(); ++rank) {
      const Box owned = partition.owned_nodes(rank);
      std::int64_t expected = partition.first_node(rank);
      for_each_index(owned, [&](const Index3& node) {
        EXPECT_EQ(partition.owner_of_node(node), rank);
        EXPECT_EQ(partition.node_number(node), expected++);
        numbers.insert(partition.node_number(node));
      });
    }
    const std::int64_t nodes = grid.all_nodes().count();
    ASSERT_EQ(static_cast<std::int64_t>(numbers.size()), nodes);
    EXPECT_EQ(*numbers.begin(), 0);
    EXPECT_EQ(*numbers.rbegin(), nodes - 1);
  });
}

TEST(Partition, ARankTouchesTheNodesOfItsElementsAndNoOthers) {
  for_partitions([](const Grid&, const Partition& partition) {
    for (int rank = 0; rank < partition.ranks(); ++rank) {
      std::set<Index3> corners;
      for_each_index(partition.elements(rank), [&](const Index3& e) {
        for (int a = 0; a < 8; ++a)
          corners.insert({e[0] + (a & 1), e[1] + (a >> 1 & 1), e[2] + (a >> 2)});
      });
      const Box touched = partition.touched_nodes(rank);
      EXPECT_EQ(static_cast<std::int64_t>(corners.size()), touched.count());
      for (const Index3& corner : corners) EXPECT_TRUE(touched.contains(corner));
      // What a rank owns, it touches.
      for_each_index(partition.owned_nodes(rank),
                     [&](const Index3& node) { EXPECT_TRUE(touched.contains(node)); });
    }
  });
}

// Plane strain: one layer of nodes through z, which all elements touch.
TEST(Partition, AFlatGridHasOneLayerOfNodes) {
  Grid grid = grid_of({7, 6, 1});
  grid.flat = true;
  EXPECT_EQ(grid.all_nodes().count(), 8 * 7);
  for (const int ranks : {1, 2, 4}) {
    const Partition partition = Partition::balanced(grid, ranks, even_weights(grid));
    std::set<std::int64_t> numbers;
    for (int rank = 0; rank < ranks; ++rank) {
      EXPECT_EQ(partition.touched_nodes(rank).extent(2), 1);
      for_each_index(partition.owned_nodes(rank), [&](const Index3& node) {
        EXPECT_EQ(partition.owner_of_node(node), rank);
        numbers.insert(partition.node_number(node));
      });
    }
    EXPECT_EQ(numbers.size(), 56u);
    EXPECT_EQ(*numbers.rbegin(), 55);
  }
}

TEST(Partition, CutsBalanceTheWeights) {
  // All weight lies in the first quarter of x: half of it must lie on each side of the cut.
  const Grid grid = grid_of({40, 2, 2});
  auto weights = even_weights(grid);
  for (std::size_t layer = 0; layer < 40; ++layer) weights[0][layer] = layer < 10 ? 100.0 : 0.0;
  const Partition partition = Partition::balanced(grid, 2, weights);
  ASSERT_EQ(partition.intervals(0), 2);
  EXPECT_EQ(partition.elements(0).end[0], 5);
  // No cut can be better than half the heaviest layer.
  for (std::size_t layer = 0; layer < 40; ++layer) weights[0][layer] = 1.0 + 3.0 * (layer % 5 == 0);
  const Partition uneven = Partition::balanced(grid, 4, weights);
  const double total = std::accumulate(weights[0].begin(), weights[0].end(), 0.0);
  if (uneven.intervals(0) == 4)
    for (int rank = 0; rank < 4; ++rank) {
      double weight = 0.0;
      for (auto x = uneven.elements(rank).begin[0]; x < uneven.elements(rank).end[0]; ++x)
        weight += weights[0][static_cast<std::size_t>(x)];
      EXPECT_NEAR(weight, total / 4, 4.0);
    }
  else
    ADD_FAILURE() << "a long grid must be cut along its length";
}

TEST(Partition, TooManyRanksAreAnInputError) {
  const Grid grid = grid_of({1, 2, 1});
  EXPECT_NO_THROW(Partition::balanced(grid, 2, even_weights(grid)));
  EXPECT_THROW(Partition::balanced(grid, 3, even_weights(grid)), base::InputError);
}

}  // namespace
}  // namespace stroma::grid
