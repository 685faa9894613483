// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// From the text of a deck to the neutral tree: one reader for each format.

#include <string>
#include <vector>

#include "stroma/base/Error.hpp"
#include "stroma/deck/Tree.hpp"

namespace stroma::deck {

/// Sections deeper than this are no deck (and would exhaust the stack).
constexpr std::size_t deepest_section = 50;

struct ParsedTree {
  tree::List root;
  std::vector<Mistake> mistakes;  ///< of form, where the rest could still be read
};

/// Reads `<ParameterList>` and `<Parameter name= type= value=/>`, as Teuchos writes them.
/// \throws base::InputError  not well-formed, with the line
ParsedTree parse_xml(const std::string& text, const std::string& path);

/// Reads one map in one map: the outer key is the name of the root section.
/// \throws base::InputError  malformed YAML, or YAML that is no deck (anchors, several documents)
ParsedTree parse_yaml(const std::string& text, const std::string& path);

/// The error for a deck that cannot be read to its end.
base::InputError malformed(const std::string& path, int line, const std::string& message);

}  // namespace stroma::deck
