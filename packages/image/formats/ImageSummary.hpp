// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What an image file says of itself.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace stroma::image {

/// The size of a voxel and where it was found, axis by axis.
struct VoxelSize {
  std::array<double, 3> um{0.0, 0.0, 0.0};  ///< x, y, z [um]; 0: not stated
  std::array<std::string, 3> found_in{"", "",
                                      ""};  ///< e.g. "ImageJ tags", "OME attributes", "deck"

  bool known(int axis) const { return um[static_cast<std::size_t>(axis)] > 0.0; }
  bool complete() const { return known(0) && known(1) && known(2); }
  void set(int axis, double value_um, const std::string& source) {
    um[static_cast<std::size_t>(axis)] = value_um;
    found_in[static_cast<std::size_t>(axis)] = source;
  }
  /// The places, each named once: "ImageJ tags", or "TIFF resolution tags (x, y), deck (z)";
  /// "nowhere" if none.
  std::string source() const;
};

/// The type of a file's values.
struct ValueType {
  enum class Kind { unsigned_integer, signed_integer, floating };
  Kind kind = Kind::unsigned_integer;
  int bytes = 1;

  bool is_integer() const { return kind != Kind::floating; }
  /// "8-bit unsigned integer", "32-bit float", ...
  std::string name() const;
};

/// What an image file says of itself, and what of it was read.
struct ImageSummary {
  std::string path;
  std::vector<std::string> files;  ///< that it was read from: `path`, then those that it leads to
  std::string format;              ///< "TIFF, ImageJ hyperstack", "HDF5", ..., "phantom"
  std::array<std::int64_t, 3> file_size{0, 0, 0};  ///< voxels of the file: x, y, z
  std::array<std::int64_t, 3> size{0, 0, 0};       ///< voxels read: file_size, or the deck's region
  ValueType type;
  std::int64_t channels = 1;
  std::int64_t channel = 0;  ///< the one read, from 0
  std::int64_t frames = 1;   ///< of a time series
  std::int64_t frame = 0;    ///< the one read, from 0
  std::string dataset;       ///< HDF5 only
  VoxelSize voxel_size;
  std::vector<std::string> notes;  ///< what the user should know, a line each
};

}  // namespace stroma::image
