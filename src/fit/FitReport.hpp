// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// report.html of a fit's folder.

#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// Makes report.html of what a fit has left in its folder: fit.csv, log.txt, and of estimates.csv
/// and fitted.csv, which only a fit that came to its end leaves, what is there. Says where it is.
/// Collective.
/// \throws base::InputError when it is no such folder
/// \throws base::RunError when the report cannot be written
void fit_report(const base::Communicator& communicator, const std::string& folder, base::Log& log);

}  // namespace stroma
