// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// ImageJ's description of a stack: lines "key=value" in the first page of a TIFF file.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stroma::image {

/// What the description says, with ImageJ's own defaults where it is silent.
struct ImageJDescription {
  /// Planes of a hyperstack: channel fastest, then slice, then frame.
  std::int64_t images = 1, channels = 1, slices = 1, frames = 1;
  std::string unit, y_unit, z_unit;  ///< of lengths; empty: none
  std::optional<double> spacing;     ///< of the slices, in z_unit
  /// value = intercept + slope x stored value, where ImageJ calibrates values by a straight line.
  double intercept = 0.0, slope = 1.0;
  std::vector<std::string> notes;  ///< what of it cannot be used

  bool calibrated() const { return intercept != 0.0 || slope != 1.0; }
};

bool is_imagej(const std::string& description);

/// \param description  the text of the first page's ImageDescription
/// \param pages        of the file: the images, where the description does not count them
/// \param problem      what is wrong with the counts, if nothing is returned: not numbers, below
///                     1, or channels x slices x frames are not the images
std::optional<ImageJDescription> read_imagej(const std::string& description, std::int64_t pages,
                                             std::string& problem);

}  // namespace stroma::image
