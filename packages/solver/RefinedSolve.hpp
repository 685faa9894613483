// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Linear problems of a body's tangent, solved to more digits than the tangent is stored with.

#include "stroma/solver/LinearSolver.hpp"

namespace stroma::solver {

/// Assembles the tangent at u, for linear problems to come. Collective.
/// \throws base::StepRejected when u turns particles inside out
void linearize(LinearSolver& solver, mechanics::MomentumBalance& balance, const grid::Vector& u);

/// Solves K(u) x = b at the components that are not prescribed; x is 0 at the others, where b does
/// not count. Refined by the tangent's product, which knows nothing of the rounding with which a
/// stencil is stored. Collective.
/// \param solver     of the balance, linearized at u
/// \param balance    whose tangent it is
/// \param u          displacement at which the tangent is taken [um]
/// \param b          right-hand side [pN]
/// \param x          solution [um]
/// \param tolerance  ||K x - b|| / ||b||
/// \return ||K x - b|| / ||b|| that is left, 0 for b = 0
/// \throws base::StepRejected when the tangent is indefinite, or the tolerance is not reached
double solve_refined(LinearSolver& solver, const mechanics::MomentumBalance& balance,
                     const grid::Vector& u, const grid::Vector& b, grid::Vector& x,
                     double tolerance);

}  // namespace stroma::solver
