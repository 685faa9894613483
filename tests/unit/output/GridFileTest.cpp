// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// grid.e, read back with the Exodus library: geometry, numbers, inactive elements, shared nodes.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "TemporaryFolder.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/GridFile.hpp"
#include "support/ExodusReader.hpp"

namespace stroma {
namespace {

/// 6 x 4 x 3 elements, dealt to ranks in slabs along x (4 ranks: 2, 2, 2 and none; 2 ranks: 3 and
/// 3).
output::GridPart slab(const base::Communicator& world) {
  const std::int64_t thickness = (world.size() == 1) ? 6 : (world.size() == 2) ? 3 : 2;
  output::GridPart part;
  part.elements = {6, 4, 3};
  part.first_element = {std::min<std::int64_t>(world.rank() * thickness, 6), 0, 0};
  part.element_count = {std::min(thickness, 6 - part.first_element[0]), 4, 3};
  part.origin = {-1.0, 0.5, 10.0};
  part.spacing = {2.0, 1.0, 0.5};
  return part;
}

/// Inactive: all elements of the plane j = 0, and with it the nodes of that side.
std::vector<std::uint8_t> without_first_plane(const output::GridPart& part) {
  std::vector<std::uint8_t> active;
  for (std::int64_t k = 0; k < part.element_count[2]; ++k)
    for (std::int64_t j = 0; j < part.element_count[1]; ++j)
      for (std::int64_t i = 0; i < part.element_count[0]; ++i) active.push_back(j == 0 ? 0 : 1);
  return active;
}

std::string own_file(const std::string& path) {
  const auto world = base::Communicator::world();
  return output::spread_file_name(path, world.size(), world.rank());
}

/// i, j, k of a node, from its number in the file.
std::array<std::int64_t, 3> node_place(std::int64_t number) {
  const std::int64_t n = number - 1;
  return {n % 7, n / 7 % 5, n / 35};
}

TEST(GridFile, HoldsElementsAndNodesInTheNumbersOfTheWholeGrid) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const output::GridPart part = slab(world);
  const output::GridFile file(world, folder / "grid.e", part, {"displacement", "residual"},
                              {"gel", "0.1.0", ""});
  const ExodusReader reader(own_file(folder / "grid.e"));
  const std::int64_t width = part.element_count[0];
  EXPECT_EQ(reader.counts.num_elem, width * 12);
  EXPECT_EQ(reader.counts.num_nodes, width == 0 ? 0 : (width + 1) * 20);
  EXPECT_EQ(reader.block_names(), std::vector<std::string>{"grid"});

  const auto x = reader.coordinates();
  const auto node = reader.numbers(EX_NODE_MAP);
  for (std::size_t n = 0; n < node.size(); ++n) {
    const auto place = node_place(node[n]);
    for (std::size_t d = 0; d < 3; ++d) {
      EXPECT_DOUBLE_EQ(x[d][n], part.origin[d] + part.spacing[d] * static_cast<double>(place[d]));
    }
  }
  EXPECT_EQ(std::set<std::int64_t>(node.begin(), node.end()).size(), node.size());

  // The corners of HEX8: the lower face counterclockwise, then the upper one.
  const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                            {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const auto element = reader.numbers(EX_ELEM_MAP);
  const auto connectivity = reader.connectivity(1);
  ASSERT_EQ(connectivity.size(), 8 * element.size());
  for (std::size_t e = 0; e < element.size(); ++e) {
    const std::int64_t n = element[e] - 1;
    const std::array<std::int64_t, 3> place = {n % 6, n / 6 % 4, n / 24};
    EXPECT_GE(place[0], part.first_element[0]);
    EXPECT_LT(place[0], part.first_element[0] + width);
    for (std::size_t c = 0; c < 8; ++c) {
      const auto at = node_place(node[static_cast<std::size_t>(connectivity[8 * e + c] - 1)]);
      for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(at[d], place[d] + corner[c][d]);
    }
  }
  if (!element.empty()) {
    EXPECT_EQ(reader.block(1).type, "HEX8");
  }
}

TEST(GridFile, LeavesOutInactiveElementsAndNodesThatNobodyUses) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  output::GridPart part = slab(world);
  const auto active = without_first_plane(part);
  part.active = active.data();
  output::GridFile file(world, folder / "grid.e", part, {"displacement", "residual"},
                        {"gel", "0.1.0", ""});

  // Nodal values that tell the node's place in the whole grid.
  std::vector<double> displacement, residual;
  if (part.element_count[0] > 0) {
    for (std::int64_t k = 0; k <= 3; ++k)
      for (std::int64_t j = 0; j <= 4; ++j)
        for (std::int64_t i = 0; i <= part.element_count[0]; ++i)
          for (int d = 0; d < 3; ++d) {
            const std::int64_t number = 1 + part.first_element[0] + i + 7 * (j + 5 * k);
            displacement.push_back(static_cast<double>(number) + 0.1 * d);
            residual.push_back(-static_cast<double>(number) - 0.1 * d);
          }
  }
  const std::vector<output::NodalVector> vectors{{"displacement", "um", displacement.data()},
                                                 {"residual", "pN", residual.data()}};
  file.write(0.5, vectors);
  file.write(1.0, vectors);

