// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Preconditioned conjugate gradients for the tangent.

#include <memory>

#include "stroma/solver/Preconditioner.hpp"

namespace stroma::solver {

struct LinearResult {
  bool converged = false;
  bool indefinite = false;  ///< broke down: p.Kp <= 0, or a residual that is not a number
  int iterations = 0;
  double achieved = 0.0;  ///< ||b - K x|| / ||b||, as conjugate gradients see it
};

/// Solves K x = b with Belos' conjugate gradients and the preconditioner that the deck chose.
class LinearSolver {
 public:
  LinearSolver(const SolverParameters& parameters, const mechanics::MomentumBalance& balance);

  /// The tangent of the solves to come, in the form that the preconditioner takes. A costly
  /// preconditioner made for earlier values is kept as long as it needs at most half as many
  /// iterations again as when it was new. Collective.
  void set_tangent(const grid::RCP<const Operator>& tangent);

  /// Solves to come stop at this tolerance where it is looser than the one that is asked for.
  void set_forcing(double tolerance) { forcing_ = tolerance; }

  /// Solves from x = 0 until ||residual|| <= tolerance * ||b||; 0: the deck's. Collective.
  /// A preconditioner that turns out to be indefinite is replaced by Jacobi for the solve.
  /// \throws base::StepRejected when the tangent is indefinite
  LinearResult solve(const grid::MultiVector& b, grid::MultiVector& x, double tolerance);

  /// Iterations of all solves so far.
  long long total_iterations() const { return total_iterations_; }

 private:
  void renew_preconditioner();
  LinearResult run_belos(const Preconditioner& preconditioner, const grid::MultiVector& b,
                         grid::MultiVector& x, double tolerance);

  SolverParameters parameters_;
  std::unique_ptr<Preconditioner> preconditioner_;
  grid::RCP<const Operator> tangent_;
  long long total_iterations_ = 0;
  bool is_fresh_ = false;               // the preconditioner was made for the present values
  double iterations_when_fresh_ = 0.0;  // per digit, as the next
  double last_iterations_ = 0.0;
  double forcing_ = 0.0;
};

}  // namespace stroma::solver
