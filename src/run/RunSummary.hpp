// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a run says at its end.

#include <vector>

#include "run/MovingSupports.hpp"
#include "run/Specimen.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/output/files/History.hpp"

namespace stroma {

/// A table of all steps, bounds of the stiffness, and what it took of time, memory and messages.
/// Collective.
/// \param log           where to
/// \param communicator  of the ranks that share the body
/// \param deck          of the run
/// \param specimen      its particles and grid
/// \param rows          of the steps accepted so far, of load 0 first
/// \param moving        the supports whose force is of interest
/// \param balance       of the last of these steps
/// \param u             its displacement [um]
void print_summary(base::Log& log, const base::Communicator& communicator, const Deck& deck,
                   const Specimen& specimen, const std::vector<output::HistoryRow>& rows,
                   const std::vector<output::MovingSupport>& moving,
                   const mechanics::MomentumBalance& balance, const grid::Vector& u);

/// What it took of time, memory and messages. Collective.
void print_costs(base::Log& log, const base::Communicator& communicator, const Deck& deck,
                 const grid::Partition& partition);

}  // namespace stroma
