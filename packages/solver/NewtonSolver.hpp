// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Newton's method on the balance of momentum, driven by NOX.

#include <functional>
#include <memory>
#include <vector>

#include "stroma/solver/LinearSolver.hpp"
#include "stroma/solver/ThyraLinearSolve.hpp"
#include "stroma/solver/ThyraModel.hpp"

namespace stroma::solver {

struct NewtonResult {
  int iterations = 0;
  long long linear_iterations = 0;  ///< the predictor's included
  double residual = 0.0;            ///< ||residual|| / largest force scale so far
  /// The residual is above the tolerance, but rounding leaves as much of it.
  bool is_limited_by_rounding = false;
  /// What the nodes bear that hold a free rigid motion, over the largest force scale so far. As
  /// long as the loads are in balance it is no more than the residual.
  double hold_share = 0.0;
  double time_error = 0.0;  ///< of the step, of a body with inertia [um] (Inertia::step_error)
};

/// What a solver has learnt in the steps of a run.
struct NewtonMemory {
  /// ||residual|| after an exact Newton step / that before^2, both relative to the forces.
  double nonlinearity = 0.01;
  double last_relative = 0.0;  ///< residual of the last iterate
  double last_forcing = 0.0;
  double largest_force = 0.0;  ///< of accepted steps [pN]
};

/// Solves residual(u) = 0 for one load. Norms are Euclidean, over all ranks.
class NewtonSolver {
 public:
  /// Called after each Newton iteration with its number, the relative residual (that of the
  /// starting point for number 0), and the linear iterations so far.
  using Progress = std::function<void(int, double, long long)>;

  NewtonSolver(const SolverParameters& parameters, mechanics::MomentumBalance& balance,
               Progress progress = {});

  /// Goes on with another balance of the same body (after a grid reset): the largest reaction so
  /// far still counts.
  void attach(mechanics::MomentumBalance& balance);

  /// Changes u, whose prescribed components are those of the balance's load, until ||residual|| <= tolerance * the largest
  /// force scale (reactions, external force) of this and all earlier calls, or until nothing but
  /// rounding is left of it: that must be small against the forces, unless there are none (a body
  /// that moves without strain). Collective.
  /// \param u       where to start, and what is found [um]
  /// \param enough  stops at this relative residual, if it is larger than the tolerance
  /// \throws std::logic_error when prescribed components are not those of the load
  /// \throws base::StepRejected when it does not converge, when rounding is as large as the forces,
  ///         or when particles are turned inside out; u then holds the last iterate
  NewtonResult solve(grid::Vector& u, double enough = 0.0);

  /// Predicts by the tangent: u + du with du the given change of the prescribed components and, at
  /// the others, K du = -residual(u). For the first step of a run, which has no past to
  /// extrapolate; a plain change of the prescribed components alone would crush the first layer of
  /// elements. Collective.
  void predict(grid::Vector& u, const grid::Vector& prescribed_change);

  /// Solves K(u) x = b at the components that are not prescribed, with the preconditioner that
  /// Newton's method has; x is 0 at the others, where b does not count. Refined by the tangent's
  /// product, which knows nothing of the rounding with which a stencil is stored. Collective.
  /// \param u          displacement at which the tangent is taken [um]
  /// \param b          right-hand side [pN]
  /// \param x          solution [um]
  /// \param tolerance  ||K x - b|| / ||b||
  /// \throws base::StepRejected when the tangent is indefinite, or the tolerance is not reached
  void solve_tangent(const grid::Vector& u, const grid::Vector& b, grid::Vector& x,
                     double tolerance);

  const NewtonMemory& memory() const { return memory_; }
  /// Goes on as one that has learnt this.
  void remember(const NewtonMemory& memory) { memory_ = memory; }

  /// Relative residual of the start and after each iteration of the last solve().
  const std::vector<double>& residual_history() const { return residual_history_; }

 private:
  SolverParameters parameters_;
  mechanics::MomentumBalance* balance_;
  Progress progress_;
  std::unique_ptr<LinearSolver> linear_solver_;
  Teuchos::RCP<ThyraModel> model_;
  void choose_forcing(double now, double tolerance);
  double loosest_forcing() const;
  double force_scale(double now, double size, double& seen) const;
  void check_rounding(const grid::Vector& u) const;

  long long reported_iterations_ = 0;
  NewtonMemory memory_;
  std::vector<double> residual_history_;
};

}  // namespace stroma::solver
