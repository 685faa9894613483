// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Whether the packages of Trilinos take the lists that a deck has for them.

#include "stroma/base/Communicator.hpp"
#include "stroma/solver/SolverParameters.hpp"

namespace stroma::solver {

/// Solves a block of 4^3 elements with each list that is given, so that every object is built that
/// a run will build: what names and types do not show (counts, factors, methods) the packages find
/// out only then, and say so by exceptions of any type. Each rank solves for itself; takes some
/// milliseconds. Collective.
/// \throws base::InputError naming the section, when a package refuses its list, or when the block
///         cannot be solved with it
void try_lists(const base::Communicator& communicator, const SolverParameters& parameters);

}  // namespace stroma::solver
