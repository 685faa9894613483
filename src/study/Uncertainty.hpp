// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the draws of a study tell: draws.csv, bands.csv, correlations.csv, force_band.png,
/// von_mises_05.tif, von_mises_50.tif, von_mises_95.tif.

#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"
#include "study/StudyPlan.hpp"
#include "study/StudyTable.hpp"

namespace stroma {

/// The members of a study with draws: one with all inputs at their medians ("middle"), the same on
/// finer elements ("middle on finer elements") if these are asked for, and the draws.
Variation draws_of(const UncertaintyParameters& uncertainty);

/// What a user should know before the draws run: inputs that follow each other by chance, and that
/// there is no force to tell bands of where no support moves.
std::vector<std::string> uncertainty_notes(const StudyPlan& plan);

/// Writes the tables and pictures of the draws that reached full load, and prints what they tell;
/// with fewer than five there is nothing to tell but that. Collective; histories are rank 0's.
/// \throws base::RunError when a file cannot be read or written
void tell_uncertainty(const base::Communicator& communicator, const StudyPlan& plan,
                      const std::vector<MemberResult>& results, const std::string& folder,
                      base::Log& log);

}  // namespace stroma
