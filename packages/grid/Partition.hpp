// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Who owns what: elements and nodes of the grid dealt to the ranks in boxes.

#include <array>
#include <cstdint>
#include <vector>

#include "stroma/grid/Grid.hpp"

namespace stroma::grid {

/// A tensor-product partition: each direction is cut into intervals, and rank r gets the box of
/// intervals (r mod px, r / px mod py, r / (px py)). Everything about it follows by arithmetic from
/// the three lists of cuts, so that no rank stores anything of the size of the grid.
///
/// A node belongs to the rank of the first element that sees it by the same number (of the last
/// element, at the upper faces); a rank touches all nodes that its elements see. Nodes are numbered
/// rank by rank, and lexicographically (x fastest) inside the box of one rank, so that each rank
/// owns a contiguous range.
class Partition {
 public:
  /// \param grid  the grid to deal out
  /// \param cuts  per direction, the first element of each interval, and the number of elements
  Partition(const Grid& grid, std::array<std::vector<std::int64_t>, 3> cuts);

  /// Cuts so that the ranks get about equal weight and the boxes are compact.
  ///
  /// \param grid     the grid to deal out
  /// \param ranks    how many, > 0
  /// \param weights  per direction, the weight (particles, say) of each layer of elements
  /// \throws base::InputError when the grid cannot be dealt to so many ranks
  static Partition balanced(const Grid& grid, int ranks,
                            const std::array<std::vector<double>, 3>& weights);

  const Grid& grid() const { return grid_; }
  int ranks() const { return intervals(0) * intervals(1) * intervals(2); }
  /// Ranks per direction.
  int intervals(int d) const { return static_cast<int>(cuts_[d].size()) - 1; }

  /// The first element of each interval, and the number of elements, along d.
  const std::vector<std::int64_t>& cuts(int d) const { return cuts_[d]; }
  Box elements(int rank) const;
  Box owned_nodes(int rank) const;
  Box touched_nodes(int rank) const;

  int owner_of_element(const Index3& element) const;
  int owner_of_node(const Index3& node) const;

  /// Number of a node in the rank-by-rank numbering.
  std::int64_t node_number(const Index3& node) const;
  /// First node number of a rank.
  std::int64_t first_node(int rank) const { return first_node_[static_cast<std::size_t>(rank)]; }

 private:
  Index3 coordinates(int rank) const;
  int interval_of(int d, std::int64_t element) const;

  Grid grid_;
  std::array<std::vector<std::int64_t>, 3> cuts_;
  std::vector<std::int64_t> first_node_;  // of each rank
};

}  // namespace stroma::grid
