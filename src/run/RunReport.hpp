// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// report.html of a run's folder.

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "run/Deck.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/output/files/RunFolder.hpp"

namespace stroma {

/// Makes report.html of what a run has left in its folder: deck.xml and history.csv, and of
/// log.txt, particles.e, the tables and the deck's image what is there. Rank 0 holds no more of
/// particles and image than what the report shows, some ten megabytes. Says where it is. Collective.
/// \throws base::InputError when it is no such folder
/// \throws base::RunError when a file of it cannot be read, or the report not be written
void run_report(const base::Communicator& communicator, const std::string& folder, base::Log& log);

/// What the page has to know of the supports that move along something.
/// \param length  edges of the body's box [um]
nlohmann::json described_supports(const DeckParameters& parameters,
                                  const std::array<double, 3>& length);

}  // namespace stroma
