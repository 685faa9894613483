// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a user says of the solver and of the load steps.

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

namespace stroma::solver {

enum class PreconditionerKind { geometric_multigrid, jacobi, chebyshev, multigrid, direct };

enum class Forcing { adaptive, constant };

struct SolverParameters {
  double newton_tolerance = 1e-8;  ///< ||residual|| / largest ||reaction|| so far
  int newton_iterations = 12;      ///< more than these: the step is rejected
  double linear_tolerance = 1e-6;  ///< ||linear residual|| / ||right-hand side||
  Forcing forcing = Forcing::adaptive;
  int linear_iterations = 10000;
  PreconditionerKind preconditioner = PreconditionerKind::geometric_multigrid;
  Teuchos::RCP<Teuchos::ParameterList> nox;  ///< laid over Stroma's own settings; may be null
  Teuchos::RCP<Teuchos::ParameterList> belos;
  Teuchos::RCP<Teuchos::ParameterList> ifpack2;
  Teuchos::RCP<Teuchos::ParameterList> muelu;
};

struct LoadingParameters {
  int steps = 10;
  double smallest_step = 1e-4;  ///< of the full load
};

}  // namespace stroma::solver
