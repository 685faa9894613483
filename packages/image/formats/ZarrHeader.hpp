// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the JSON files of a Zarr folder (format 2) and of OME-Zarr (0.1 to 0.4) say. The functions
/// look at nothing but the text they are given.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stroma/image/formats/Compression.hpp"
#include "stroma/image/formats/ImageSummary.hpp"

namespace stroma::image {

/// An array, cut into chunks of one size.
struct ZarrArray {
  std::vector<std::int64_t> shape, chunk;  ///< slowest first; at most most_dimensions
  ValueType type;
  bool is_swapped = false;   ///< bytes of a value are not in this machine's order
  bool is_columnar = false;  ///< in a chunk, the first dimension runs fastest
  Compression compression = Compression::none;
  double fill = 0.0;     ///< of chunks that were never written
  char separator = '.';  ///< of a chunk's numbers in its file's name

  double values() const;       ///< of the whole array
  double chunk_bytes() const;  ///< unpacked
};

/// \param path  of the folder, for errors
/// \param text  of its .zarray
/// \throws base::InputError: not whole, contradictory, or of a kind that is not read
ZarrArray zarr_array(const std::string& path, const std::string& text);

/// A dimension, in the order of the array's.
struct ZarrAxis {
  char key = '?';      ///< one of x, y, z, c, t; else '?'
  std::string unit;    ///< empty: not stated
  double scale = 0.0;  ///< from one value to the next, in that unit; 0: not stated
};

/// One of the scales of an image.
struct ZarrLevel {
  std::string array;           ///< folder within that of the image
  std::vector<ZarrAxis> axes;  ///< empty: not stated
};

/// An image at several scales.
struct ZarrImage {
  std::string version;            ///< of OME-Zarr
  std::vector<ZarrLevel> levels;  ///< at least one; by the standard, the finest is the first
  std::size_t images = 1;         ///< that the text tells of
};

/// \param path  of the folder, for errors
/// \param text  of its .zattrs
/// \return  nothing where the text is of no image: without multiscales
/// \throws base::InputError: not whole, or contradictory
std::optional<ZarrImage> zarr_image(const std::string& path, const std::string& text);

/// The axes of an array by its .zattrs as xarray writes them (_ARRAY_DIMENSIONS); empty: not stated.
/// \param path   of the folder, for errors
/// \param text   of its .zattrs
/// \param notes  gets what else the text says of the values that is not used
std::vector<ZarrAxis> array_axes(const std::string& path, const std::string& text,
                                 std::vector<std::string>& notes);

/// Whether the text of a .zattrs says that the images lie in numbered folders, as bioformats2raw
/// writes them.
bool is_zarr_series(const std::string& text);

}  // namespace stroma::image
