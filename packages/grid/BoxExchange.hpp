// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Sums over the ranks at the nodes that they share, for one level of a hierarchy of grids.

#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/grid/NodeField.hpp"

namespace stroma::grid {

/// Adds up what neighbours hold at the layers of nodes between their boxes: along x, then y, then
/// z, so that edges and corners are complete after three exchanges with at most two neighbours
/// each. Both sides add the same two numbers, so copies of a node stay equal bit for bit.
class BoxExchange {
 public:
  BoxExchange(const base::Communicator& communicator, const LevelGrid& grid);

  /// partial -> consistent. Collective.
  void sum(const NodeField<float>& field) const { sum_of(field); }
  void sum(const NodeField<double>& field) const { sum_of(field); }

  /// Sum over the nodes that this rank owns, then over the ranks, of one number per line:
  /// term(line, owned nodes of the line). Collective.
  template <class F>
  double owned_sum(const F& term) const {
    double sum = 0.0;
    for (int k = 0; k < grid_.owned_nodes(2); ++k)
      for (int j = 0; j < grid_.owned_nodes(1); ++j)
        sum += term(j + grid_.nodes(1) * k, grid_.owned_nodes(0));
    return communicator_.sum(sum);
  }

  const LevelGrid& grid() const { return grid_; }
  const base::Communicator& communicator() const { return communicator_; }

 private:
  template <class T>
  void sum_of(const NodeField<T>& field) const;

  base::Communicator communicator_;
  LevelGrid grid_;
};

}  // namespace stroma::grid
