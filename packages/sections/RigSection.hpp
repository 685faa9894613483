// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Rig".

#include "stroma/deck/Section.hpp"
#include "stroma/mechanics/problem/Rigs.hpp"

namespace stroma::sections {

deck::Section<mechanics::RigParameters> rig_section();

}  // namespace stroma::sections
