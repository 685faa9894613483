// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Materials|NAME|Fields".

#include "stroma/deck/Section.hpp"
#include "stroma/material/Material.hpp"

namespace stroma::sections {

deck::Section<material::MaterialFields> material_fields_section();

/// Looks for fields of what a material does not give, and for values that it may not have.
void check_fields(const material::MaterialParameters& p, deck::Findings& findings);

}  // namespace stroma::sections
