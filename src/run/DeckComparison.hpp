// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Whether a deck describes the body of another one.

#include <string>
#include <vector>

#include "run/Deck.hpp"

namespace stroma {

/// What a body is and how it is held: the deck as run, but for what may change while a run goes on
/// (title, loading, load curves, solver, output) and the names of image files, as XML.
std::string body_of_deck(const Deck& deck);

/// Where two such texts differ, a line each: "Grid|Element Size [um]: {2, 2, 2} there, {1, 1, 1} here".
/// \throws base::InputError when the first is no such text
std::vector<std::string> differences(const std::string& there, const std::string& here);

}  // namespace stroma
