// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// deck.xml: the deck as it was run, with what it was run by and on.

#include <Teuchos_ParameterList.hpp>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/ProgramFacts.hpp"

namespace stroma::output {

/// Writes the deck (every default filled in) as a ParameterList in XML that `stroma run` reads
/// again. A comment at the head lists the facts of the program and those of the run; two hyphens in
/// a row, which XML forbids there, become "- ". Rank 0 writes. Collective.
/// \param communicator  of the ranks that run the deck
/// \param path          of the file
/// \param deck          with every default
/// \param of_the_run    what is to be told beside program_facts(); rank 0's counts
/// \throws RunError on all ranks when the file cannot be written
void write_deck(const base::Communicator& communicator, const std::string& path,
                const Teuchos::ParameterList& deck, const Facts& of_the_run);

}  // namespace stroma::output
