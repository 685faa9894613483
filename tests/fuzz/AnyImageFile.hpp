// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Reads any bytes as an image file, without MPI.

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "stroma/base/Error.hpp"
#include "stroma/image/formats/ImageSource.hpp"

namespace stroma::fuzz {

/// Any exception but InputError, and any fault of memory, ends the fuzzer.
/// \param open  image::open_tiff or image::open_pic
template <class Open>
int read_image_file(const std::uint8_t* bytes, std::size_t size, const Open& open) {
  static const std::string path = [] {
    char folder[] = "/tmp/stroma_fuzz_XXXXXX";
    if (mkdtemp(folder) == nullptr) std::abort();
    return std::string(folder) + "/image";
  }();
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  image::ImageRequest request;
  request.path = path;
  try {
    const auto source = open(request);
    const auto& count = source->summary().file_size;
    voxels::Box last{{0, 0, count[2] - 1}, {count[0], count[1], 1}};
    if (last.voxels() > (1 << 22)) return 0;  // as said and packed; too slow here
    std::vector<double> values(static_cast<std::size_t>(last.voxels()));
    source->read(last, values.data());
  } catch (const base::InputError&) {
  }
  return 0;
}

}  // namespace stroma::fuzz
