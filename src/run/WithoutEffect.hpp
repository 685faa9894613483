// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a deck says without any effect on its run.

#include <string>
#include <vector>

#include "run/Deck.hpp"

namespace stroma {

/// Whether anything follows the load curve of a name.
bool is_followed(const DeckParameters& parameters, const std::string& curve);

/// A note for each parameter that differs from its default but is read by nothing, since what would
/// read it was not chosen, and for each load curve that nothing follows.
std::vector<std::string> notes_without_effect(const DeckParameters& parameters);

}  // namespace stroma
