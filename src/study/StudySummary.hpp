// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a study prints at its end.

#include <string>
#include <vector>

#include "study/StudyComparison.hpp"
#include "study/StudyPlan.hpp"
#include "study/StudyTable.hpp"

namespace stroma {

/// The force of every member's drawn support over its steps; none where the member did not reach
/// full load, has no such support, or its history is not on this rank.
std::vector<std::optional<ForceRecord>> force_records(const StudyPlan& plan,
                                                      const std::vector<MemberResult>& results);

/// A line for each member: its force at full load, and the columns of the comparison in %. With a
/// heading; for the log.
std::vector<std::string> study_summary(const StudyPlan& plan,
                                       const std::vector<std::optional<ForceRecord>>& records,
                                       const ComparisonTable& comparison);

/// A line for each group: its force at element size 0, or why there is none.
std::vector<std::string> size_summary(const std::vector<SizeGroup>& groups);

}  // namespace stroma
