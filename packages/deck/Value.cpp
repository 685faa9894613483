// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/deck/Value.hpp"

#include <charconv>
#include <cmath>
#include <limits>

namespace stroma::deck {
namespace {

/// One entry of an array, or the one value of a scalar.
struct Entry {
  std::string text;
  bool is_quoted = false;  ///< by the quotes of YAML: a string, whatever it looks like
};

std::string in_quotes(const std::string& text) { return "\"" + text + "\""; }

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::size_t count_digits(const std::string& text, std::size_t from) {
  std::size_t end = from;
  while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
  return end - from;
}

/// [+-]digits
bool looks_like_integer(const std::string& text) {
  const std::size_t sign = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const std::size_t digits = count_digits(text, sign);
  return digits > 0 && sign + digits == text.size();
}

/// [+-]digits[.digits][e[+-]digits], digits on one side of the point at least: no nan, no
/// hexadecimals.
bool looks_like_number(const std::string& text) {
  std::size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  std::size_t digits = count_digits(text, at);
  at += digits;
  if (at < text.size() && text[at] == '.') {
    const std::size_t decimals = count_digits(text, at + 1);
    digits += decimals;
    at += 1 + decimals;
  }
  if (digits == 0) return false;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    const std::size_t exponent = count_digits(text, at);
    if (exponent == 0) return false;
    at += exponent;
  }
  return at == text.size();
}

/// Independent of the locale; the whole text, which has been found to look like a number.
template <class Number>
bool convert(const std::string& text, Number& number) {
  const char* begin = text.data() + (text[0] == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(begin, end, number);
  return failure == std::errc() && stop == end;
}

/// Reads one scalar; returns what is wrong, or nothing.
std::string read_entry(const Entry& entry, Scalar, std::string& value) {
  value = entry.text;
  return "";
}

std::string read_entry(const Entry& entry, Scalar, bool& value) {
  const std::string text = trimmed(entry.text);
  if (entry.is_quoted) return in_quotes(entry.text) + " is quoted: a string, not true or false";
  if (text != "true" && text != "false") return in_quotes(entry.text) + " is not true or false";
  value = text == "true";
  return "";
}

std::string read_entry(const Entry& entry, Scalar scalar, std::int64_t& value) {
  const std::string text = trimmed(entry.text);
  if (entry.is_quoted) return in_quotes(entry.text) + " is quoted: a string, not an integer";
  if (!looks_like_integer(text)) return in_quotes(entry.text) + " is not an integer";
  const bool fits = convert(text, value);
  const bool is_narrow = scalar == Scalar::integer;
  const auto low = is_narrow ? std::numeric_limits<std::int32_t>::min()
                             : std::numeric_limits<std::int64_t>::min();
  const auto high = is_narrow ? std::numeric_limits<std::int32_t>::max()
                              : std::numeric_limits<std::int64_t>::max();
  if (!fits || value < low || value > high) {
    return text + " is too large an integer (it must lie from " + std::to_string(low) + " to " +
           std::to_string(high) + ")";
  }
  return "";
}

std::string read_entry(const Entry& entry, Scalar, double& value) {
  const std::string text = trimmed(entry.text);
  if (entry.is_quoted) return in_quotes(entry.text) + " is quoted: a string, not a number";
  if (!looks_like_number(text)) return in_quotes(entry.text) + " is not a number";
  if (!convert(text, value))
    return text + " is too large or too small for a double-precision number";
  return "";
}

/// Cuts '{a, b}' (and, where no format rules, '[a, b]') into entries.
bool split_list(const std::string& text, bool allow_square, std::vector<Entry>& entries) {
  const std::string all = trimmed(text);
  const bool curly = all.size() >= 2 && all.front() == '{' && all.back() == '}';
  const bool square = allow_square && all.size() >= 2 && all.front() == '[' && all.back() == ']';
  if (!curly && !square) return false;
  const std::string inside = all.substr(1, all.size() - 2);
  if (trimmed(inside).empty()) return true;
  std::size_t from = 0;
  while (true) {
    const std::size_t comma = inside.find(',', from);
    entries.push_back({trimmed(inside.substr(from, comma - from)), false});
    if (comma == std::string::npos) return true;
    from = comma + 1;
  }
}

template <class Content>
Interpretation read_scalar(const Entry& entry, Scalar scalar) {
  Content content{};
  const std::string problem = read_entry(entry, scalar, content);
  if (!problem.empty()) return {std::nullopt, problem};
  return {Value(content), ""};
}

template <class Content>
Interpretation read_array(const std::vector<Entry>& entries, const ValueType& type) {
  if (type.length > 0 && entries.size() != type.length) {
    return {std::nullopt, "has " + std::to_string(entries.size()) +
                              (entries.size() == 1 ? " entry" : " entries") + " instead of " +
                              std::to_string(type.length)};
  }
  std::vector<Content> contents;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    Content content{};
    std::string problem = read_entry(entries[i], type.scalar, content);
    if constexpr (std::is_same_v<Content, std::string>) {
      // Teuchos writes string arrays without quotes, so these could not be read back from deck.xml.
      const bool unwritable =
          content.find_first_of(",{}") != std::string::npos || content != trimmed(content);
      if (content.empty()) problem = "is empty";
      if (unwritable)
        problem = in_quotes(content) + " holds a comma, a brace or a blank at its end";
    }
    if (!problem.empty()) return {std::nullopt, "entry " + std::to_string(i + 1) + ": " + problem};
    contents.push_back(std::move(content));
  }
  return {Value(std::move(contents)), ""};
}

/// A list of true and false is held as the words themselves: Teuchos has no such array.
Interpretation read_booleans(const std::vector<Entry>& entries) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    bool content = false;
    const std::string problem = read_entry(entries[i], Scalar::boolean, content);
    if (!problem.empty()) return {std::nullopt, "entry " + std::to_string(i + 1) + ": " + problem};
    words.emplace_back(content ? "true" : "false");
  }
  return {Value(std::move(words)), ""};
}

