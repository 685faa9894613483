// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Initial Conditions".

#include "stroma/deck/Section.hpp"
#include "stroma/mechanics/problem/InitialConditions.hpp"

namespace stroma::sections {

deck::Section<mechanics::InitialConditionsParameters> initial_conditions_section();

}  // namespace stroma::sections
