// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Solver".

#include "stroma/deck/Section.hpp"
#include "stroma/solver/SolverParameters.hpp"

namespace stroma::sections {

deck::Section<solver::SolverParameters> solver_section();

}  // namespace stroma::sections
