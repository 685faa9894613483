// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Interpolation between two levels of a hierarchy of grids, and its transpose.

#include <array>
#include <vector>

#include "stroma/grid/NodeField.hpp"

namespace stroma::multigrid {

/// How the nodes of a rank's box along one direction lie among those of the next coarser level:
/// every second is a coarse node, and so is the last; those between are midway, in logical space,
/// between the coarse nodes below and above. A direction that is not coarsened keeps its nodes.
struct LineTransfer {
  LineTransfer(int fine_nodes, bool is_coarsened);

  int fine = 0, coarse = 0;           ///< nodes
  std::vector<int> at;                ///< (coarse node) the fine node at it
  std::vector<int> below;             ///< (fine node) the coarse node at it, or below it
  std::vector<std::uint8_t> between;  ///< (fine node) whether it is midway to the next one

  /// Calls visit(coarse node, weight) for the coarse nodes that a fine one is interpolated from.
  template <class Visit>
  void for_each_parent(int fine_node, const Visit& visit) const {
    const auto n = static_cast<std::size_t>(fine_node);
    visit(below[n], between[n] ? 0.5f : 1.0f);
    if (between[n]) visit(below[n] + 1, 0.5f);
  }
  /// Calls visit(fine node, weight) for the fine nodes that a coarse one is passed on to.
  template <class Visit>
  void for_each_child(int coarse_node, const Visit& visit) const {
    const int middle = at[static_cast<std::size_t>(coarse_node)];
    if (middle > 0 && between[static_cast<std::size_t>(middle - 1)]) visit(middle - 1, 0.5f);
    visit(middle, 1.0f);
    if (middle + 1 < fine && between[static_cast<std::size_t>(middle + 1)]) visit(middle + 1, 0.5f);
  }
};

/// Trilinear interpolation P between the nodes of two levels of one rank, whose cuts are nodes of
/// both, so that nothing is exchanged.
class LevelTransfer {
 public:
  LevelTransfer(const grid::LevelGrid& fine, const std::array<bool, 3>& directions);

  const LineTransfer& along(int d) const { return along_[static_cast<std::size_t>(d)]; }

  /// fine += P coarse, both consistent.
  void add_interpolated(const grid::NodeField<float>& coarse,
                        const grid::NodeField<float>& fine) const;
  /// partial coarse = P^T fine, for a partial fine.
  void restrict_to(const grid::NodeField<float>& fine, const grid::NodeField<float>& coarse) const;

 private:
  std::array<LineTransfer, 3> along_;
};

}  // namespace stroma::multigrid
