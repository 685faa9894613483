// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What elements and particles are too few to resolve.

#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "run/Specimen.hpp"

namespace stroma {

/// A note for each axis along which splines have more functions than there are particles, and for each
/// material whose straight ways from wall to wall are shorter than two elements on the average: its
/// bending is not resolved. Axes along which a material goes through the whole image, and those of a
/// single slice, do not count; nor do materials that are a pressure.
std::vector<std::string> resolution_notes(const DeckParameters& parameters,
                                          const Specimen& specimen);

}  // namespace stroma
