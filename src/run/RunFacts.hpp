// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a run must be traced back to, beside its deck and the program.

#include <ctime>
#include <string>
#include <vector>

#include "run/KnownFiles.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/ProgramFacts.hpp"

namespace stroma {

/// Ranks, threads of a rank, the machines ("2 (node07, node08)"), the start in UTC
/// (ISO 8601), and of each file that was read its absolute path, size [bytes] and SHA-256; rank 0's
/// answer counts. Collective.
/// \param communicator  of the ranks of the run
/// \param start         of the run
/// \param files         that it was read from
output::Facts run_facts(const base::Communicator& communicator, std::time_t start,
                        const std::vector<KnownFile>& files);

}  // namespace stroma
