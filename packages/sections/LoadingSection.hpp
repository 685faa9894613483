// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Loading".

#include "stroma/deck/Section.hpp"
#include "stroma/solver/SolverParameters.hpp"

namespace stroma::sections {

deck::Section<solver::LoadingParameters> loading_section();

}  // namespace stroma::sections
