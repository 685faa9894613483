// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Block Jacobi on the tangent stored as a stencil.

#include "stroma/multigrid/BlockDiagonal.hpp"
#include "stroma/multigrid/ChebyshevSmoother.hpp"
#include "stroma/tangent/StencilMatrix.hpp"

namespace stroma::multigrid {

/// M^-1 = D^-1, with D the 3 x 3 blocks of the tangent's diagonal as it is when this is made, in
/// single precision inside.
class BlockJacobi : public grid::Operator {
 public:
  explicit BlockJacobi(const grid::RCP<const tangent::StencilMatrix>& matrix);

  grid::RCP<const grid::Map> getDomainMap() const override { return matrix_->getDomainMap(); }
  grid::RCP<const grid::Map> getRangeMap() const override { return matrix_->getRangeMap(); }
  bool hasTransposeApply() const override { return true; }  // symmetric
  void apply(const grid::MultiVector& x, grid::MultiVector& y,
             Teuchos::ETransp mode = Teuchos::NO_TRANS, double alpha = 1.0,
             double beta = 0.0) const override;

 private:
  grid::RCP<const tangent::StencilMatrix> matrix_;
  BlockDiagonal diagonal_;
  LevelFields fields_;
};

}  // namespace stroma::multigrid
