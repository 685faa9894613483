// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The linear solver as Thyra, and so NOX, sees it.

#include <Thyra_LinearOpWithSolveFactoryBase.hpp>

#include "stroma/solver/LinearSolver.hpp"

namespace stroma::solver {

/// A Thyra factory of operators with solve() around one LinearSolver, which outlives it.
Teuchos::RCP<Thyra::LinearOpWithSolveFactoryBase<double>> thyra_factory(LinearSolver& solver);

}  // namespace stroma::solver