Interpretation read_scalar(const Entry& entry, const ValueType& type) {
  switch (type.scalar) {
    case Scalar::boolean:
      return read_scalar<bool>(entry, type.scalar);
    case Scalar::integer:
    case Scalar::long_integer:
      return read_scalar<std::int64_t>(entry, type.scalar);
    case Scalar::number:
      return read_scalar<double>(entry, type.scalar);
    case Scalar::text:
      break;
  }
  return read_scalar<std::string>(entry, type.scalar);
}

Interpretation read_array(const std::vector<Entry>& entries, const ValueType& type) {
  switch (type.scalar) {
    case Scalar::boolean:
      return read_booleans(entries);
    case Scalar::integer:
    case Scalar::long_integer:
      return read_array<std::int64_t>(entries, type);
    case Scalar::number:
      return read_array<double>(entries, type);
    case Scalar::text:
      break;
  }
  return read_array<std::string>(entries, type);
}

struct NamedType {
  const char* name;
  ValueType type;
};

/// The types of Teuchos that a deck knows.
const NamedType named_types[] = {
    {"bool", {Scalar::boolean, false, 0}},
    {"int", {Scalar::integer, false, 0}},
    {"long long", {Scalar::long_integer, false, 0}},
    {"double", {Scalar::number, false, 0}},
    {"string", {Scalar::text, false, 0}},
    {"Array(bool)", {Scalar::boolean, true, 0}},
    {"Array(int)", {Scalar::integer, true, 0}},
    {"Array(long long)", {Scalar::long_integer, true, 0}},
    {"Array(double)", {Scalar::number, true, 0}},
    {"Array(string)", {Scalar::text, true, 0}},
};

const ValueType* find_type(const std::string& name) {
  for (const NamedType& candidate : named_types) {
    if (name == candidate.name) return &candidate.type;
  }
  return nullptr;
}

/// An integer may stand for a number and for a longer integer.
bool may_stand_for(Scalar declared, Scalar wanted) {
  if (declared == wanted) return true;
  const bool is_integer = declared == Scalar::integer || declared == Scalar::long_integer;
  return (wanted == Scalar::number && is_integer) ||
         (wanted == Scalar::long_integer && declared == Scalar::integer);
}

std::string type_problem(const tree::Parameter& parameter, const ValueType& wanted) {
  const ValueType* declared = find_type(parameter.type);
  const std::string said = "type=" + in_quotes(parameter.type);
  if (declared == nullptr)
    return said + " is no type of a deck; write type=" + in_quotes(type_name(wanted));
  if (declared->is_array == wanted.is_array && may_stand_for(declared->scalar, wanted.scalar))
    return "";
  return said + " is the wrong type; write type=" + in_quotes(type_name(wanted));
}

std::vector<Entry> entries_of(const tree::Parameter& parameter) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < parameter.items.size(); ++i) {
    entries.push_back({parameter.items[i], parameter.quoted[i]});
  }
  return entries;
}

Entry entry_of(const tree::Parameter& parameter) {
  return {parameter.text, parameter.form == tree::Form::quoted_text};
}

/// The narrowest type that all entries can be read as.
ValueType guess(const std::vector<Entry>& entries) {
  static const Scalar by_preference[] = {Scalar::boolean, Scalar::integer, Scalar::long_integer,
                                         Scalar::number};
  for (const Scalar scalar : by_preference) {
    bool all = !entries.empty();
    for (const Entry& entry : entries)
      all = all && read_scalar(entry, {scalar, false, 0}).value.has_value();
    if (all) return {scalar, false, 0};
  }
  return {Scalar::text, false, 0};
}

