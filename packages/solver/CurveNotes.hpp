// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the planned steps of a run make of a load curve.

#include <string>
#include <vector>

#include "stroma/mechanics/problem/LoadCurve.hpp"
#include "stroma/solver/SolverParameters.hpp"

namespace stroma::solver {

/// A curve that is 0 at all planned steps though it has other values; else its largest and smallest
/// value within the run, where no planned step comes nearer to them than 1 % of its range, and values
/// that it has after the end of the run only. What a curve is at time 0 no step has to meet.
///
/// \param name     the deck's
/// \param curve    the deck's
/// \param loading  the deck's, whose steps are taken as if none were rejected
std::vector<std::string> curve_notes(const std::string& name,
                                     const mechanics::LoadCurveParameters& curve,
                                     const LoadingParameters& loading);

/// What helps where the first step fails under a curve that is not 0 at time 0; empty for others.
///
/// \param name   the deck's
/// \param curve  the deck's
std::string advice_on_start(const std::string& name, const mechanics::LoadCurveParameters& curve);

}  // namespace stroma::solver
