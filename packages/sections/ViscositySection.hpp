// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Materials|NAME|Viscosity".

#include "stroma/deck/Section.hpp"
#include "stroma/material/Material.hpp"

namespace stroma::sections {

deck::Section<material::ViscosityParameters> viscosity_section();

}  // namespace stroma::sections
