// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// One load step of a body: where it starts, and how it is solved.

#include "stroma/mechanics/MovingBody.hpp"
#include "stroma/solver/NewtonSolver.hpp"

namespace stroma::solver {

/// Makes the body's accepted displacement the start of the next step, and lets the solver follow
/// when the grid was reset. Collective.
/// \throws base::RunError when the new configuration cannot be computed with, or a package of
///         Trilinos gives up
void begin_step(mechanics::MovingBody& body, NewtonSolver& newton);

/// Solves for the displacement since the base at a load factor. The start goes on as the last step
/// did, or, where there is none to go by, follows the tangent. Nothing of the body changes but the
/// load that its balance carries: the caller accepts the displacement, or rejects it. Collective.
///
/// \param body    with a step begun
/// \param newton  attached to the body's balance
/// \param load    the load factor to reach
/// \param trial   the result; after a failure the last iterate
/// \throws base::StepRejected  see NewtonSolver::solve
/// \throws base::RunError when a package of Trilinos gives up
NewtonResult solve_step(mechanics::MovingBody& body, NewtonSolver& newton, double load,
                        grid::Vector& trial);

}  // namespace stroma::solver
