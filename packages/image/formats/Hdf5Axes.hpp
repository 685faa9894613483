// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Which dimension of an HDF5 dataset is x, y, z, channel and time.

#include <hdf5.h>

#include <array>
#include <string>
#include <vector>

namespace stroma::image {

/// Dimensions of a dataset by their meaning; -1: the dataset has none. All others have one entry.
struct Hdf5Axes {
  std::array<int, 3> space{-1, -1, -1};  ///< x, y, z
  int channel = -1;
  int time = -1;
};

/// Finds the axes of a dataset with these extents: from the attribute `axistags` of vigra and
/// ilastik (JSON), from DIMENSION_LABELS (dimension scales), else [y][x], [z][y][x], [c][z][y][x],
/// [t][c][z][y][x] by the number of dimensions, with a note where that is likely wrong.
/// \param dataset  open
/// \param extents  of the dataset, the slowest axis first
/// \param path     of the file, and
/// \param name     of the dataset, for errors
/// \param notes    gains what the user should know
/// \throws base::InputError when tags contradict the dataset, or name axes of several entries that
///   are neither of x, y, z, c, t
Hdf5Axes find_axes(hid_t dataset, const std::vector<hsize_t>& extents, const std::string& path,
                   const std::string& name, std::vector<std::string>& notes);

/// The keys of an `axistags` attribute, in order: "zyxc"; a key of several letters becomes '?'.
/// Empty when the text is not such JSON.
std::string keys_of_axistags(const std::string& json);

}  // namespace stroma::image
