// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the lists for Trilinos packages may hold. Ifpack2 and NOX ignore names they do not know, so
/// Stroma holds them against lists of its own. MueLu's list holds those of its smoothers
/// (MueLuList.cpp).

#include <Teuchos_ParameterList.hpp>

#include "stroma/deck/Section.hpp"

namespace stroma::sections {

void check_nox(const Teuchos::ParameterList& list, deck::Findings& findings);
void check_belos(const Teuchos::ParameterList& list, deck::Findings& findings);
void check_ifpack2(const Teuchos::ParameterList& list, deck::Findings& findings);
void check_muelu(const Teuchos::ParameterList& list, deck::Findings& findings);

/// The admissible words of a parameter.
Teuchos::RCP<const Teuchos::ParameterEntryValidator> one_of(
    std::initializer_list<const char*> choices);

/// Finds what deck::refuse_unknown does, and numbers below zero where the package's own default is
/// not.
void check(const Teuchos::ParameterList& list, const Teuchos::ParameterList& valid,
           deck::Findings& findings);

}  // namespace stroma::sections
