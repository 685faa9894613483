// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Fuzz target: any text, read as ImageJ's description of a stack.

#include "stroma/image/formats/ImageJDescription.hpp"

#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::string problem;
  const auto read = stroma::image::read_imagej(
      std::string(reinterpret_cast<const char*>(bytes), size), 6, problem);
  // Refused with a reason, or counts that agree and a calibration that is one.
  if (read ? read->channels * read->slices * read->frames != read->images ||
                 !std::isfinite(read->intercept) || read->slope == 0.0
           : problem.empty())
    std::abort();
  return 0;
}
