// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A multigrid cycle on the grid's own coarser grids, for the tangent stored as a stencil.

#include <memory>
#include <optional>
#include <vector>

#include "stroma/multigrid/ChebyshevSmoother.hpp"
#include "stroma/multigrid/CoarsestGrid.hpp"
#include "stroma/multigrid/LevelTransfer.hpp"
#include "stroma/tangent/StencilMatrix.hpp"

namespace stroma::multigrid {

/// Which directions to coarsen next, all or only those whose elements are short.
///
/// \param grid     of the level
/// \param spacing  of the level's elements [um]; doubled where coarsened
std::array<bool, 3> directions_to_coarsen(const grid::LevelGrid& grid,
                                          std::array<double, 3>& spacing);

struct MultigridSettings {
  int smoother_degree = 3;
  /// Of the finest level where elements are chosen for local solves: it finds what is softer than
  /// an element and longer.
  int patched_degree = 8;
  /// Operations to factorise a level: the first that takes at most so many is the coarsest.
  double direct_work = 3e8;
};

/// One level of a hierarchy, as it is going to be.
struct LevelPlan {
  grid::LevelGrid grid;
  std::array<bool, 3> directions;  ///< in which it is coarsened; none: the coarsest level
  bool is_direct;                  ///< solved by factors; else smoothed
  int smoother_degree;
};

/// The levels, from the finest, by arithmetic.
///
/// \param grid      the finest
/// \param spacing   of the finest level's elements [um]
/// \param settings  degrees of the smoother, and when to stop
std::vector<LevelPlan> plan_levels(grid::LevelGrid grid, std::array<double, 3> spacing,
                                   const MultigridSettings& settings);

/// One V-cycle as an operator M^-1: symmetric, positive definite while the tangent is, in single
/// precision inside. Trilinear interpolation P in logical space, coarse operators P^T K P,
/// Chebyshev smoothing over block Jacobi, a direct solve on the coarsest level.
///
/// Any grid of the program will do: convected or not, partly filled, with components prescribed
/// anywhere. Rows and columns of prescribed and untouched components are zero in the stencil, and
/// thereby in every coarse one; M^-1 has 1 / diagonal there.
///
/// Memory beside the tangent: 72 bytes a node for fields and diagonal, and an eighth to a seventh
/// of all that again for the coarser levels.
class GeometricMultigrid : public grid::Operator {
 public:
  /// \param matrix    the tangent of the finest level
  /// \param spacing   of its elements [um]
  /// \param patched   elements of the rank that are solved on by themselves (ElementPatches): those
  ///                 that the body barely fills
  /// \param settings  degrees and sizes
  GeometricMultigrid(const grid::RCP<const tangent::StencilMatrix>& matrix,
                     const std::array<double, 3>& spacing,
                     const ElementPatches::Chosen& patched = {},
                     const MultigridSettings& settings = {});

  /// Adapts to the tangent's present values. Collective.
  void compute();

  int levels() const { return static_cast<int>(levels_.size()); }
  const tangent::Stencil& stencil(int level) const;
  const grid::LevelGrid& grid(int level) const { return at(level).exchange.grid(); }
  const LevelTransfer& transfer(int level) const { return *at(level).transfer; }

  grid::RCP<const grid::Map> getDomainMap() const override { return matrix_->getDomainMap(); }
  grid::RCP<const grid::Map> getRangeMap() const override { return matrix_->getRangeMap(); }
  bool hasTransposeApply() const override { return true; }  // symmetric
  void apply(const grid::MultiVector& x, grid::MultiVector& y,
             Teuchos::ETransp mode = Teuchos::NO_TRANS, double alpha = 1.0,
             double beta = 0.0) const override;

 private:
  struct Level {
    grid::BoxExchange exchange;
    tangent::Stencil stencil;  // of coarse levels; the finest is the matrix's
    LevelFields fields;
    ChebyshevSmoother smoother;
    std::optional<LevelTransfer> transfer;  // to the next level

    Level(const base::Communicator& communicator, const grid::LevelGrid& grid, bool is_finest,
          int degree);
  };
  const Level& at(int level) const { return *levels_[static_cast<std::size_t>(level)]; }
  void cycle(int level) const;
  void restrict_residual(int level) const;

  grid::RCP<const tangent::StencilMatrix> matrix_;
  std::vector<std::unique_ptr<Level>> levels_;
  std::optional<CoarsestGrid> coarsest_;
};

}  // namespace stroma::multigrid
