// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The exchange of nodal values between neighbours. Run on 1, 2 and 4 ranks.

#include <gtest/gtest.h>

#include "stroma/grid/Halo.hpp"

namespace stroma::grid {
namespace {

/// A value that tells every unknown of the grid from every other.
double tag(const Index3& node, int c) {
  return 1.0 + static_cast<double>(c) + 10.0 * static_cast<double>(node[0]) +
         1e3 * static_cast<double>(node[1]) + 1e5 * static_cast<double>(node[2]);
}

template <class Check>
void for_grids(const Check& check) {
  const auto world = base::Communicator::world();
  for (const Index3& elements :
       {Index3{4, 4, 4}, Index3{5, 1, 3}, Index3{1, 1, 9}, Index3{6, 5, 1}}) {
    SCOPED_TRACE(testing::Message() << elements[0] << " x " << elements[1] << " x " << elements[2]);
    Grid grid;
    grid.elements = elements;
    std::array<std::vector<double>, 3> weights;
    for (int d = 0; d < 3; ++d) weights[d].assign(static_cast<std::size_t>(elements[d]), 1.0);
    check(world, Halo(world, Partition::balanced(grid, world.size(), weights)));
  }
}

TEST(Halo, GatherBringsTheOwnersValues) {
  for_grids([](const base::Communicator& world, const Halo& halo) {
    const Box owned_nodes = halo.partition().owned_nodes(world.rank());
    const Box touched_nodes = halo.partition().touched_nodes(world.rank());
    Vector owned(halo.owned_map());
    {
      const auto values = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for_each_index(owned_nodes, [&](const Index3& node) {
        for (int c = 0; c < 3; ++c) values(3 * owned_nodes.local(node) + c, 0) = tag(node, c);
      });
    }
    const auto gathered =
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), halo.gather(owned));
    ASSERT_EQ(static_cast<std::int64_t>(gathered.extent(0)), touched_nodes.count());
    for_each_index(touched_nodes, [&](const Index3& node) {
      for (int c = 0; c < 3; ++c) EXPECT_EQ(gathered(touched_nodes.local(node), c), tag(node, c));
    });
  });
}

// Each element adds 1 to its corners: a node must end with the number of its elements, of all
// ranks.
TEST(Halo, SumToOwnerCompletesTheContributions) {
  for_grids([](const base::Communicator& world, const Halo& halo) {
    const Box touched = halo.partition().touched_nodes(world.rank());
    for (int repeat = 0; repeat < 2; ++repeat) {  // the buffer must start from zero each time
      const NodeView contributions = halo.contributions();
      const auto host = Kokkos::create_mirror_view(contributions);
      Kokkos::deep_copy(host, contributions);
      for_each_index(halo.partition().elements(world.rank()), [&](const Index3& e) {
        for (int a = 0; a < 8; ++a)
          for (int c = 0; c < 3; ++c)
            host(touched.local({e[0] + (a & 1), e[1] + (a >> 1 & 1), e[2] + (a >> 2)}), c) +=
                c + 1.0;
      });
      Kokkos::deep_copy(contributions, host);
      Vector owned(halo.owned_map());
      halo.sum_to_owner(owned);
      const auto values = owned.getLocalViewHost(Tpetra::Access::ReadOnly);
      const Box owned_nodes = halo.partition().owned_nodes(world.rank());
      const Grid& grid = halo.partition().grid();
      for_each_index(owned_nodes, [&](const Index3& node) {
        double elements = 1.0;
        for (int d = 0; d < 3; ++d)
          elements *= (node[d] > 0 ? 1 : 0) + (node[d] < grid.elements[d] ? 1 : 0);
        for (int c = 0; c < 3; ++c)
          EXPECT_EQ(values(3 * owned_nodes.local(node) + c, 0), (c + 1.0) * elements);
      });
    }
  });
}

TEST(Halo, MapsCoverEveryUnknownOnce) {
  for_grids([](const base::Communicator&, const Halo& halo) {
    const auto unknowns = static_cast<std::size_t>(3 * halo.partition().grid().all_nodes().count());
    EXPECT_EQ(halo.owned_map()->getGlobalNumElements(), unknowns);
    EXPECT_TRUE(halo.owned_map()->isOneToOne());
    EXPECT_TRUE(halo.owned_map()->isContiguous());
  });
}

}  // namespace
}  // namespace stroma::grid
