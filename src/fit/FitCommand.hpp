// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// `stroma fit`: numbers of a deck for which its forces are those that were measured.

#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// Reads the deck of a fit, looks for the numbers that make
///
///     chi^2 = sum over the measured forces of ((force of the run - measured) / error)^2
///
/// least, by runs on all ranks together, each in a folder of its own, and writes fit.csv,
/// estimates.csv, fitted.csv and fit.png. A run that is there already is not made again. Collective.
///
/// \throws base::InputError when the deck, its base deck or a table is wrong: nothing was run
/// \throws base::RunError when the run at the start fails, or the search comes to no end
void fit_command(const base::Communicator& communicator, const std::string& fit_deck,
                 const std::string& output_folder, base::Log& log);

}  // namespace stroma
