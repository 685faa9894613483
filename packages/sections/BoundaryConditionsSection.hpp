// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Boundary Conditions".

#include "stroma/deck/Section.hpp"
#include "stroma/mechanics/problem/BoundaryConditions.hpp"

namespace stroma::sections {

deck::Section<mechanics::BoundaryConditionsParameters> boundary_conditions_section();

}  // namespace stroma::sections
