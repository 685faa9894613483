// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "External Forces".

#include "stroma/deck/Section.hpp"
#include "stroma/mechanics/problem/ExternalForces.hpp"

namespace stroma::sections {

deck::Section<mechanics::ExternalForcesParameters> external_forces_section();

}  // namespace stroma::sections
