// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the reports of runs, stiffnesses, studies and fits have in common: how the page comes to be a
/// file.

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/report/ReportPage.hpp"

namespace stroma {

/// Collects what a page shows, its title among it: the data, on rank 0, and its arrays. Collective.
using ReportData =
    std::function<nlohmann::json(const output::RunFiles&, std::vector<output::PageArray>&)>;

/// Makes report.html of a folder, whole or not at all, in place of an earlier one. Says where it is.
/// Collective.
/// \param what    "a study", say
/// \param needed  the files by which such a folder is known
/// \throws base::InputError when it is no such folder, or a file of the report's name is none
/// \throws base::RunError when a file of it cannot be read, or the report not be written
void make_report(const base::Communicator& communicator, const std::string& folder,
                 const std::string& what, const std::vector<std::string>& needed,
                 const ReportData& collect, base::Log& log);

/// The same of a folder whose page shows what its tables hold, as those of a study and of a
/// fit do. Collective.
/// \param table    the file by which such a folder is known
/// \param data_of  what the page shows, its title among it; called on rank 0
void report_of_tables(const base::Communicator& communicator, const std::string& folder,
                      const std::string& what, const std::string& table,
                      const std::function<nlohmann::json(const output::RunFiles&)>& data_of,
                      base::Log& log);

/// Makes a report of what has just ended. Without one it has ended as well: a note says why.
void report_at_end(base::Log& log, const std::function<void()>& make);

/// log.txt, of a long one head and tail in whole lines: at most 200 kB.
std::string log_excerpt(const output::RunFiles& files);

/// What the first line of a log says that begins with a word, as "grid"; empty where none does.
std::string said_in(const std::string& log, const std::string& word);

}  // namespace stroma
