// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Members of a study held against other members: the columns of the table that need two runs.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/ForceDeparture.hpp"
#include "study/StudyDeck.hpp"
#include "study/StudyMembers.hpp"

namespace stroma {

/// The member that is like this one but for the thing of the pairing, and has its reference there.
/// None for the references themselves.
std::optional<std::size_t> reference_of(const Pairing& pairing, const std::vector<Member>& members,
                                        std::size_t member);

/// Columns of the table, a row for each member; what has no value is undefined.
struct ComparisonTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::optional<double>>> rows;  ///< (member, column) [-]
};

/// gain (with Gain: force at full load / that of the reference - 1), force_departure_rms,
/// force_departure_end (with Compare), secant_departure; see ForceDeparture.hpp.
/// \param records  of the members' drawn supports; none where a member did not reach full load
ComparisonTable compare(const Study& study, const std::vector<Member>& members,
                        const std::vector<std::optional<ForceRecord>>& records);

}  // namespace stroma
