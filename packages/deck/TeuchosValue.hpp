// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// From a value of a deck to an entry of a Teuchos list.

#include <string>

#include "stroma/deck/Value.hpp"

namespace Teuchos {
class ParameterList;
}

namespace stroma::deck {

/// Sets a parameter with the C++ type that Teuchos gives to the same declaration in XML: int, long
/// long, double, bool, std::string, or Teuchos::Array of one of them.
void set_parameter(Teuchos::ParameterList& list, const std::string& name, const Value& value,
                   const ValueType& type);

}  // namespace stroma::deck
