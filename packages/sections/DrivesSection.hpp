// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck sections "Materials|NAME|Active Stress" and "Materials|NAME|Growth".

#include "stroma/deck/Section.hpp"
#include "stroma/material/Material.hpp"

namespace stroma::sections {

deck::Section<material::ActiveStressParameters> active_stress_section();
deck::Section<material::GrowthParameters> growth_section();

/// Looks for directions that are needed and not there, or there and not needed.
void check_drives(const material::MaterialParameters& material, deck::Findings& findings);

}  // namespace stroma::sections
