// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A run that finds the stiffness of a specimen.

#include <array>
#include <string>

#include "run/Simulation.hpp"
#include "stroma/mechanics/problem/StiffnessCases.hpp"

namespace stroma {

/// Reads the specimen, solves the load cases of Rig|Kind = Stiffness, and writes stiffness.csv and
/// stiffness.json to a folder, and a report of them. Collective.
/// \throws base::InputError before anything is run, when the input is wrong, or a restart or a time
///         limit is asked for
/// \throws base::RunError when a load case cannot be solved, or a file cannot be written
void run_stiffness(const base::Communicator& communicator, const Deck& deck,
                   const RunOptions& options, base::Log& log);

/// The boundaries that a deck asks for; without a word of it all that can be, with a note on those
/// that cannot. Says so where the mean strain of mixed conditions is not known.
/// \param face_shares  solid_shares_of_faces()
/// \throws base::InputError when it asks for a traction that cannot be
mechanics::NamedBoundaries possible_boundaries(const Deck& deck,
                                               const std::array<double, 6>& face_shares,
                                               base::Log& log);

/// Whether such a run has left a folder.
bool holds_stiffness(const std::string& folder);
/// Refuses a folder that such a run has left, for a command that needs load steps.
/// \param command  its name
/// \throws base::InputError
void refuse_stiffness_folder(const std::string& folder, const std::string& command);

}  // namespace stroma
