// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// `stroma image`: what is in an image.

#include <array>
#include <optional>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// The options of `stroma image`.
struct ImageOptions {
  std::string file;
  std::string dataset;                              ///< --dataset, HDF5 only; empty: the only one
  int channel = 0;                                  ///< --channel
  int frame = 0;                                    ///< --frame, of a time series
  std::optional<std::array<double, 3>> voxel_size;  ///< --voxel [um]
};

/// Prints size, voxel size and where it was found, type, channels, intensity histogram, mean and
/// the like, Otsu's threshold, the fraction above it, and the connected objects there. Collective.
/// \returns the exit status 0
/// \throws base::InputError when the image cannot be read or a voxel size is not positive
int image_command(const base::Communicator& communicator, const ImageOptions& options,
                  base::Log& log);

}  // namespace stroma
