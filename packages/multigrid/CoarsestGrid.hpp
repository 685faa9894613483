// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The direct solve on the coarsest level.

#include <array>
#include <cstdint>
#include <vector>

#include "stroma/grid/BoxExchange.hpp"
#include "stroma/tangent/Stencil.hpp"

namespace stroma::multigrid {

/// Cholesky factors of the whole coarsest operator, as a band, on every rank. Numbered along its
/// shortest direction first, a grid of n unknowns has a band of b = 3 (n_1 n_2 + n_1 + 1) + 2
/// entries beside the diagonal: n b doubles and n b^2 operations.
///
/// Whatever the operator, the factors are those of a positive definite one: the diagonal is raised
/// by a millionth, which keeps parts of the body that hang free from being singular, and by a
/// hundred times more until all pivots say so. A body between plates whose sides are pressed, as by
/// the first iterates of a step, gives way to a rotation about its axis.
class CoarsestGrid {
 public:
  /// Operations that factorising a level takes.
  static double work(const grid::LevelGrid& grid);
  /// Doubles that its factors take.
  static double size(const grid::LevelGrid& grid);

  explicit CoarsestGrid(const grid::LevelGrid& grid);

  /// Collective, as the next.
  void factorize(const tangent::Stencil& stencil, const grid::BoxExchange& exchange);
  /// x = K^-1 b; both consistent.
  void solve(const grid::NodeField<float>& b, const grid::NodeField<float>& x,
             const grid::BoxExchange& exchange) const;

 private:
  void assemble(const tangent::Stencil& stencil, const grid::BoxExchange& exchange);
  std::int64_t unknown(const std::array<std::int64_t, 3>& node, int component) const;

  std::array<std::int64_t, 3> stride_;  // of node numbers
  std::size_t unknowns_ = 0, band_ = 0;
  std::vector<double> factor_;  // (column, row - column)
};

}  // namespace stroma::multigrid
