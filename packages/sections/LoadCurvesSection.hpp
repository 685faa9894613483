// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Load Curves".

#include "stroma/deck/Section.hpp"
#include "stroma/mechanics/problem/LoadCurve.hpp"

namespace stroma::sections {

deck::Section<mechanics::LoadCurvesParameters> load_curves_section();

}  // namespace stroma::sections
