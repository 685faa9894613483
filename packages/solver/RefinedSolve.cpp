// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/RefinedSolve.hpp"

#include "stroma/base/Error.hpp"

namespace stroma::solver {

void linearize(LinearSolver& solver, mechanics::MomentumBalance& balance, const grid::Vector& u) {
  if (balance.assemble_tangent(u) > 0) throw base::StepRejected("particles are turned inside out");
  solver.set_tangent(balance.tangent());
  solver.set_forcing(0.0);
}

double solve_refined(LinearSolver& solver, const mechanics::MomentumBalance& balance,
                     const grid::Vector& u, const grid::Vector& b, grid::Vector& x,
                     double tolerance) {
  grid::Vector residual(b, Teuchos::Copy), correction(b.getMap()), product(b.getMap());
  balance.supports().clear(residual);
  x.putScalar(0.0);
  const double size = residual.norm2(), goal = tolerance * size;
  // Each pass leaves what the solver and the rounding of the stored tangent leave.
  constexpr int most_passes = 6;
  for (int pass = 0; pass < most_passes && residual.norm2() > goal; ++pass) {
    solver.solve(residual, correction, 0.0);
    balance.supports().clear(correction);
    x.update(1.0, correction, 1.0);
    balance.tangent_times(u, correction, product);
    balance.supports().clear(product);
    residual.update(-1.0, product, 1.0);
  }
  const double left = residual.norm2();
  if (!(left <= goal)) throw base::StepRejected("the linear solver does not come to its tolerance");
  return size > 0.0 ? left / size : 0.0;
}

}  // namespace stroma::solver
