// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How much of a fictitious material in barely filled elements does not show in a body's forces.

#include <optional>

#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/solver/SolverParameters.hpp"

namespace stroma::solver {

struct BearableStabilization {
  double added;     ///< by the body's present stabilization to its stiffness, to first order [-]
  double bearable;  ///< stabilization that adds about 3e-4 [-], between 2e-6 and 1e-4, of one digit
};

/// Finds it by the body's linear answer to a load, which is solved for. Nothing where no element is
/// barely filled, where none is stabilised, or where the load cannot be solved for. The balance is
/// as before afterwards. Collective.
///
/// \param parameters  of the solver
/// \param balance     of an undeformed body without inertia
/// \param load        the load factor to answer
std::optional<BearableStabilization> bearable_stabilization(const SolverParameters& parameters,
                                                            mechanics::MomentumBalance& balance,
                                                            double load);

}  // namespace stroma::solver
