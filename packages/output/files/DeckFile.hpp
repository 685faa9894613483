// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// deck.xml: the deck as it was run, with the versions it ran with.

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <utility>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace stroma::output {

/// Names and versions of Stroma and of the libraries that decide a result: Trilinos, MPI, HDF5,
/// Exodus.
std::vector<std::pair<std::string, std::string>> library_versions();

/// Writes the deck (every default filled in) as a ParameterList in XML that `stroma run` reads
/// again. The versions stand in a comment at the head. Rank 0 writes. Collective.
/// \throws RunError on all ranks when the file cannot be written
void write_deck(const base::Communicator& communicator, const std::string& path,
                const Teuchos::ParameterList& deck);

}  // namespace stroma::output
