// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Guesses what a user meant by a name that is not known.

#include <string>
#include <vector>

namespace stroma::deck {

/// The known name that is nearest to a word: by the number of letters to insert, delete, replace or
/// swap with their neighbour, capitals and the unit in brackets not counted. Empty if none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& known);

/// What to tell the user about an unknown word: `did you mean "..."?`, or all known names if none
/// is near.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

}  // namespace stroma::deck
