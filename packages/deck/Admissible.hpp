// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a parameter may be: one condition that the reader tests, the errors quote and the reference
/// prints.

#include <functional>
#include <string>
#include <vector>

#include "stroma/deck/Value.hpp"

namespace stroma::deck {

/// A condition on a value. A condition on a number, an integer or a string holds for every entry of
/// an array of them.
class Admissible {
 public:
  using NumberRule = std::function<bool(double)>;
  using TextRule = std::function<bool(const std::string&)>;

  bool allows(const Value& value) const;
  /// The condition and the type in words, e.g. "3 numbers, each > 0".
  std::string describe(const ValueType& type) const;
  /// The admissible strings, if they can be listed.
  const std::vector<std::string>& choices() const { return choices_; }

 private:
  friend Admissible any();
  friend Admissible number_that(std::string clause, NumberRule rule);
  friend Admissible text_that(std::string description, TextRule rule);
  friend Admissible one_of(std::vector<std::string> choices);
  friend Admissible not_empty();
  friend Admissible or_one_of(Admissible entries, std::vector<std::string> words);

  std::string clause_;            ///< follows the type's name: "> 0"
  std::string text_description_;  ///< stands for the type's name: "some of the letters x, y, z"
  NumberRule number_;
  TextRule text_;
  bool not_empty_ = false;
  std::vector<std::string> choices_;
};

Admissible any();
Admissible positive();      ///< > 0
Admissible not_negative();  ///< >= 0
Admissible at_least(double least);
Admissible at_most(double most);
Admissible greater_than(double bound);
Admissible less_than(double bound);
Admissible between(double low, double high);           ///< both ends included
Admissible strictly_between(double low, double high);  ///< both ends excluded
/// A string that is not empty; an array with at least one entry.
Admissible not_empty();
/// One of these strings.
Admissible one_of(std::vector<std::string> choices);
/// A list with at least one entry, each under a condition on numbers, or one of these words.
Admissible or_one_of(Admissible entries, std::vector<std::string> words);
/// Any other condition on numbers, in words that follow "a number ", e.g. "that is a power of 2".
Admissible number_that(std::string clause, Admissible::NumberRule rule);
/// Any other condition on strings, in words, e.g. "some of the letters x, y and z, each once".
Admissible text_that(std::string description, Admissible::TextRule rule);
/// For the reader's eye: conditions hold for each entry of an array in any case.
inline Admissible each(Admissible condition) { return condition; }

}  // namespace stroma::deck
