// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the lists for Trilinos packages may hold. Ifpack2 and NOX ignore names they do not know, so
/// Stroma holds them against lists of its own.

#include <Teuchos_ParameterList.hpp>

#include "stroma/deck/Section.hpp"

namespace stroma::sections {

void check_nox(const Teuchos::ParameterList& list, deck::Findings& findings);
void check_belos(const Teuchos::ParameterList& list, deck::Findings& findings);
void check_ifpack2(const Teuchos::ParameterList& list, deck::Findings& findings);
void check_muelu(const Teuchos::ParameterList& list, deck::Findings& findings);

}  // namespace stroma::sections
