// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// `stroma verify`: whether a folder of results is what a run left, and in balance.

#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// Checks a folder of results against its own deck.xml and images: checksums of the images, what
/// history.csv, particles.e, grid.e and lists of VTKHDF hold, and the equilibrium, reactions and energy of the last
/// step, computed anew from checkpoint.h5. Prints a line for each. Collective.
/// \throws base::InputError when it is no such folder, or its checkpoint is damaged or of another deck
/// \throws base::RunError when something is not as the run left it
void verify_command(const base::Communicator& communicator, const std::string& folder,
                    base::Log& log);

}  // namespace stroma
