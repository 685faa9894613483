// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Texts that can be written down again: into deck.xml, tables and result files.

#include <cstddef>
#include <string>
#include <vector>

#include "stroma/deck/Tree.hpp"

namespace stroma::deck {

/// Why a text is no line of characters in UTF-8 as XML knows them; empty if it is one. XML has no
/// control characters, and turns line breaks and tabs of an attribute into blanks.
std::string unwritable(const std::string& text);

/// The text as a line of UTF-8: bytes that are no such characters as "\x01".
std::string printable(const std::string& text);

/// Bytes that the name of a material, a condition or any other section named by the user may have:
/// netCDF's 256 less what the names of results add.
constexpr std::size_t longest_name = 200;

/// Every name and text of a deck that is no such line becomes a mistake, and its parameter is not
/// read.
void refuse_unwritable(tree::List& list, const std::string& path, std::vector<Mistake>& mistakes);

}  // namespace stroma::deck
