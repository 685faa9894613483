// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A deck that has been parsed but not yet been understood.

#include <string>
#include <utility>
#include <vector>

#include "stroma/deck/Tree.hpp"

namespace stroma::deck {

enum class Format { xml, yaml };

/// A parsed deck: a neutral tree with the line of everything in it, and the mistakes of form found
/// so far (duplicates, unknown XML attributes ...), which read() reports together with its own.
class Document {
 public:
  Document(std::string path, tree::List root, std::vector<Mistake> mistakes);

  /// The deck's file, as the user named it.
  const std::string& path() const { return path_; }
  /// The folder that relative file names of the deck start from ("." for the current one).
  std::string folder() const;
  /// A file name of the deck, as this process can open it: relative names start from folder().
  std::string resolve(const std::string& file) const;

  /// Line of 'Section|Sub|Parameter' (or of a section), or of the innermost section around it that
  /// is in the deck; not_in_file if that came from --set.
  int line(const std::string& path) const;

  /// Lays 'Section|Sub|Parameter' = value over the deck. Sections not yet there are made. The text
  /// is typed later, by the declaration; arrays are written {1, 2} or [1, 2]. A malformed path
  /// becomes a mistake that read() reports.
  void set(const std::string& parameter, const std::string& value);

  const tree::List& root() const { return root_; }
  const std::vector<Mistake>& mistakes() const { return mistakes_; }

 private:
  friend Document parse(const std::string& text, Format format, const std::string& path,
                        const std::vector<std::string>& overrides);
  void override_with(const std::vector<std::string>& overrides);

  std::string path_;
  tree::List root_;
  std::vector<Mistake> mistakes_;
};

/// Reads a deck: YAML if its name ends in .yaml or .yml, XML if in .xml.
/// \param path       of the deck's file
/// \param overrides  'Section|Sub|Parameter=value', as given to --set
/// \throws base::InputError  another ending; the file cannot be read or is not well-formed (the
///                           message has the line)
Document load(const std::string& path, const std::vector<std::string>& overrides = {});

/// The same from text; `path` only serves the messages and folder().
Document parse(const std::string& text, Format format, const std::string& path = "deck",
               const std::vector<std::string>& overrides = {});

/// Lays a parameter over a deck, for studies: the same as Document::set.
inline void set_parameter(Document& document, const std::string& parameter,
                          const std::string& value) {
  document.set(parameter, value);
}

}  // namespace stroma::deck
