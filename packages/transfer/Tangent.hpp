// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles to grid: the tangent (stiffness) matrix.

#include "stroma/transfer/MeanDilatation.hpp"
#include "stroma/transfer/TangentBatch.hpp"

namespace stroma::transfer {

/// Where the 3 x 3 blocks of the tangent go. Row nodes are touched nodes; the column of a block is
/// the row's neighbour in the stencil of all nodes within a reach r = width - 1, side 2 r + 1,
/// s = (dx + r) + side (dy + r) + side^2 (dz + r).
///
/// Rows of owned nodes are summed straight into the values of a compressed row matrix with three
/// rows per node, whose blocks are found by arithmetic; rows of nodes that other ranks own go to
/// `shared` and travel to their owners afterwards. Entries in prescribed rows and columns are left
/// out.
template <class Device>
struct BlockRows {
  using Real = double;

  Kokkos::View<const int*, Device> row;  ///< (touched node) owned node, or ~shared if negative
  Kokkos::View<const std::size_t*, Device> row_begin;  ///< (3 owned node + i) first entry
  Kokkos::View<const std::uint16_t**, Kokkos::LayoutRight, Device>
      slot;                              ///< (owned node, s) block within its row
  Kokkos::View<double*, Device> values;  ///< entries of the matrix, added to
  Kokkos::View<double**, Kokkos::LayoutLeft, Device> shared;  ///< (shared, 9 s + 3 i + k), added to
  Kokkos::View<const std::uint8_t*, Device>
      held;  ///< (touched node) bit c: component c is prescribed

  /// Adds an element's blocks K(i, k, b) to the rows of one of its nodes, b being the element's
  /// nodes and s(b) their places in the node's stencil.
  template <int Nodes, int Padded>
  KOKKOS_INLINE_FUNCTION void add(int node, const double (&K)[3][3][Padded],
                                  const int (&s)[Nodes]) const {
    const int r = row(node);
    if (r < 0) {
      for (int b = 0; b < Nodes; ++b)
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < 3; ++k) shared(~r, 9 * s[b] + 3 * i + k) += K[i][k][b];
      return;
    }
    int first[Nodes];
    for (int b = 0; b < Nodes; ++b) first[b] = 3 * slot(r, s[b]);
    for (int i = 0; i < 3; ++i) {
      double* entries = &values(row_begin(3 * r + i));
      for (int b = 0; b < Nodes; ++b)
        for (int k = 0; k < 3; ++k) entries[first[b] + k] += K[i][k][b];
    }
  }

  /// Multiplies all that was added so far.
  void scale(double factor) const {
    const auto all = values;
    const auto of_others = shared;
    Kokkos::parallel_for(
        "scale rows", Kokkos::RangePolicy<typename Device::execution_space>(0, values.extent(0)),
        KOKKOS_LAMBDA(const std::size_t n) { all(n) *= factor; });
    Kokkos::parallel_for(
        "scale rows of others",
        Kokkos::RangePolicy<typename Device::execution_space>(0, shared.extent(0)),
        KOKKOS_LAMBDA(const std::size_t n) {
          for (std::size_t m = 0; m < of_others.extent(1); ++m) of_others(n, m) *= factor;
        });
  }
  /// Adds to the diagonal entry of a component of a node, if it is not prescribed.
  KOKKOS_INLINE_FUNCTION void add_to_diagonal(int node, int component, double value) const {
    if (held(node) >> component & 1) return;
    const int r = row(node);
    if (r < 0) {
      const int own = static_cast<int>(shared.extent(1)) / 18;  // the block in the middle
      shared(~r, 9 * own + 4 * component) += value;
    } else {
      const int own = static_cast<int>(slot.extent(1)) / 2;
      values(row_begin(3 * r + component) + 3 * slot(r, own) + component) += value;
    }
  }
};

/// The blocks K(a, i, k, b) of one element's nodes a and b, on their way to a matrix.
template <class Shape, class Rows>
struct ElementBlocks {
  using Real = typename Rows::Real;
  static constexpr int n = Shape::nodes;
  static constexpr int w = Shape::width;
  static constexpr int reach = w - 1, side = 2 * reach + 1;
  static constexpr int padded = padded_nodes<Shape>;

  Real K[n][3][3][padded] = {};

  /// Adds them to the rows of the nodes of element (i, j, k), but for what is prescribed.
  template <class Elements>
  KOKKOS_INLINE_FUNCTION void add_to(const Rows& rows, const Elements& elements, int i, int j,
                                     int k) {
    int node[n], held[n], any_held = 0;
    for (int a = 0; a < n; ++a) {
      node[a] = elements.node_of(i, j, k, a);
      held[a] = rows.held(node[a]);
      any_held |= held[a];
    }
    if (any_held) leave_out(held);
    for (int a = 0; a < n; ++a) {
      int s[n];  // place of node b in the stencil of node a
      for (int b = 0; b < n; ++b) {
        const int dz = elements.box.flat ? 0 : b / (w * w) - a / (w * w);
        s[b] = (b % w - a % w + reach) + side * (b / w % w - a / w % w + reach) +
               side * side * (dz + reach);
      }
      rows.add(node[a], K[a], s);
    }
  }

 private:
  /// Clears the rows and columns of prescribed components.
  KOKKOS_INLINE_FUNCTION void leave_out(const int (&held)[n]) {
    for (int a = 0; a < n; ++a)
      for (int c = 0; c < 3; ++c)
        for (int m = 0; m < 3; ++m)
          for (int b = 0; b < n; ++b)
            if ((held[a] >> c & 1) || (held[b] >> m & 1)) K[a][c][m][b] = 0.0;
  }
};

/// Adds the tangent of each element's points to the rows of its nodes:
///
///     K_IiJk = sum_p V0 dN_I/dx_j a_ijkl dN_J/dx_l       [pN/um] = [Pa um]
///
/// with the law's spatial tangent a (material and geometric part). Points are collected a few at a
/// time (TangentBatch); then the sums over them stay in registers while the inner loops run over
/// eight nodes b and vectorise. Launch with for_each_element(): no atomics, the same bit for bit
/// for any number of threads. Source: docs/theory.md, eq. (4.4).
///
/// \tparam Rows  where blocks go: BlockRows or StencilRows; also says in which precision they are
///              summed
template <class Shape, class Law, class Device, class Rows = BlockRows<Device>>
struct Tangent {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const Law*, Device> law;
  Rows rows;

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    const int element = elements.box.element(i, j, k);
    if (elements.particles.element_begin(element) == elements.particles.element_begin(element + 1))
      return;
    Blocks blocks;
    Batch batch;
    for_each_tangent(elements, law, i, j, k, bad, [&](const auto& point, const auto& tangent) {
      batch.add(point, tangent);
      if (batch.count == Batch::size) batch.add_blocks(blocks.K);
    });
    batch.add_blocks(blocks.K);
    blocks.add_to(rows, elements, i, j, k);
  }

 private:
  using Blocks = ElementBlocks<Shape, Rows>;
  using Batch = TangentBatch<Shape, typename Blocks::Real, typename Law::Tangent>;
};

}  // namespace stroma::transfer
