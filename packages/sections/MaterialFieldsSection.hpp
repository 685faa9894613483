// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Materials|NAME|Fields".

#include "stroma/deck/Section.hpp"
#include "stroma/material/MaterialFields.hpp"

namespace stroma::sections {

deck::Section<material::MaterialFields> material_fields_section();

}  // namespace stroma::sections
