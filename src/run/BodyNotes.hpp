// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a user should know of a body on its grid.

#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "run/Specimen.hpp"

namespace stroma {

/// Notes on supports and pieces, on bodies of the image that the grid joins, on pressures, barely
/// filled elements and contrast. Collective.
/// \param specimen  of which the balance is
std::vector<std::string> body_notes(const Deck& deck, const Specimen& specimen,
                                    const mechanics::MomentumBalance& balance);

}  // namespace stroma
