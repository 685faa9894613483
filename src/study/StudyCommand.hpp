// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// `stroma study`: runs a family of decks that differ in named parameters.

#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// Reads a study deck, checks every member as `stroma check` does, runs those that are not
/// finished, each in a folder of its own on all ranks together, and writes study.csv,
/// convergence.csv, force_strain.png and force_element_size.png.
///
/// A member is finished when its deck.xml says what this run's would, its history.csv reached full
/// load, and its image is not younger. A member that fails does not stop the others. Collective.
///
/// \throws base::InputError when the study deck or a member's is wrong: nothing was run
/// \throws base::RunError at the end, when members failed
void study_command(const base::Communicator& communicator, const std::string& study_deck,
                   const std::string& output_folder, base::Log& log);

}  // namespace stroma
