// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// One run of a family: whether it is there already, and how it is made.

#include <string>

#include "run/Deck.hpp"
#include "run/Simulation.hpp"
#include "stroma/base/Signals.hpp"

namespace stroma {

/// A list as deck.xml holds it.
std::string xml(const Teuchos::ParameterList& list);

/// Whether a folder holds a finished run of this deck: deck.xml says what this run's would, but for
/// the comment at its head, history.csv reached full load, and the image is not younger. For one
/// rank.
bool is_finished(const std::string& folder, const Deck& deck);

/// Runs a member. Collective.
/// \param name     of the member, for messages
/// \param options  its folder, and what else is asked of the run
/// \param signals  of the family: one that comes when a run is all but done ends the family, too
/// \return why it failed; empty when it did not
/// \throws base::Interrupted when a signal ends the family
std::string run_member(const base::Communicator& communicator, const std::string& name,
                       const Deck& deck, const RunOptions& options,
                       const base::StopRequests& signals);

/// What a family lays over its base deck comes as if from --set; its user wrote no such thing.
/// \param family  "the study"
std::string in_terms_of(const std::string& family, std::string message);

}  // namespace stroma
