// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Units of length as image files spell them.

#include <optional>
#include <string>

namespace stroma::image {

/// Micrometres in one unit, for the spellings that ImageJ, OME, NRRD and microscopes use: micron,
/// um, µm (UTF-8, Latin-1 or written as an escape, \\u00B5m), nm, mm, cm, m, inch, Å, pm and their
/// full names, in any case but for "Mm". Nothing for anything else, "pixel" and "" among it.
std::optional<double> micrometres_per(const std::string& unit);

/// The decimal number with the fewest digits that rounds to this float: 1.05 for 1.05f, where the
/// plain conversion to double gives 1.0499999523.
double shortest_decimal(float value);

}  // namespace stroma::image
