// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// `stroma report`.

#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// Makes report.html of a folder that a run, a study or a fit has left. Collective.
/// \throws base::InputError when it is of none
/// \throws base::RunError when a file cannot be read, or the report not be written
void report_command(const base::Communicator& communicator, const std::string& folder,
                    base::Log& log);

}  // namespace stroma
