// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// report.html of a study's folder.

#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// Makes report.html of what a study has left in its folder: study.csv, convergence.csv, bands.csv,
/// correlations.csv, log.txt,
/// and of each member its deck and history. Says where it is. Collective.
/// \throws base::InputError when it is no such folder
/// \throws base::RunError when the report cannot be written
void study_report(const base::Communicator& communicator, const std::string& folder,
                  base::Log& log);

}  // namespace stroma
