// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Where in an HDF5 file the image is: programs that spread images over many datasets.

#include <hdf5.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/ImageSummary.hpp"

namespace stroma::image {

/// The dataset to read, and what the file says of it outside of it.
struct Hdf5Place {
  std::string format = "HDF5";
  std::string dataset;        ///< path, without a slash in front
  bool has_own_axes = true;   ///< false: channels and frames are datasets of their own, as below
  std::int64_t channels = 1;  ///< that Image|Channel chooses from
  std::int64_t frames = 1;    ///< that Image|Frame chooses from
  std::optional<std::array<std::int64_t, 3>> size;  ///< x, y, z of the image; the rest is padding
  bool meant_unsigned = false;  ///< signed integers of the file stand for unsigned ones
  VoxelSize voxel_size;
  std::vector<std::string> files;  ///< read beside the HDF5 file itself
  std::vector<std::string> notes;
};

/// Finds the dataset that is asked for, or the only one; in files of Imaris and BigDataViewer the
/// finest resolution of a channel and frame, with the voxel size that they state.
///
/// Imaris: `DataSet/ResolutionLevel R/TimePoint T/Channel C/Data`, padded to whole chunks; the size
/// is in the attributes ImageSizeX, Y, Z of the group, the extents are ExtMin0 to ExtMax2 of
/// `DataSetInfo/Image`. BigDataViewer: `tTTTTT/sSS/L/cells` with 16-bit values that are stored
/// signed and meant unsigned; the voxel size is in the .xml file beside it.
/// \throws base::InputError when there is none, or several and none is named
Hdf5Place find_place(hid_t file, const ImageRequest& request);

/// The voxel size of a view setup in the XML that belongs to a BigDataViewer file. Axes are left
/// unknown where it states none, with a note.
VoxelSize voxel_size_of_view(const std::string& xml, std::int64_t setup,
                             std::vector<std::string>& notes);

}  // namespace stroma::image