  const ExodusReader reader(own_file(folder / "grid.e"));
  const std::int64_t width = part.element_count[0];
  EXPECT_EQ(reader.counts.num_elem, width * 9);
  EXPECT_EQ(reader.counts.num_nodes, width == 0 ? 0 : (width + 1) * 16);
  EXPECT_EQ(reader.steps(), 2);
  EXPECT_EQ(reader.time(2), 1.0);
  if (width == 0) return;
  EXPECT_EQ(reader.variables(EX_NODAL),
            (std::vector<std::string>{"displacement_x", "displacement_y", "displacement_z",
                                      "residual_x", "residual_y", "residual_z"}));
  const auto node = reader.numbers(EX_NODE_MAP);
  const auto u_y = reader.variable(1, EX_NODAL, "displacement_y", 1, reader.counts.num_nodes);
  const auto r_z = reader.variable(2, EX_NODAL, "residual_z", 1, reader.counts.num_nodes);
  for (std::size_t n = 0; n < node.size(); ++n) {
    EXPECT_GE(node_place(node[n])[1], 1);
    EXPECT_EQ(u_y[n], static_cast<double>(node[n]) + 0.1 * 1);
    EXPECT_EQ(r_z[n], -static_cast<double>(node[n]) - 0.1 * 2);
  }
}

// The communication maps of two neighbours name the same nodes of the whole grid, and no others.
TEST(GridFile, SpreadFilesAgreeOnTheNodesTheyShare) {
  const auto world = base::Communicator::world();
  if (world.size() == 1) GTEST_SKIP() << "one rank writes one plain file";
  const TemporaryFolder folder;
  output::GridPart part = slab(world);
  const auto active = without_first_plane(part);
  part.active = active.data();
  {
    const output::GridFile file(world, folder / "grid.e", part, {"displacement", "residual"},
                                {"gel", "0.1.0", ""});
  }
  world.barrier();

  std::map<int, std::set<std::int64_t>> nodes_of;                   // rank -> global numbers
  std::map<std::pair<int, int>, std::set<std::int64_t>> shared_of;  // (rank, with rank) -> the same
  std::int64_t elements = 0;
  std::set<std::int64_t> all;
  for (int rank = 0; rank < world.size(); ++rank) {
    const ExodusReader reader(output::spread_file_name(folder / "grid.e", world.size(), rank));
    const auto number = reader.numbers(EX_NODE_MAP);
    nodes_of[rank] = {number.begin(), number.end()};
    all.insert(number.begin(), number.end());
    elements += reader.counts.num_elem;

    std::int64_t nodes_all = 0, elements_all = 0, blocks = 0, sets = 0, sides = 0;
    ASSERT_GE(ex_get_init_global(reader.id, &nodes_all, &elements_all, &blocks, &sets, &sides), 0);
    EXPECT_EQ(nodes_all, 7 * 4 * 4);
    EXPECT_EQ(elements_all, 6 * 3 * 3);
    std::int64_t inside = 0, border = 0, outside = 0, inside_e = 0, border_e = 0, maps = 0,
                 maps_e = 0;
    ASSERT_GE(ex_get_loadbal_param(reader.id, &inside, &border, &outside, &inside_e, &border_e,
                                   &maps, &maps_e, rank),
              0);
    EXPECT_EQ(inside + border, reader.counts.num_nodes);
    EXPECT_EQ(inside_e + border_e, reader.counts.num_elem);
    std::vector<std::int64_t> ids(static_cast<std::size_t>(maps)), sizes = ids;
    if (maps > 0) {
      ASSERT_GE(ex_get_cmap_params(reader.id, ids.data(), sizes.data(), nullptr, nullptr, rank), 0);
      std::vector<std::int64_t> in(static_cast<std::size_t>(inside)),
          on(static_cast<std::size_t>(border));
      ASSERT_GE(ex_get_processor_node_maps(reader.id, in.data(), on.data(), nullptr, rank), 0);
      std::set<std::int64_t> both(in.begin(), in.end());
      both.insert(on.begin(), on.end());
      EXPECT_EQ(static_cast<std::int64_t>(both.size()), reader.counts.num_nodes);
    }
    for (std::size_t m = 0; m < ids.size(); ++m) {
      std::vector<std::int64_t> local(static_cast<std::size_t>(sizes[m])), ranks = local;
      ASSERT_GE(ex_get_node_cmap(reader.id, ids[m], local.data(), ranks.data(), rank), 0);
      for (std::size_t n = 0; n < local.size(); ++n) {
        shared_of[{rank, static_cast<int>(ranks[n])}].insert(
            number[static_cast<std::size_t>(local[n] - 1)]);
      }
    }
  }
  EXPECT_EQ(elements, 6 * 3 * 3);
  EXPECT_EQ(all.size(), 7U * 4U * 4U);
  for (int a = 0; a < world.size(); ++a) {
    for (int b = 0; b < world.size(); ++b) {
      if (a == b) continue;
      std::set<std::int64_t> common;
      std::set_intersection(nodes_of[a].begin(), nodes_of[a].end(), nodes_of[b].begin(),
                            nodes_of[b].end(), std::inserter(common, common.end()));
      EXPECT_EQ((shared_of[{a, b}]), common) << "ranks " << a << " and " << b;
    }
  }
}

TEST(GridFile, CannotBeCreatedIsARunErrorOnEveryRank) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const std::string path = folder / "missing/grid.e";
  const std::string message = message_of<base::RunError>([&] {
    output::GridFile(world, path, slab(world), {"displacement"}, {"gel", "0.1.0", ""});
  });
  EXPECT_EQ(message.rfind("cannot create '" + path, 0), 0U) << message;
}

}  // namespace
}  // namespace stroma
