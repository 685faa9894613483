// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// One grid of a hierarchy of coarser and coarser grids, dealt to the ranks as the finest one is.

#include <array>
#include <cstdint>
#include <vector>

#include "stroma/grid/Partition.hpp"

namespace stroma::grid {

/// A grid of nodes in the partition of the finest grid, seen from one rank: its box of touched
/// nodes, its neighbours, and how many elements each interval of the partition holds. Neighbouring
/// boxes share the layer of nodes between them.
///
/// Each interval is coarsened by itself, so that the cuts between ranks are nodes of every level:
/// two elements become one, and the last of an odd count stays as wide as it was. In plane strain
/// there is one layer of nodes in z, hence no element.
class LevelGrid {
 public:
  /// The finest level.
  LevelGrid(const Partition& partition, int rank);

  /// The next level. A direction that is not coarsened keeps its elements.
  LevelGrid coarsened(const std::array<bool, 3>& directions) const;

  /// Elements of all ranks along a direction.
  std::int64_t all_elements(int d) const;
  /// Nodes of all ranks.
  std::int64_t all_nodes() const;
  /// Nodes per direction that this rank touches.
  int nodes(int d) const;
  /// Number along a direction of the first of them.
  std::int64_t first_node(int d) const;
  /// Nodes per direction that this rank owns: the first ones. Those on an upper face that a
  /// neighbour shares are the neighbour's.
  int owned_nodes(int d) const { return nodes(d) - (upper_neighbour(d) >= 0 ? 1 : 0); }
  /// Rank beyond the lower or upper face, or -1.
  int lower_neighbour(int d) const;
  int upper_neighbour(int d) const;

 private:
  std::array<std::vector<std::int64_t>, 3> elements_;  // (direction, interval)
  std::array<int, 3> coordinate_;                      // this rank's interval per direction
  int stride(int d) const;
};

}  // namespace stroma::grid
