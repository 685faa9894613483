// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What two makers of microscopes put into TIFF files in tags of their own: MetaMorph (STK) and
/// Zeiss (LSM).

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stroma/image/formats/TiffDirectory.hpp"

namespace stroma::image {

/// A MetaMorph stack: its planes follow one another behind the only directory.
struct StkTags {
  std::int64_t planes = 1;
  std::array<std::optional<double>, 2> pixel_size;  ///< x, y, in `unit`
  std::string unit;
  std::vector<double> z_distances;  ///< of each plane from the one before [um]; where all are given
};

/// Nothing when the directory has none of MetaMorph's tags.
std::optional<StkTags> read_stk(TiffDirectory& directory);

/// A Zeiss LSM stack: a page for each plane, then frame; the channels are samples of its pixels.
struct LsmTags {
  std::int64_t planes = 1, channels = 1, frames = 1;
  std::array<double, 3> voxel_size{};  ///< x, y, z [m]; as it stands in the file
};

/// Nothing when the directory has no Zeiss tag.
std::optional<LsmTags> read_lsm(TiffDirectory& directory);

}  // namespace stroma::image
