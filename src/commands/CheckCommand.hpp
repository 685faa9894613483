// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// `stroma check`: reads everything, runs nothing, says what a run would be.

#include "run/Deck.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// Prints what the deck describes: the image, its volume fractions (whole and per slice), connected
/// objects and their width in elements, the counts of particles, elements and unknowns, and the
/// memory that a run needs per rank. Collective. \throws base::InputError when the input is wrong,
/// as a run would
void check_command(const base::Communicator& communicator, const Deck& deck, base::Log& log);

}  // namespace stroma
