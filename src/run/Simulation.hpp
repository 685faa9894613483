// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// One run: the method of the paper, step by step.

#include <functional>
#include <optional>
#include <string>

#include "run/Deck.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/solver/NewtonSolver.hpp"

namespace stroma {

/// An accepted step, whose row is in history.csv.
struct AcceptedStep {
  const output::HistoryRow& row;
  mechanics::MomentumBalance& balance;
  const grid::Vector& u;  ///< its displacement [um]
  solver::NewtonSolver& newton;
};

/// What a run is asked beside its deck.
struct RunOptions {
  std::string folder;                ///< for its results
  bool is_restart = false;           ///< goes on from the checkpoint in the folder
  std::optional<double> time_limit;  ///< it ends by itself, with a checkpoint, before so many [s]
  /// Called after each accepted step; it may throw what a run may. Collective.
  std::function<void(const AcceptedStep&)> accepted = {};
};

/// Reads the specimen, solves all load steps, writes everything to a folder. Collective.
/// \throws base::InputError before anything is run, when the input is wrong
/// \throws base::RunError when a step fails at the smallest size, a file cannot be written, or the
///         run is asked to stop; what was computed is on disk, and the message says how to go on
void run_simulation(const base::Communicator& communicator, const Deck& deck,
                    const RunOptions& options, base::Log& log);

}  // namespace stroma
