// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Particles".

#include "stroma/deck/Section.hpp"
#include "stroma/particles/AxisLayout.hpp"

namespace stroma::sections {

deck::Section<particles::ParticleParameters> particles_section();

}  // namespace stroma::sections
