// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Members that differ in nothing but the size of their elements, and what their force tends to.

#include <vector>

#include "study/StudyPlan.hpp"
#include "study/StudyTable.hpp"

namespace stroma {

/// Force at full load against element size of every family of members that has at least two sizes
/// and was run; the force is that of the drawn support. For the rank that holds the histories.
std::vector<SizeGroup> size_groups(const StudyPlan& plan, const std::vector<MemberResult>& results);

}  // namespace stroma
