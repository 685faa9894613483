// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Values at the nodes of a rank's box, laid out for loops along lines of nodes.

#include <array>
#include <string>

#include "stroma/grid/LevelGrid.hpp"
#include "stroma/grid/Types.hpp"

namespace stroma::grid {

/// Three components at each node of a rank's box. A line of nodes along x holds its components one
/// after the other, each filled up with zeros to a multiple of eight nodes, with one more before
/// and behind, so that a loop may take eight nodes at a time and look one beyond. Copies share
/// their values, as Kokkos views do.
///
/// Where ranks share nodes, each holds the same value ("consistent"), or each a part of a sum
/// ("partial") until BoxExchange::sum() has added the parts up.
template <class T>
struct NodeField {
  int nodes[3] = {0, 0, 0};
  int pitch = 0;  ///< from a component of a line to the next
  Kokkos::View<T*, Device> values;

  NodeField() = default;
  NodeField(const std::string& name, const LevelGrid& grid) {
    for (int d = 0; d < 3; ++d) nodes[d] = grid.nodes(d);
    pitch = (nodes[0] + 7) / 8 * 8 + 2;
    values = Kokkos::View<T*, Device>(name, 3 * static_cast<std::size_t>(lines()) * pitch);
  }

  int lines() const { return nodes[1] * nodes[2]; }
  /// Component c of line j + nodes[1] k; its nodes are [0, nodes[0]).
  KOKKOS_INLINE_FUNCTION T* line(int c, int number) const {
    return values.data() + (static_cast<std::size_t>(number) * 3 + c) * pitch + 1;
  }
  void zero() const { Kokkos::deep_copy(values, T(0)); }
};

/// Runs f(line, j, k) for every line of nodes of a box.
template <class F>
void for_each_line(const char* name, const int nodes[3], const F& f) {
  const int lines_j = nodes[1];
  Kokkos::parallel_for(
      name,
      Kokkos::RangePolicy<ExecutionSpace, Kokkos::Schedule<Kokkos::Static>>(0, lines_j * nodes[2]),
      KOKKOS_LAMBDA(const int line) { f(line, line % lines_j, line / lines_j); });
}

}  // namespace stroma::grid
