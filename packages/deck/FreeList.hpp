// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Strictness for the lists that are passed on to Trilinos packages.

#include <Teuchos_RCP.hpp>

#include "stroma/deck/Findings.hpp"

namespace Teuchos {
class ParameterList;
}

namespace stroma::deck {

/// Turns a section of any content into a list with the types that the deck declares (XML) or shows
/// (YAML, --set: 3 is an int, 3.0 a double, true a bool, [1, 2] an Array(int), the rest a string).
/// Its mistakes go to `findings`.
Teuchos::RCP<Teuchos::ParameterList> to_teuchos(const tree::List& section, Findings& findings);

/// Holds a list against the valid one of a Trilinos package: finds names that are not in `valid`
/// (with the nearest), values of another type, strings and numbers that the package's validator
/// refuses. Sublists that are empty in `valid` may hold anything.
void refuse_unknown(const Teuchos::ParameterList& list, const Teuchos::ParameterList& valid,
                    Findings& findings);

}  // namespace stroma::deck
