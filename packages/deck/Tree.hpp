// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A deck as it stands in its file, before anybody asks what it means: names, texts and line
/// numbers. XML and YAML are read into the same tree, so that everything behind it knows one format
/// only.

#include <string>
#include <vector>

namespace stroma::deck {

/// Line of what was given on the command line (--set) instead of in the file.
constexpr int not_in_file = 0;

/// One mistake of the user. Its line is that of the file, or not_in_file.
struct Mistake {
  int line = not_in_file;
  std::string where;  ///< 'Section|Sub|Parameter', or empty for the deck as a whole
  std::string message;
};

namespace tree {

/// How the value of a parameter is written. Text that carries no type (--set) may be anything.
enum class Form { typed_text, plain_text, quoted_text, sequence, untyped_text, nothing };

/// `<Parameter name= type= value=/>`, `name: value` or `name=value`: text not yet interpreted.
struct Parameter {
  std::string name;
  int line = not_in_file;
  Form form = Form::untyped_text;
  std::string type;                ///< the type XML declares; empty in YAML and --set
  std::string text;                ///< unless it is a sequence
  std::vector<std::string> items;  ///< the entries of a YAML sequence
  std::vector<bool> quoted;        ///< for each entry: was it in quotes
  bool broken = false;             ///< a mistake of it has been reported: do not read it
};

/// `<ParameterList name=>` or a YAML map.
struct List {
  std::string name;
  int line = not_in_file;
  std::vector<Parameter> parameters;
  std::vector<List> lists;

  const Parameter* parameter(const std::string& wanted) const;  ///< the first of that name, or null
  const List* list(const std::string& wanted) const;            ///< the first of that name, or null
};

}  // namespace tree
}  // namespace stroma::deck
