#pragma once

/// \file
/// Where the blocks of the tangent go when it is stored as a stencil.

#include <Kokkos_Core.hpp>
#include <cstddef>
#include <cstdint>

namespace stroma::transfer {

/// The upper half of a symmetric matrix of 3 x 3 blocks on the 3 x 3 x 3 stencil of a box of nodes.
/// Block s = (dx + 1) + 3 (dy + 1) + 9 (dz + 1) of a node couples it to its neighbour at (dx, dy,
/// dz); the half is s = 13 (the node itself) to 26, for the others are transposes of neighbours'.
///
/// A line of nodes along x is stored together: 126 rows, one for each entry 9 (s - 13) + 3 i + k,
/// of as many floats as the line has nodes. What runs along the line then reads the memory in
/// order, and vectorises over its nodes.
struct StencilLines {
  static constexpr int half = 13;         ///< the block of the node itself
  static constexpr int entries = 9 * 14;  ///< floats a node
  int nodes[3] = {0, 0, 0};

  /// First float of a row: of line j + nodes[1] k, entry 9 (s - 13) + 3 i + k.
  KOKKOS_INLINE_FUNCTION std::size_t row(int line, int entry) const {
    return (static_cast<std::size_t>(line) * entries + static_cast<std::size_t>(entry)) *
           static_cast<std::size_t>(nodes[0]);
  }
  int lines() const { return nodes[1] * nodes[2]; }
  std::size_t count() const { return row(lines(), 0); }
};

/// Adds an element's blocks to a stencil; a rank adds those of its own elements only. Entries in
/// prescribed rows and columns are left out.
template <class Device>
struct StencilRows {
  using Scalar = float;

  StencilLines lines;
  Kokkos::View<float*, Device> values;                ///< added to
  Kokkos::View<const std::uint8_t*, Device> held_of;  ///< (node) bit c: component c is prescribed

  KOKKOS_INLINE_FUNCTION int held(int node) const { return held_of(node); }

  /// Adds an element's blocks K(i, k, b) to the rows of one of its nodes, b being the element's
  /// nodes and s(b) their places in the node's stencil.
  template <int Nodes, class Real>
  KOKKOS_INLINE_FUNCTION void add(int node, const Real K[3][3][Nodes], const int s[Nodes]) const {
    const std::size_t pitch = static_cast<std::size_t>(lines.nodes[0]);
    float* const first = &values(lines.row(node / lines.nodes[0], 0)) + node % lines.nodes[0];
    for (int b = 0; b < Nodes; ++b) {
      if (s[b] < StencilLines::half) continue;
      float* block = first + static_cast<std::size_t>(9 * (s[b] - StencilLines::half)) * pitch;
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k, block += pitch) *block += static_cast<float>(K[i][k][b]);
    }
  }
};

}  // namespace stroma::transfer
