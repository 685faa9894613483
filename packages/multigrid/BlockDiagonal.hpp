// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The inverse of the 3 x 3 blocks on the diagonal of a stencil: block Jacobi.

#include "stroma/grid/BoxExchange.hpp"
#include "stroma/tangent/Stencil.hpp"

namespace stroma::multigrid {

/// D^-1, with D the diagonal blocks summed over the ranks. A component whose row is zero
/// (prescribed, or untouched by any particle) gets a row and a column of zeros.
class BlockDiagonal {
 public:
  BlockDiagonal() = default;
  explicit BlockDiagonal(const grid::LevelGrid& grid);

  /// Collective.
  void compute(const tangent::Stencil& stencil, const grid::BoxExchange& exchange);

  /// Makes D^-1 zero at the nodes of the box that are marked (not 0).
  void leave_out(const Kokkos::View<const std::uint8_t*, grid::Device>& nodes);

  /// step = keep * step + scale * D^-1 (b - y);  x += step. Without y: y = 0. The heart of a
  /// polynomial smoother in one pass over the fields.
  void add_step(const grid::NodeField<float>& b, const grid::NodeField<float>* y, float keep,
                float scale, const grid::NodeField<float>& step,
                const grid::NodeField<float>& x) const;

 private:
  int nodes_[3] = {0, 0, 0};
  Kokkos::View<float*, grid::Device> inverse_;  // (line, xx yy zz xy yz zx, node)
};

}  // namespace stroma::multigrid
