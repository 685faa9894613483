// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/LinearSolver.hpp"

#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <algorithm>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/base/Stage.hpp"

namespace stroma::solver {

bool takes_stencil(PreconditionerKind kind, const grid::Grid& grid) {
  return kind == PreconditionerKind::geometric_multigrid && grid.width == 2;
}

void choose_tangent(const SolverParameters& parameters, mechanics::MomentumBalance& balance) {
  balance.choose_tangent(takes_stencil(parameters.preconditioner, balance.halo().partition().grid())
                             ? mechanics::TangentForm::stencil
                             : mechanics::TangentForm::compressed_rows);
}

std::unique_ptr<Preconditioner> make_preconditioner(const SolverParameters& parameters,
                                                    const mechanics::MomentumBalance& balance) {
  switch (parameters.preconditioner) {
    case PreconditionerKind::geometric_multigrid:
      return takes_stencil(parameters.preconditioner, balance.halo().partition().grid())
                 ? make_geometric_multigrid(balance)
                 : make_hats_multigrid(balance);
    case PreconditionerKind::multigrid:
      return make_muelu(parameters, balance);
    case PreconditionerKind::direct:
      return make_direct();
    default:
      return make_ifpack2(parameters);
  }
}

LinearSolver::LinearSolver(const SolverParameters& parameters,
                           const mechanics::MomentumBalance& balance)
    : parameters_(parameters), preconditioner_(make_preconditioner(parameters, balance)) {}

grid::RCP<tangent::Matrix> as_matrix(const grid::RCP<const Operator>& tangent) {
  return Teuchos::rcp_const_cast<tangent::Matrix>(
      Teuchos::rcp_dynamic_cast<const tangent::Matrix>(tangent, true));
}

void LinearSolver::set_tangent(const grid::RCP<const Operator>& tangent) {
  const bool is_first = tangent_ == Teuchos::null;
  tangent_ = tangent;
  is_fresh_ = false;
  const bool works_still = last_iterations_ <= 1.5 * iterations_when_fresh_ + 0.5;
  if (is_first || !preconditioner_->worth_keeping() || !works_still) renew_preconditioner();
}

void LinearSolver::renew_preconditioner() {
  const base::Stage stage("preconditioner");
  preconditioner_->compute(tangent_);
  is_fresh_ = true;
  iterations_when_fresh_ = 0.0;
}

LinearResult LinearSolver::solve(const grid::MultiVector& b, grid::MultiVector& x,
                                 double tolerance) {
  Teuchos::Array<double> norm(1);
  b.norm2(norm());
  if (norm[0] == 0.0) {
    x.putScalar(0.0);
    LinearResult nothing_to_do;
    nothing_to_do.converged = true;
    return nothing_to_do;
  }
  if (tolerance == 0.0) tolerance = parameters_.linear_tolerance;
  tolerance = std::max(tolerance, forcing_);
  LinearResult result = run_belos(*preconditioner_, b, x, tolerance);
  if (!result.converged && !is_fresh_) {
    renew_preconditioner();
    result = run_belos(*preconditioner_, b, x, tolerance);
  }
  if (result.indefinite && parameters_.preconditioner != PreconditionerKind::jacobi) {
    // Is it the preconditioner or the tangent? Jacobi is definite as long as the diagonal is
    // positive.
    SolverParameters jacobi = parameters_;
    jacobi.preconditioner = PreconditionerKind::jacobi;
    jacobi.ifpack2 = Teuchos::null;
    const bool is_stencil =
        Teuchos::rcp_dynamic_cast<const tangent::StencilMatrix>(tangent_) != Teuchos::null;
    const auto plain = is_stencil ? make_block_jacobi() : make_ifpack2(jacobi);
    plain->compute(tangent_);
    result = run_belos(*plain, b, x, tolerance);
  }
  if (result.indefinite) throw base::StepRejected("conjugate gradients met an indefinite tangent");
  const double digits = std::max(1.0, -std::log10(tolerance));
  last_iterations_ = result.iterations / digits;
  if (is_fresh_) iterations_when_fresh_ = std::max(iterations_when_fresh_, last_iterations_);
  return result;
}

LinearResult LinearSolver::run_belos(const Preconditioner& preconditioner,
                                     const grid::MultiVector& b, grid::MultiVector& x,
                                     double tolerance) {
  using Problem = Belos::LinearProblem<double, grid::MultiVector, Operator>;
  using Manager = Belos::PseudoBlockCGSolMgr<double, grid::MultiVector, Operator>;
  const base::Stage stage("linear solve");
  x.putScalar(0.0);
  const auto problem =
      Teuchos::rcp(new Problem(tangent_, Teuchos::rcpFromRef(x), Teuchos::rcpFromRef(b)));
  problem->setLeftPrec(preconditioner.apply_inverse());
  problem->setProblem();
  const auto list = Teuchos::parameterList();
  list->set("Convergence Tolerance", tolerance);
  list->set("Maximum Iterations", parameters_.linear_iterations);
  list->set("Residual Scaling", "Norm of RHS");
  if (parameters_.belos != Teuchos::null) list->setParameters(*parameters_.belos);
  Manager manager(problem, list);
  LinearResult result;
  try {
    result.converged = manager.solve() == Belos::Converged;
  } catch (const Belos::BelosError&) {
    // Thrown the same way on all ranks: on p.Kp <= 0, and on a residual that is not a number.
    total_iterations_ += manager.getNumIters();
    result.indefinite = true;
    return result;
  }
  result.iterations = manager.getNumIters();
  result.achieved = manager.achievedTol();
  // A residual that is not a number: Trilinos 13 throws, 16 returns early, with nothing solved.
  result.indefinite = !result.converged && result.iterations < list->get<int>("Maximum Iterations");
  total_iterations_ += result.iterations;
  return result;
}

}  // namespace stroma::solver
