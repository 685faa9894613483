// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The linear solver as Thyra, and so NOX, sees it.

#include <Thyra_LinearOpWithSolveFactoryBase.hpp>

#include "stroma/solver/LinearSolver.hpp"

namespace stroma::solver {

/// What a solve does that meets an indefinite tangent.
enum class OnIndefinite {
  reject_step,    ///< throws base::StepRejected through its caller
  not_converged,  ///< answers Thyra::SOLVE_STATUS_UNCONVERGED, x = 0, and says why
};

/// A Thyra factory of operators with solve() around one LinearSolver, which outlives it.
Teuchos::RCP<Thyra::LinearOpWithSolveFactoryBase<double>> thyra_factory(
    LinearSolver& solver, OnIndefinite on_indefinite = OnIndefinite::not_converged);

}  // namespace stroma::solver
