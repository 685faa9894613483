// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The tables of a fit: fit.csv, estimates.csv, fitted.csv, and what is printed.

#include <string>
#include <vector>

#include "fit/Estimate.hpp"
#include "fit/FitPlan.hpp"
#include "fit/FitRuns.hpp"

namespace stroma {

/// fit.csv: run (number, from 1), folder, status (done, failed), each number by its name, chi2.
std::string runs_table(const FitPlan& plan, const std::vector<FitRun>& runs);

/// estimates.csv: parameter (its name), path, value, standard_deviation, low, high (95 %),
/// correlation with NAME of each number. Empty where nothing is known.
std::string estimates_table(const FitPlan& plan, const std::vector<FittedNumber>& numbers,
                            const Estimate& estimate);

/// fitted.csv: measurement (its name), load (factor), strain_or_time, measured, error, fitted, start
/// (of the first run) [pN], against (strain or time).
std::string fitted_table(const FitPlan& plan, const FitRun& first, const FitRun& best);

/// What is printed at the end, in lines.
std::vector<std::string> fit_summary(const FitPlan& plan, const std::vector<FittedNumber>& numbers,
                                     const Estimate& estimate, const FitRun& best);

}  // namespace stroma
