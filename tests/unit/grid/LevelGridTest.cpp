// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Levels of coarser grids in one partition, and sums at the nodes that ranks share.

#include <gtest/gtest.h>

#include "stroma/grid/BoxExchange.hpp"
#include "stroma/grid/LevelGrid.hpp"
#include "support/World.hpp"

namespace stroma::grid {
namespace {

Partition partition(const Index3& elements, bool flat) {
  Grid grid;
  grid.elements = elements;
  grid.flat = flat;
  std::array<std::vector<double>, 3> weights;
  for (std::size_t d = 0; d < 3; ++d) weights[d].assign(static_cast<std::size_t>(elements[d]), 1.0);
  return Partition::balanced(grid, world().size(), weights);
}

TEST(LevelGrid, TheFinestIsThePartition) {
  const Partition boxes = partition({13, 8, 5}, false);
  const LevelGrid level(boxes, world().rank());
  const Box touched = boxes.touched_nodes(world().rank()),
            owned = boxes.owned_nodes(world().rank());
  for (int d = 0; d < 3; ++d) {
    EXPECT_EQ(level.nodes(d), touched.extent(d));
    EXPECT_EQ(level.first_node(d), touched.begin[d]);
    EXPECT_EQ(level.owned_nodes(d), owned.extent(d));
  }
  EXPECT_EQ(level.all_nodes(), 14 * 9 * 6);
}

// Each interval by itself: two elements become one, the last of an odd count stays.
TEST(LevelGrid, OddCountsAreCoarsenedUnevenly) {
  Grid grid;
  grid.elements = {13, 8, 5};
  const LevelGrid one(Partition(grid, {{{0, 13}, {0, 8}, {0, 5}}}), 0);
  const LevelGrid next = one.coarsened({true, true, false});
  EXPECT_EQ(next.all_elements(0), 7);
  EXPECT_EQ(next.all_elements(1), 4);
  EXPECT_EQ(next.all_elements(2), 5);
  const LevelGrid cut =
      LevelGrid(Partition(grid, {{{0, 3, 13}, {0, 8}, {0, 5}}}), 1).coarsened({true, true, true});
  EXPECT_EQ(cut.all_elements(0), 2 + 5);
  EXPECT_EQ(cut.first_node(0), 2);
  EXPECT_EQ(cut.lower_neighbour(0), 0);
  EXPECT_EQ(cut.upper_neighbour(0), -1);
}

// Every rank adds one at each node that it touches: the sum is how many touch it, and the owners'
// nodes are all nodes once.
TEST(BoxExchange, SumsOverAllThatShareANode) {
  for (const bool flat : {false, true}) {
    const Partition boxes = partition(flat ? Index3{9, 8, 1} : Index3{9, 8, 7}, flat);
    const BoxExchange exchange(world(), LevelGrid(boxes, world().rank()));
    const NodeField<double> ones("ones", exchange.grid());
    const Box touched = boxes.touched_nodes(world().rank());
    for (int line = 0; line < ones.lines(); ++line)
      for (int c = 0; c < 3; ++c)
        for (int i = 0; i < ones.nodes[0]; ++i) ones.line(c, line)[i] = c + 1;
    exchange.sum(ones);
    for_each_index(touched, [&](const Index3& node) {
      int touching = 0;
      for (int rank = 0; rank < world().size(); ++rank)
        touching += boxes.touched_nodes(rank).contains(node) ? 1 : 0;
      const int line = static_cast<int>((node[1] - touched.begin[1]) +
                                        ones.nodes[1] * (node[2] - touched.begin[2]));
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(ones.line(c, line)[node[0] - touched.begin[0]], touching * (c + 1));
    });
    const double nodes = exchange.owned_sum([](int, int n) { return n; });
    EXPECT_EQ(nodes, static_cast<double>(boxes.grid().all_nodes().count()));
  }
}

}  // namespace
}  // namespace stroma::grid
