// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Takes a body through its load steps without the program around it.

#include "stroma/solver/LoadStep.hpp"

namespace stroma::test {

/// Newton to 1e-13, with a direct solve: what is left is rounding.
inline solver::SolverParameters to_rounding() {
  solver::SolverParameters parameters;
  parameters.preconditioner = solver::PreconditionerKind::direct;
  parameters.newton_tolerance = 1e-13;
  parameters.linear_tolerance = 1e-13;
  return parameters;
}

/// Equal steps to full load. After each one, calls visit(load, displacement) before the grid is
/// reset for the next. A rejected step fails the caller's test by its exception.
template <class Visit>
void take_steps(mechanics::MovingBody& body, int steps, const solver::SolverParameters& parameters,
                const Visit& visit) {
  solver::NewtonSolver newton(parameters, body.balance());
  for (int step = 1; step <= steps; ++step) {
    solver::begin_step(body, newton);
    grid::Vector trial(body.balance().owned_map());
    const double load = static_cast<double>(step) / steps;
    solver::solve_step(body, newton, load, trial);
    body.accept(load, trial);
    visit(load, trial);
  }
}

/// Force of each condition's support on the body [pN] at a displacement.
inline std::vector<std::array<double, 3>> reactions(mechanics::MovingBody& body,
                                                    const grid::Vector& u) {
  return body.balance().reactions(u);
}

}  // namespace stroma::test