/// Whether a parameter that may be a list or a word was given as a word.
bool is_word(const tree::Parameter& parameter) {
  if (parameter.form == tree::Form::sequence) return false;
  if (parameter.form == tree::Form::typed_text) return parameter.type == "string";
  const std::string text = trimmed(parameter.text);
  const bool is_bracketed = !text.empty() && (text.front() == '{' || text.front() == '[');
  return parameter.form != tree::Form::untyped_text || !is_bracketed;
}

/// Where a list of any length of numbers is asked for, a number alone is a list of one.
std::optional<Value> list_of_one(const tree::Parameter& parameter, const ValueType& type) {
  const bool is_free = type.is_array && type.length == 0 && type.scalar == Scalar::number;
  if (!is_free || parameter.form == tree::Form::sequence) return std::nullopt;
  const ValueType* declared = find_type(parameter.type);
  if (parameter.form == tree::Form::typed_text &&
      (declared == nullptr || declared->is_array || !may_stand_for(declared->scalar, type.scalar)))
    return std::nullopt;
  const Interpretation number = read_scalar(entry_of(parameter), {Scalar::number, false, 0});
  if (!number.value) return std::nullopt;
  return Value(std::vector<double>{std::get<double>(*number.value)});
}

}  // namespace

Interpretation interpret(const tree::Parameter& parameter, const ValueType& type) {
  using tree::Form;
  if (parameter.form == Form::nothing) return {std::nullopt, "has no value"};
  if (const auto list = list_of_one(parameter, type)) return {list, ""};
  if (type.or_word && is_word(parameter)) return read_scalar(entry_of(parameter), ValueType{});
  if (parameter.form == Form::typed_text) {
    const std::string problem = type_problem(parameter, type);
    if (!problem.empty()) return {std::nullopt, problem};
  }
  if (!type.is_array) {
    if (parameter.form != Form::sequence) return read_scalar(entry_of(parameter), type);
    return {std::nullopt, "is a list of " + std::to_string(parameter.items.size())};
  }
  if (parameter.form == Form::sequence) return read_array(entries_of(parameter), type);
  const bool is_yaml = parameter.form == Form::plain_text || parameter.form == Form::quoted_text;
  std::vector<Entry> entries;
  if (!is_yaml && split_list(parameter.text, parameter.form == Form::untyped_text, entries)) {
    return read_array(entries, type);
  }
  const std::string entries_meant = type.length == 3 ? "a, b, c" : "a, b";
  return {std::nullopt, in_quotes(parameter.text) + " is not a list; write " +
                            (is_yaml ? "[" + entries_meant + "]" : "{" + entries_meant + "}")};
}

Interpretation interpret_freely(const tree::Parameter& parameter, ValueType& type) {
  using tree::Form;
  if (parameter.form == Form::typed_text) {
    const ValueType* declared = find_type(parameter.type);
    type = declared != nullptr ? *declared : ValueType{};
  } else {
    std::vector<Entry> entries = entries_of(parameter);
    const bool is_list =
        parameter.form == Form::sequence ||
        (parameter.form == Form::untyped_text && split_list(parameter.text, true, entries));
    if (!is_list) entries = {entry_of(parameter)};
    type = guess(entries);
    type.is_array = is_list;
  }
  return interpret(parameter, type);
}

std::string type_name(const ValueType& type) {
  std::string name = "string";
  for (const NamedType& candidate : named_types) {
    if (candidate.type.scalar != type.scalar || candidate.type.is_array) continue;
    name = candidate.name;
    break;
  }
  return type.is_array ? "Array(" + name + ")" : name;
}

std::string print(double number) {
  char text[64];
  const auto [end, failure] = std::to_chars(text, text + sizeof text, number);
  return failure == std::errc() ? std::string(text, end) : std::string();
}

std::string print(const Value& value) {
  const auto one = [](const auto& content) -> std::string {
    using Content = std::decay_t<decltype(content)>;
    if constexpr (std::is_same_v<Content, bool>) return content ? "true" : "false";
    if constexpr (std::is_same_v<Content, std::int64_t>) return std::to_string(content);
    if constexpr (std::is_same_v<Content, double>) return print(content);
    if constexpr (std::is_same_v<Content, std::string>) return in_quotes(content);
  };
  return std::visit(
      [&one](const auto& content) -> std::string {
        if constexpr (detail::is_array<std::decay_t<decltype(content)>>::value) {
          std::string text;
          for (const auto& entry : content) text += (text.empty() ? "{" : ", ") + one(entry);
          return text.empty() ? "{}" : text + "}";
        } else {
          return one(content);
        }
      },
      value);
}

}  // namespace stroma::deck
