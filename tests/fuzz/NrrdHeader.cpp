// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Fuzz target: any bytes, read as the header of NRRD.

#include "AnyHeader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return stroma::fuzz::read_header(bytes, size, stroma::image::nrrd_header);
}
