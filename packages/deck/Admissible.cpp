// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/deck/Admissible.hpp"

#include <algorithm>

namespace stroma::deck {
namespace {

std::string noun(Scalar scalar, bool plural) {
  switch (scalar) {
    case Scalar::boolean:
      return plural ? "values true or false" : "true or false";
    case Scalar::integer:
    case Scalar::long_integer:
      return plural ? "integers" : "an integer";
    case Scalar::number:
      return plural ? "numbers" : "a number";
    case Scalar::text:
      break;
  }
  return plural ? "strings" : "a string";
}

std::string listed(const std::vector<std::string>& choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) text += i + 1 == choices.size() ? " or " : ", ";
    text += "\"" + choices[i] + "\"";
  }
  return text;
}

}  // namespace

bool Admissible::allows(const Value& value) const {
  const auto number_allowed = [this](auto number) {
    return !number_ || number_(static_cast<double>(number));
  };
  const auto text_allowed = [this](const std::string& text) { return !text_ || text_(text); };
  return std::visit(
      [&](const auto& content) {
        using Content = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<Content, bool>) {
          return true;
        } else if constexpr (std::is_arithmetic_v<Content>) {
          return number_allowed(content);
        } else if constexpr (std::is_same_v<Content, std::string>) {
          return text_allowed(content) && !(not_empty_ && content.empty());
        } else if constexpr (std::is_same_v<Content, std::vector<std::string>>) {
          return std::all_of(content.begin(), content.end(), text_allowed) &&
                 !(not_empty_ && content.empty());
        } else {
          return std::all_of(content.begin(), content.end(), number_allowed) &&
                 !(not_empty_ && content.empty());
        }
      },
      value);
}

std::string Admissible::describe(const ValueType& type) const {
  std::string condition = clause_.empty() ? "" : " " + clause_;
  if (!type.is_array) {
    if (!text_description_.empty()) return text_description_;
    return noun(type.scalar, false) + (not_empty_ ? " that is not empty" : "") + condition;
  }
  std::string text = "a list of ";
  if (type.length > 0) {
    text = std::to_string(type.length) + " ";
  } else if (not_empty_) {
    text += "one or more ";
  }
  text += noun(type.scalar, true);
  if (type.or_word)
    return text + (condition.empty() ? "" : ", each" + condition) + ", or " + text_description_;
  if (!text_description_.empty()) return text + ", each " + text_description_;
  return text + (condition.empty() ? "" : ", each" + condition);
}

Admissible any() { return {}; }

Admissible number_that(std::string clause, Admissible::NumberRule rule) {
  Admissible result;
  result.clause_ = std::move(clause);
  result.number_ = std::move(rule);
  return result;
}

Admissible text_that(std::string description, Admissible::TextRule rule) {
  Admissible result;
  result.text_description_ = std::move(description);
  result.text_ = std::move(rule);
  return result;
}

Admissible one_of(std::vector<std::string> choices) {
  Admissible result;
  result.text_description_ = listed(choices);
  result.choices_ = choices;
  result.text_ = [choices = std::move(choices)](const std::string& text) {
    return std::find(choices.begin(), choices.end(), text) != choices.end();
  };
  return result;
}

Admissible not_empty() {
  Admissible result;
  result.not_empty_ = true;
  return result;
}

Admissible or_one_of(Admissible entries, std::vector<std::string> words) {
  Admissible result = one_of(std::move(words));
  result.clause_ = std::move(entries.clause_);
  result.number_ = std::move(entries.number_);
  result.not_empty_ = true;
  return result;
}

Admissible positive() { return greater_than(0.0); }
Admissible not_negative() { return at_least(0.0); }

Admissible at_least(double least) {
  return number_that(">= " + print(least), [least](double x) { return x >= least; });
}
Admissible at_most(double most) {
  return number_that("<= " + print(most), [most](double x) { return x <= most; });
}
Admissible greater_than(double bound) {
  return number_that("> " + print(bound), [bound](double x) { return x > bound; });
}
Admissible less_than(double bound) {
  return number_that("< " + print(bound), [bound](double x) { return x < bound; });
}
Admissible between(double low, double high) {
  return number_that("from " + print(low) + " to " + print(high),
                     [low, high](double x) { return x >= low && x <= high; });
}
Admissible strictly_between(double low, double high) {
  return number_that("> " + print(low) + " and < " + print(high),
                     [low, high](double x) { return x > low && x < high; });
}

}  // namespace stroma::deck
