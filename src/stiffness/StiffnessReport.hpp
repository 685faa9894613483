// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// report.html of the folder of a run that has found a stiffness.

#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// Makes report.html of stiffness.json, deck.xml, log.txt and the deck's image. Says where it is.
/// Collective.
/// \throws base::InputError when it is no such folder
/// \throws base::RunError when a file of it cannot be read, or the report not be written
void stiffness_report(const base::Communicator& communicator, const std::string& folder,
                      base::Log& log);

}  // namespace stroma
