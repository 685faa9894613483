// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The pictures of a study, from what is known of its members.

#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"
#include "study/StudyPlan.hpp"
#include "study/StudyTable.hpp"

namespace stroma {

/// Draws force_strain.png, force_element_size.png and von_mises.png, as the deck asks, into the
/// study's folder; what could not be drawn is a note in the log. Collective; histories and groups
/// are rank 0's.
void draw_study(const base::Communicator& communicator, const StudyPlan& plan,
                const std::vector<MemberResult>& results, const std::vector<SizeGroup>& groups,
                const std::string& folder, base::Log& log);

}  // namespace stroma
