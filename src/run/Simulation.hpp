// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// One run: the method of the paper, step by step.

#include <string>

#include "run/Deck.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// Reads the specimen, solves all load steps, writes everything to a folder. Collective.
/// \throws base::InputError before anything is run, when the input is wrong
/// \throws base::RunError when a step fails at the smallest size; what was computed is on disk
void run_simulation(const base::Communicator& communicator, const Deck& deck,
                    const std::string& output_folder, base::Log& log);

}  // namespace stroma
