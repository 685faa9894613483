// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/deck/TeuchosValue.hpp"

#include <Teuchos_ParameterList.hpp>

namespace stroma::deck {
namespace {

template <class To, class From>
Teuchos::Array<To> array_of(const std::vector<From>& entries) {
  Teuchos::Array<To> result;
  for (const From& entry : entries) result.push_back(static_cast<To>(entry));
  return result;
}

}  // namespace

void set_parameter(Teuchos::ParameterList& list, const std::string& name, const Value& value,
                   const ValueType& type) {
  const bool is_long = type.scalar == Scalar::long_integer;
  std::visit(
      [&](const auto& content) {
        using Content = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<Content, std::int64_t>) {
          if (is_long) {
            list.set(name, static_cast<long long>(content));
          } else {
            list.set(name, static_cast<int>(content));
          }
        } else if constexpr (std::is_same_v<Content, std::vector<std::int64_t>>) {
          if (is_long) {
            list.set(name, array_of<long long>(content));
          } else {
            list.set(name, array_of<int>(content));
          }
        } else if constexpr (detail::is_array<Content>::value) {
          list.set(name, array_of<typename Content::value_type>(content));
        } else {
          list.set(name, content);
        }
      },
      value);
}

}  // namespace stroma::deck
