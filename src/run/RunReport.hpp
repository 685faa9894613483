// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// report.html of a run's folder.

#include <array>
#include <functional>
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

/// Makes report.html of a folder whose page shows what its tables hold, as those of a study and of a
/// fit do. Says where it is. Collective.
/// \param what     "a study", say
/// \param table    the file by which such a folder is known
/// \param data_of  what the page shows, its title among it; called on rank 0
/// \throws base::InputError when it is no such folder, or a file of the report's name is none
/// \throws base::RunError when a file of it cannot be read, or the report not be written
void report_of_tables(const base::Communicator& communicator, const std::string& folder,
                      const std::string& what, const std::string& table,
                      const std::function<nlohmann::json(const output::RunFiles&)>& data_of,
                      base::Log& log);

/// What the first line of a log says that begins with a word, as "grid"; empty where none does.
std::string said_in(const std::string& log, const std::string& word);

/// What the page has to know of the supports that move along something.
/// \param length  edges of the body's box [um]
nlohmann::json described_supports(const DeckParameters& parameters,
                                  const std::array<double, 3>& length);

}  // namespace stroma
