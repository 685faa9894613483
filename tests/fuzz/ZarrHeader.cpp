// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Any bytes as the JSON of a Zarr folder: refused with an InputError, or what they say holds
/// together.

#include "stroma/image/formats/ZarrHeader.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

#include "stroma/base/Error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace stroma;
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  try {
    const image::ZarrArray array = image::zarr_array("image.zarr", text);
    const bool is_good = array.shape.size() == array.chunk.size() && !array.shape.empty() &&
                         array.values() >= 1.0 && array.chunk_bytes() >= 1.0;
    if (!is_good) __builtin_trap();
  } catch (const base::InputError&) {
  }
  try {
    const auto image = image::zarr_image("image.zarr", text);
    for (std::size_t level = 0; image && level < image->levels.size(); ++level)
      if (image->levels[level].array.find("..") != std::string::npos) __builtin_trap();
  } catch (const base::InputError&) {
  }
  image::is_zarr_series(text);
  return 0;
}
