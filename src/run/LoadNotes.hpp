// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Conditions and forces that are admissible, and yet often not what was meant.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "run/Deck.hpp"

namespace stroma {

/// A note for each motion by the body's whole length and more (per cent instead of shares), pair of
/// opposite faces that both strain the body, grip that strains (it takes of the length that is
/// strained), traction on what a condition holds on the same face (it goes into the support), and for
/// the one slice of a sheet, or the several of plane strain.
/// \param parameters  the deck's
/// \param length      edges of the body's box [um]
/// \param slices      of the image
std::vector<std::string> load_notes(const DeckParameters& parameters,
                                    const std::array<double, 3>& length, std::int64_t slices);

}  // namespace stroma
