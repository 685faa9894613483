// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Where the specimen comes from and how it is segmented.

#include <array>
#include <optional>
#include <string>

#include "stroma/image/labels/SegmentationParameters.hpp"
#include "stroma/image/phantom/Phantom.hpp"

namespace stroma::image {

/// The specimen: a file or a phantom, never both.
struct ImageParameters {
  std::optional<std::string> file;                  ///< relative to the deck's folder
  std::optional<std::string> dataset;               ///< HDF5 only; absent: the only one of the file
  int channel = 0;                                  ///< from 0
  int frame = 0;                                    ///< of a time series, from 0
  std::optional<std::array<double, 3>> voxel_size;  ///< x, y, z [um]; absent: the file's own
  std::optional<std::array<int, 6>> region;  ///< first voxel x, y, z, then counts; absent: all
  SegmentationParameters segmentation;
  std::optional<PhantomParameters> phantom;
};

}  // namespace stroma::image
