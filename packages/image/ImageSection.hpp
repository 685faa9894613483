#pragma once

/// \file
/// The deck section "Image": name, unit, range, default and meaning of each parameter.

#include "deck/Section.hpp"
#include "image/ImageParameters.hpp"

namespace stroma::image {

deck::Section<ImageParameters> image_section();

}  // namespace stroma::image
