// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Tables of measured forces.

#include <string>
#include <vector>

#include "fit/FitDeck.hpp"

namespace stroma {

/// One measured force.
struct MeasuredForce {
  double abscissa = 0.0;  ///< strain [-] or time [s]
  double force = 0.0;     ///< of the support on the body [pN]
  double error = 0.0;     ///< standard deviation [pN], > 0
};

/// Reads a table, in the order of its rows. For one rank.
/// \param path        of the CSV file
/// \param parameters  its columns, unit and errors
/// \throws base::InputError naming row and column of what is no number, and columns that are missing
std::vector<MeasuredForce> read_measurement(const std::string& path,
                                            const MeasurementParameters& parameters);

}  // namespace stroma
