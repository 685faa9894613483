// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The tables of a study: study.csv and convergence.csv.

#include <array>
#include <string>
#include <vector>

#include "stroma/output/files/HistoryTable.hpp"
#include "stroma/output/pictures/Pictures.hpp"
#include "study/Richardson.hpp"
#include "study/StressBands.hpp"
#include "study/StudyComparison.hpp"
#include "study/StudyMembers.hpp"

namespace stroma {

enum class MemberStatus { waiting, done, failed };

/// What is known of one member once it has been run.
struct MemberResult {
  MemberStatus status = MemberStatus::waiting;
  output::HistoryTable history;  ///< empty: nothing on disk
};

/// What the tables need to know of a member's deck.
struct MemberFacts {
  std::vector<output::MovingSupport> moving;
  std::vector<std::string> materials;
  std::array<double, 3> element_size{};  ///< [um]
  VoxelLattice image;
};

/// Force of a support along its direction [pN] at each row of the history.
std::vector<double> force_along(const output::MovingSupport& support,
                                const output::HistoryTable& history);

/// How far a support moves along its direction at a factor of 1 [um].
double moved_along(const output::MovingSupport& support);

/// study.csv: a header, and a row for each member:
///
///     member, each variation, status (done, failed, waiting), load (reached), NAME.force of each
///     moving support (along its displacement, of draws along that of the draw that moves it farthest, pN), the columns of the comparison, strain_energy
///     [aJ], NAME.von_mises_mean of each material [Pa], newton_iterations and linear_iterations (of
///     all steps), wall_seconds, and what the deck asks for besides
///
/// Forces, energy and means are those at full load, 17 digits; they are empty for a member that has
/// not come to it, or has no such support, material, column or reference.
std::string study_table(const std::vector<Variation>& variations,
                        const std::vector<Member>& members, const std::vector<MemberFacts>& facts,
                        const std::vector<MemberResult>& results, const ComparisonTable& comparison,
                        const std::vector<std::string>& also);

/// The force at full load of members that differ in nothing but the size of their elements.
struct SizeGroup {
  std::string name;  ///< what its members have in common; empty: everything
  std::vector<SizedFigure> forces;
  RichardsonResult limit;
};

/// convergence.csv: a row for each group: series, sizes (number of them), finest_element_size [um],
/// finest_force, extrapolated_force [pN], order, remark. Empty where undefined; the remark says
/// why.
std::string convergence_table(const std::vector<SizeGroup>& groups);

}  // namespace stroma
