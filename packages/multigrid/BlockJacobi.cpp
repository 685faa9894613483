// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/multigrid/BlockJacobi.hpp"

namespace stroma::multigrid {

BlockJacobi::BlockJacobi(const grid::RCP<const tangent::StencilMatrix>& matrix)
    : matrix_(matrix), diagonal_(matrix->exchange().grid()), fields_(matrix->exchange().grid()) {
  diagonal_.compute(matrix->stencil(), matrix->exchange());
}

void BlockJacobi::apply(const grid::MultiVector& x, grid::MultiVector& y, Teuchos::ETransp,
                        double alpha, double beta) const {
  for (std::size_t column = 0; column < x.getNumVectors(); ++column) {
    matrix_->to_field(x, column, fields_.b);
    fields_.x.zero();
    diagonal_.add_step(fields_.b, nullptr, 0.0f, 1.0f, fields_.step, fields_.x);
    matrix_->from_field(fields_.x, x, column, 1.0 / matrix_->held_diagonal(), alpha, beta, y);
  }
}

}  // namespace stroma::multigrid
