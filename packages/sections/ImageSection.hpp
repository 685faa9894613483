// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Image".

#include "stroma/deck/Section.hpp"
#include "stroma/image/ImageParameters.hpp"

namespace stroma::sections {

deck::Section<image::ImageParameters> image_section();

}  // namespace stroma::sections
