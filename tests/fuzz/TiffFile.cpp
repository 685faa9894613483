// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Fuzz target: any bytes, read as a TIFF file: plain, ImageJ's, OME, MetaMorph's, Zeiss'.

#include "AnyImageFile.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return stroma::fuzz::read_image_file(bytes, size, stroma::image::open_tiff);
}
