// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/NewtonSolver.hpp"

#include <NOX.H>
#include <NOX_Thyra.H>

#include <Thyra_TpetraThyraWrappers.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/solver/RefinedSolve.hpp"

namespace stroma::solver {
namespace {

using Extract = Thyra::TpetraOperatorVectorExtraction<double, grid::LocalOrdinal,
                                                      grid::GlobalOrdinal, grid::Map::node_type>;

/// Converged when a function of the iterate says so. Called once for each iterate.
class Converged : public NOX::StatusTest::Generic {
 public:
  explicit Converged(std::function<bool(const NOX::Abstract::Group&)> is_good)
      : is_good_(std::move(is_good)) {}

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& problem,
                                          NOX::StatusTest::CheckType) override {
    status_ = is_good_(problem.getSolutionGroup()) ? NOX::StatusTest::Converged
                                                   : NOX::StatusTest::Unconverged;
    return status_;
  }
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream; }

 private:
  std::function<bool(const NOX::Abstract::Group&)> is_good_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

grid::RCP<const grid::Vector> displacement_of(const NOX::Abstract::Group& group) {
  const auto& x = dynamic_cast<const NOX::Thyra::Vector&>(group.getX()).getThyraVector();
  return Extract::getConstTpetraVector(Teuchos::rcpFromRef(x));
}

Teuchos::RCP<Teuchos::ParameterList> nox_settings(const SolverParameters& parameters) {
  const auto list = Teuchos::parameterList();
  list->set("Nonlinear Solver", "Line Search Based");
  list->sublist("Direction").set("Method", "Newton");
  auto& newton = list->sublist("Direction").sublist("Newton");
  newton.set("Forcing Term Method", "Constant");
  newton.sublist("Linear Solver").set("Tolerance", parameters.linear_tolerance);
  auto& search = list->sublist("Line Search");
  search.set("Method", "Backtrack");
  search.sublist("Backtrack").set("Minimum Step", 1.0 / 64);
  search.sublist("Backtrack").set("Recovery Step", 1.0);
  list->sublist("Printing").set("Output Information", 0);
  if (parameters.nox != Teuchos::null) list->setParameters(*parameters.nox);
  return list;
}

}  // namespace

NewtonSolver::NewtonSolver(const SolverParameters& parameters, mechanics::MomentumBalance& balance,
                           Progress progress)
    : parameters_(parameters), balance_(&balance), progress_(std::move(progress)) {
  attach(balance);
}

void NewtonSolver::attach(mechanics::MomentumBalance& balance) {
  model_ = Teuchos::null;
  balance_ = &balance;
  choose_tangent(parameters_, balance);
  linear_solver_ = std::make_unique<LinearSolver>(parameters_, balance);
  model_ = Teuchos::rcp(
      new ThyraModel(balance, thyra_factory(*linear_solver_, OnIndefinite::reject_step)));
  reported_iterations_ = 0;
}

/// How well the next Newton step is worth solving for: its linear error need not be much smaller
/// than its nonlinear one, which Newton's quadratic order tells from the last steps, nor than what
/// convergence asks for. A digit costs a good preconditioner little more than one iteration and
/// another Newton step an assembly, so that in doubt the step is solved better.
void NewtonSolver::choose_forcing(double now, double tolerance) {
  const double before = std::exchange(memory_.last_relative, now);
  if (parameters_.forcing == Forcing::constant) return;
  if (residual_history_.size() > 1) {
    const double seen = now / (before * before);
    const bool is_nonlinear = now > 2.0 * memory_.last_forcing * before;  // else a bound from above
    if (now < before)
      memory_.nonlinearity = is_nonlinear ? seen : std::min(memory_.nonlinearity, seen);
  }
  const double nonlinear_error = memory_.nonlinearity * now * now;
  const double goal = nonlinear_error < tolerance ? 0.01 * tolerance : 0.1 * nonlinear_error;
  const double loosest = loosest_forcing();
  memory_.last_forcing =
      now > 0.0 ? std::max(std::min(goal / now, loosest), parameters_.linear_tolerance) : loosest;
  linear_solver_->set_forcing(memory_.last_forcing);
}

/// A linear solve leaves this share of its residual at most. Where springs are pulled, theirs is
/// nearly all of it: the body's part must be solved as well.
double NewtonSolver::loosest_forcing() const { return 1e-3 / balance_->stiffness_contrast(); }

/// The forces to which a residual is compared: the largest of the accepted steps and of the iterates
/// of this one. An iterate that overshoots by far, as exponential laws let it, says nothing of them:
/// then those of the present iterate, unless it bears none to speak of.
///
/// \param now   of the iterate [pN]
/// \param size  Euclidean norm of its displacement [um]
/// \param seen  the largest so far, of iterates too [pN]
double NewtonSolver::force_scale(double now, double size, double& seen) const {
  if (std::isfinite(now)) seen = std::max(seen, now);
  const double borne =
      std::isfinite(now) ? std::max(memory_.largest_force, now) : memory_.largest_force;
  const bool bears_some = borne > 1e-6 * balance_->body().typical_diagonal() * size;
  return bears_some && seen > 2.0 * borne ? borne : seen;
}

