// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The smoother of the geometric multigrid: a polynomial in D^-1 K.

#include "stroma/multigrid/BlockDiagonal.hpp"
#include "stroma/multigrid/ElementPatches.hpp"

namespace stroma::multigrid {

/// The fields of one level that a cycle works with.
struct LevelFields {
  grid::NodeField<float> b;     ///< right-hand side, consistent
  grid::NodeField<float> x;     ///< solution, consistent
  grid::NodeField<float> step;  ///< last step of the smoother
  grid::NodeField<float> y;     ///< K x, or a residual

  explicit LevelFields(const grid::LevelGrid& grid)
      : b("b", grid), x("x", grid), step("step", grid), y("y", grid) {}
};

/// Chebyshev polynomials of the fourth kind over block Jacobi, which damp all that a coarser level
/// does not see, and need only a bound of the largest eigenvalue of D^-1 K:
///
///     z_k = (2k - 3)/(2k + 1) z_(k-1) + (8k - 4)/(2k + 1)/lambda D^-1 (b - K x),   x <- x + z_k.
///
/// They are made of products alone: the same on any number of ranks, and symmetric, so that equal
/// degrees before and after the coarse correction make a symmetric cycle.
///
/// Where elements are chosen for it, D^-1 solves on each of them with all its unknowns, and is
/// block Jacobi at the other nodes (ElementPatches).
///
/// Source: Lottes, Numer. Linear Algebra Appl. 30 (2023) e2518, algorithm 3.
class ChebyshevSmoother {
 public:
  ChebyshevSmoother(const grid::LevelGrid& grid, int degree) : diagonal_(grid), degree_(degree) {}
  /// Chooses elements for local solves; where any rank does, the polynomial is of another degree.
  /// Collective.
  void patch(const grid::BoxExchange& exchange, const ElementPatches::Chosen& chosen, int degree);

  /// D^-1, and the bound: power iterations from a start that does not depend on the ranks, and a
  /// margin, for they come from below. Overwrites the fields. Collective.
  void compute(const tangent::Stencil& stencil, const grid::BoxExchange& exchange,
               const LevelFields& fields);
  double eigenvalue_bound() const { return bound_; }

  /// Smooths from x = 0. Collective, as the next.
  void smooth_from_zero(const tangent::Stencil& stencil, const grid::BoxExchange& exchange,
                        const LevelFields& fields) const;
  void smooth(const tangent::Stencil& stencil, const grid::BoxExchange& exchange,
              const LevelFields& fields) const;

 private:
  void steps(int first, const tangent::Stencil& stencil, const grid::BoxExchange& exchange,
             const LevelFields& fields) const;

  /// step = keep * step + scale * D^-1 (b - y);  x += step.
  void add_step(const grid::NodeField<float>& b, const grid::NodeField<float>* y, float keep,
                float scale, const grid::NodeField<float>& step, const grid::NodeField<float>& x,
                const grid::BoxExchange& exchange) const;

  BlockDiagonal diagonal_;
  ElementPatches patches_;
  int degree_;
  double bound_ = 1.0;
};

}  // namespace stroma::multigrid
