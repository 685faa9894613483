// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// One run: the method of the paper, step by step.

#include <optional>
#include <string>

#include "run/Deck.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// What a run is asked beside its deck.
struct RunOptions {
  std::string folder;                ///< for its results
  bool is_restart = false;           ///< goes on from the checkpoint in the folder
  std::optional<double> time_limit;  ///< it ends by itself, with a checkpoint, before so many [s]
};

/// Reads the specimen, solves all load steps, writes everything to a folder. Collective.
/// \throws base::InputError before anything is run, when the input is wrong
/// \throws base::RunError when a step fails at the smallest size, a file cannot be written, or the
///         run is asked to stop; what was computed is on disk, and the message says how to go on
void run_simulation(const base::Communicator& communicator, const Deck& deck,
                    const RunOptions& options, base::Log& log);

}  // namespace stroma
