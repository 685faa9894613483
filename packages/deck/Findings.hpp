// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Collects the mistakes of a deck, so that the user hears of all of them at once.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "stroma/deck/Document.hpp"

namespace stroma::deck {

/// Where a rule puts what it finds. Names are relative to the section the rule belongs to:
/// add("Poisson Ratio", ...), add("collagen|Label", ...), or add("", ...) for the section itself;
/// the line is looked up.
///
/// A rule that needs more than the deck (the image, say) collects in the same manner:
///
///     Findings findings(document);
///     findings.add("Grid|Element Size [um]", "does not divide ...");
///     findings.throw_if_any();
class Findings {
 public:
  /// Findings about the whole deck.
  explicit Findings(const Document& document);

  void add(const std::string& parameter, const std::string& message);

  bool empty() const { return mistakes_->empty(); }
  std::size_t size() const { return mistakes_->size(); }

  /// \throws base::InputError  all that was found, ordered by line
  void throw_if_any() const;

  /// The same collection seen from a section inside this one. `section` may be null (a section that
  /// is not in the deck): its mistakes get the line of the innermost section that is.
  Findings inside(const std::string& name, const tree::List* section) const;
  /// The same for a section inside this one, looked up by its name.
  Findings below(const std::string& name) const;
  /// Adds what has been found elsewhere.
  void add(const std::vector<Mistake>& mistakes);
  /// Adds a mistake with a line of its own.
  void add(int line, const std::string& parameter, const std::string& message);
  /// Line of the section's opening tag, or of the innermost one around it that is in the deck.
  int line() const { return line_; }

 private:
  Findings() = default;

  std::string deck_;
  std::string where_;                    ///< path of this section
  const tree::List* section_ = nullptr;  ///< null: not in the deck
  int line_ = not_in_file;
  std::shared_ptr<std::vector<Mistake>> mistakes_;
};

}  // namespace stroma::deck
