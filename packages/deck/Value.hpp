// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The values a parameter can have, and how they follow, strictly, from the text in the deck.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "stroma/deck/Tree.hpp"

namespace stroma::deck {

enum class Scalar { boolean, integer, long_integer, number, text };

/// The type of a parameter: one scalar, or an array of them.
struct ValueType {
  Scalar scalar = Scalar::text;
  bool is_array = false;
  std::size_t length = 0;  ///< entries of an array; 0: any number
  bool or_word = false;    ///< a word may stand in the place of the array
};

using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<std::int64_t>,
                           std::vector<double>, std::vector<std::string>>;

/// A value, or what is wrong with the text.
struct Interpretation {
  std::optional<Value> value;
  std::string problem;
};

/// Reads a parameter as a value of a type. Nothing is repaired: the whole text must be one number,
/// one of true and false, or a bracketed list of the right length; integers and numbers must fit
/// their type and be finite; a type declared in XML must be the type asked for (integers may stand
/// for numbers, and a number for a list of any length of numbers).
Interpretation interpret(const tree::Parameter& parameter, const ValueType& type);

/// The same when nothing but the text says what the type is: int, long long, double, bool, string
/// or an array of one of them, as XML declares or as YAML looks like. An array of bool becomes its
/// words, "true" and "false".
Interpretation interpret_freely(const tree::Parameter& parameter, ValueType& type);

/// Name of the type in XML, e.g. Array(double).
std::string type_name(const ValueType& type);
/// A value as the deck would say it; strings in quotes.
std::string print(const Value& value);
/// The shortest decimal text that reads back as the same double.
std::string print(double number);

namespace detail {

template <class V>
struct is_array : std::false_type {};
template <class E>
struct is_array<std::vector<E>> : std::true_type {};
template <class E, std::size_t N>
struct is_array<std::array<E, N>> : std::true_type {};

template <class V>
struct array_or_word : std::false_type {};
template <class A>
struct array_or_word<std::variant<A, std::string>> : is_array<A> {
  using array = A;
};

template <class V>
struct is_optional : std::false_type {};
template <class V>
struct is_optional<std::optional<V>> : std::true_type {};

template <class V>
struct unwrap {
  using type = V;
};
template <class V>
struct unwrap<std::optional<V>> {
  using type = V;
};
template <class V>
using without_optional = typename unwrap<V>::type;

/// The alternative of Value's scalars that holds a C++ scalar.
template <class E>
struct held {
  using type = std::int64_t;
  static constexpr Scalar scalar = sizeof(E) > 4 ? Scalar::long_integer : Scalar::integer;
  static_assert(std::is_same_v<E, int> || std::is_same_v<E, std::int64_t>,
                "not a type of a parameter");
};
template <>
struct held<bool> {
  using type = bool;
  static constexpr Scalar scalar = Scalar::boolean;
};
template <>
struct held<double> {
  using type = double;
  static constexpr Scalar scalar = Scalar::number;
};
template <>
struct held<std::string> {
  using type = std::string;
  static constexpr Scalar scalar = Scalar::text;
};

template <class E, std::size_t N>
constexpr std::size_t fixed_length(const std::array<E, N>*) {
  return N;
}
template <class E>
constexpr std::size_t fixed_length(const std::vector<E>*) {
  return 0;
}

template <class V>
ValueType value_type() {
  if constexpr (array_or_word<V>::value) {
    ValueType type = value_type<typename array_or_word<V>::array>();
    type.or_word = true;
    return type;
  } else if constexpr (is_array<V>::value) {
    return {held<typename V::value_type>::scalar, true,
            fixed_length(static_cast<const V*>(nullptr))};
  } else {
    return {held<V>::scalar, false, 0};
  }
}

template <class V>
Value to_value(const V& member) {
  if constexpr (array_or_word<V>::value) {
    const std::string* word = std::get_if<std::string>(&member);
    return word != nullptr ? Value(*word) : to_value(std::get<0>(member));
  } else if constexpr (is_array<V>::value) {
    return std::vector<typename held<typename V::value_type>::type>(member.begin(), member.end());
  } else {
    return static_cast<typename held<V>::type>(member);
  }
}

template <class V>
V from_value(const Value& value) {
  if constexpr (array_or_word<V>::value) {
    const std::string* word = std::get_if<std::string>(&value);
    return word != nullptr ? V(*word) : V(from_value<typename array_or_word<V>::array>(value));
  } else if constexpr (is_array<V>::value) {
    using E = typename V::value_type;
    const auto& entries = std::get<std::vector<typename held<E>::type>>(value);
    V member{};
    if constexpr (std::is_same_v<V, std::vector<E>>) member.resize(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) member[i] = static_cast<E>(entries[i]);
    return member;
  } else {
    return static_cast<V>(std::get<typename held<V>::type>(value));
  }
}

}  // namespace detail
}  // namespace stroma::deck
