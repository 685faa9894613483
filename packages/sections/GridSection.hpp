// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Grid".

#include "stroma/deck/Section.hpp"
#include "stroma/mechanics/problem/GridParameters.hpp"

namespace stroma::sections {

deck::Section<mechanics::GridParameters> grid_section();

}  // namespace stroma::sections
