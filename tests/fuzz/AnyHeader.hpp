// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the fuzz targets of the headers of images have in common.

#include <cstddef>
#include <cstdint>
#include <string>

#include "stroma/base/Error.hpp"
#include "stroma/image/formats/VolumeHeader.hpp"

namespace stroma::fuzz {

/// Reads any bytes as a header. It is refused with an InputError, or what it says holds together.
template <class Read>
int read_header(const std::uint8_t* bytes, std::size_t size, const Read& read) {
  try {
    const image::VolumeHeader header =
        read("folder/image", std::string(reinterpret_cast<const char*>(bytes), size));
    std::int64_t last =
        (header.channels - 1) * header.channel_stride + (header.frames - 1) * header.frame_stride;
    for (std::size_t d = 0; d < 3; ++d) last += (header.size[d] - 1) * header.stride[d];
    const bool within = last >= 0 && last < header.values;
    const auto files = static_cast<std::int64_t>(header.files.size());
    if (!within || files < 1 || header.values % files != 0) __builtin_trap();
  } catch (const base::InputError&) {
  }
  return 0;
}

}  // namespace stroma::fuzz
