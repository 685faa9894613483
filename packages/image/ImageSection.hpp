// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Image": name, unit, range, default and meaning of each parameter.

#include "stroma/deck/Section.hpp"
#include "stroma/image/ImageParameters.hpp"

namespace stroma::image {

deck::Section<ImageParameters> image_section();

}  // namespace stroma::image