NewtonResult NewtonSolver::solve(grid::Vector& u, double enough) {
  if (!balance_->supports().are_imposed(balance_->load(), u, 1e-9))
    throw std::logic_error(
        "the prescribed components of the displacement are not those of the balance's load");
  balance_->supports().impose(balance_->load(), u);  // to the last bit
  residual_history_.clear();
  const double tolerance = std::max(parameters_.newton_tolerance, enough);
  bool only_rounding_is_left = false;
  double hold = 0.0, seen = memory_.largest_force, scale = memory_.largest_force;
  const auto is_good = [&](const NOX::Abstract::Group& group) {
    const auto at = displacement_of(group);
    const mechanics::ForceBalance& forces = balance_->forces(*at);
    hold = forces.hold;
    scale = force_scale(forces.scale, at->norm2(), seen);
    const double norm = group.getNormF();
    const double relative = norm == 0.0 ? 0.0 : norm / scale;
    const bool is_small = relative <= tolerance;
    only_rounding_is_left = !is_small && norm <= forces.rounding;
    residual_history_.push_back(relative);
    choose_forcing(only_rounding_is_left ? 0.0 : relative, tolerance);
    if (progress_)
      progress_(static_cast<int>(residual_history_.size()) - 1, relative,
                linear_solver_->total_iterations() - reported_iterations_);
    return is_small || only_rounding_is_left;
  };

  const auto start = Thyra::createVector(Teuchos::rcpFromRef(u), model_->get_x_space());
  const auto group = Teuchos::rcp(new NOX::Thyra::Group(
      NOX::Thyra::Vector(*start), model_, model_->create_W_op(), model_->get_W_factory(),
      Teuchos::RCP<Thyra::PreconditionerBase<double>>(),
      Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>>()));
  const auto converged = Teuchos::rcp(new Converged(is_good));
  const auto finite = Teuchos::rcp(new NOX::StatusTest::FiniteValue);
  const auto too_many = Teuchos::rcp(new NOX::StatusTest::MaxIters(parameters_.newton_iterations));
  const auto test =
      Teuchos::rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR, finite, converged));
  test->addStatusTest(too_many);
  const auto solver = NOX::Solver::buildSolver(group, test, nox_settings(parameters_));
  const auto status = solver->solve();

  u.assign(*displacement_of(solver->getSolutionGroup()));

  if (finite->getStatus() == NOX::StatusTest::Failed)
    throw base::StepRejected(balance_->forces(u).inverted > 0
                                 ? "particles are turned inside out"
                                 : "stresses are beyond what numbers hold");
  if (status != NOX::StatusTest::Converged)
    throw base::StepRejected(
        base::format("Newton did not converge in %d iterations (residual %.2e)",
                     solver->getNumIterations(), residual_history_.back()));
  if (only_rounding_is_left) check_rounding(u);
  memory_.largest_force = scale;
  NewtonResult result;
  result.is_limited_by_rounding = only_rounding_is_left;
  if (memory_.largest_force > 0.0) result.hold_share = hold / memory_.largest_force;
  result.iterations = solver->getNumIterations();
  result.linear_iterations = linear_solver_->total_iterations() - reported_iterations_;
  reported_iterations_ = linear_solver_->total_iterations();
  result.residual = residual_history_.back();
  return result;
}

/// Rounding may leave a residual that is small against the forces, or as large as them where there
/// are none to speak of: in a body that nothing strains but what rounding does to it, through the
/// springs of its supports if there are any.
void NewtonSolver::check_rounding(const grid::Vector& u) const {
  constexpr double largest_share = 1e-4;
  const double strain_by_rounding = 1e-11 * balance_->stiffness_contrast();
  const double relative = residual_history_.back();
  if (relative <= largest_share || balance_->body().largest_strain(u) <= strain_by_rounding) return;
  throw base::StepRejected(base::format(
      "rounding alone leaves a residual of %.2e of the forces: the stiffest of materials and "
      "springs is too stiff, or displacements are too large, for what the rest bears",
      relative));
}

void NewtonSolver::predict(grid::Vector& u, const grid::Vector& prescribed_change) {
  if (balance_->assemble_tangent(u) > 0)
    throw base::StepRejected("particles are turned inside out");
  linear_solver_->set_tangent(balance_->tangent());
  grid::Vector rhs(balance_->owned_map()), du(balance_->owned_map()), r(balance_->owned_map());
  balance_->tangent_times(u, prescribed_change, rhs);
  balance_->residual(u, r);
  rhs.update(-1.0, r, -1.0);
  balance_->supports().clear(rhs);
  // The residual that the predictor leaves is nonlinear; Newton's first step sees to the rest.
  linear_solver_->set_forcing(parameters_.forcing == Forcing::constant ? 0.0 : loosest_forcing());
  linear_solver_->solve(rhs, du, parameters_.linear_tolerance);
  u.update(1.0, du, 1.0, prescribed_change, 1.0);
}

void NewtonSolver::solve_tangent(const grid::Vector& u, const grid::Vector& b, grid::Vector& x,
                                 double tolerance) {
  linearize(*linear_solver_, *balance_, u);
  solve_refined(*linear_solver_, *balance_, u, b, x, tolerance);
  reported_iterations_ = linear_solver_->total_iterations();  // they are of no load step
}

}  // namespace stroma::solver
