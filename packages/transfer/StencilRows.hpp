// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Where the blocks of the tangent go when it is stored as a stencil.

#include <Kokkos_Core.hpp>
#include <cstddef>
#include <cstdint>

namespace stroma::transfer {

/// Layout of the upper half of a symmetric matrix of 3 x 3 blocks on the 3 x 3 x 3 stencil of a box
/// of nodes. Block s = (dx + 1) + 3 (dy + 1) + 9 (dz + 1) of a node couples it to its neighbour at
/// (dx, dy, dz); the half is s = 13 (the node itself) to 26, for the others are transposes of
/// neighbours'.
///
/// Eight nodes in a row along x are a tile, which holds the 126 entries 9 (s - 13) + 3 i + k one
/// after the other, each for its eight nodes. A product then reads the memory from its first byte
/// to its last, eight nodes at a time. The last tile of a line is filled up with zeros.
struct StencilLayout {
  static constexpr int own = 13;          ///< the block of the node itself
  static constexpr int entries = 9 * 14;  ///< floats a node
  static constexpr int tile = 8;          ///< nodes

  int nodes[3] = {0, 0, 0};

  KOKKOS_INLINE_FUNCTION int tiles() const { return (nodes[0] + tile - 1) / tile; }
  KOKKOS_INLINE_FUNCTION int lines() const { return nodes[1] * nodes[2]; }
  /// First float of tile t of line j + nodes[1] k.
  KOKKOS_INLINE_FUNCTION std::size_t first(int line, int t) const {
    return (static_cast<std::size_t>(line) * static_cast<std::size_t>(tiles()) +
            static_cast<std::size_t>(t)) *
           (entries * tile);
  }
  /// Entry of node i of a line.
  KOKKOS_INLINE_FUNCTION std::size_t place(int line, int entry, int i) const {
    return first(line, i / tile) + static_cast<std::size_t>(entry * tile + i % tile);
  }
  std::size_t count() const { return first(lines(), 0); }
};

/// Adds an element's blocks to a stencil; a rank adds those of its own elements only. Entries in
/// prescribed rows and columns are left out.
template <class Device>
struct StencilRows {
  using Real = float;

  StencilLayout layout;
  Kokkos::View<float*, Device> values;                ///< added to
  Kokkos::View<const std::uint8_t*, Device> held_of;  ///< (node) bit c: component c is prescribed

  KOKKOS_INLINE_FUNCTION int held(int node) const { return held_of(node); }

  /// Adds an element's blocks K(i, k, b) to the rows of one of its nodes, b being the element's
  /// nodes and s(b) their places in the node's stencil.
  template <int Nodes, int Padded>
  KOKKOS_INLINE_FUNCTION void add(int node, const float (&K)[3][3][Padded],
                                  const int (&s)[Nodes]) const {
    constexpr int tile = StencilLayout::tile;
    float* const first = &values(layout.place(node / layout.nodes[0], 0, node % layout.nodes[0]));
    for (int b = 0; b < Nodes; ++b) {
      if (s[b] < StencilLayout::own) continue;
      float* const block = first + 9 * tile * (s[b] - StencilLayout::own);
      const bool is_own = s[b] == StencilLayout::own;  // stored in full: symmetric to the last bit
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          block[tile * (3 * i + k)] += is_own && i > k ? K[k][i][b] : K[i][k][b];
    }
  }

  /// Multiplies all that was added so far.
  void scale(float factor) const {
    const auto all = values;
    Kokkos::parallel_for(
        "scale rows", Kokkos::RangePolicy<typename Device::execution_space>(0, values.extent(0)),
        KOKKOS_LAMBDA(const std::size_t n) { all(n) *= factor; });
  }
  /// Adds to the diagonal entry of a component of a node, if it is not prescribed.
  KOKKOS_INLINE_FUNCTION void add_to_diagonal(int node, int component, double value) const {
    if (held_of(node) >> component & 1) return;
    values(layout.place(node / layout.nodes[0], 4 * component, node % layout.nodes[0])) +=
        static_cast<float>(value);
  }
};

}  // namespace stroma::transfer
