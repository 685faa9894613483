// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Output".

#include "stroma/deck/Section.hpp"
#include "stroma/output/OutputParameters.hpp"

namespace stroma::sections {

deck::Section<output::OutputParameters> output_section();

}  // namespace stroma::sections
