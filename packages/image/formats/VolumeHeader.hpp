// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the headers of MetaImage, NRRD and NIfTI say, in one form. The three functions that read
/// them look at nothing but the bytes they are given.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stroma/image/formats/ImageSummary.hpp"

namespace stroma::image {

enum class Encoding { raw, gzip, bzip2, text };

/// A volume whose values lie in files as numbers, one after another, perhaps packed.
///
/// Value (x, y, z) of channel c of frame t is number
///   x stride[0] + y stride[1] + z stride[2] + c channel_stride + t frame_stride.
struct VolumeHeader {
  std::string path;    ///< of the header
  std::string format;  ///< "MetaImage", ...
  std::array<std::int64_t, 3> size{1, 1, 1};
  std::array<std::int64_t, 3> stride{1, 1, 1};
  std::int64_t channels = 1, channel_stride = 0;
  std::int64_t frames = 1, frame_stride = 0;
  std::int64_t values = 0;  ///< of all files together

  ValueType type;
  bool big_endian = false;
  Encoding encoding = Encoding::raw;
  double slope = 1.0, intercept = 0.0;  ///< what is meant is slope * (what is stored) + intercept

  std::vector<std::string> files;  ///< in order; each holds the same number of values
  std::int64_t line_skip = 0;      ///< lines in front of the values, from `start` on
  std::int64_t byte_skip = 0;  ///< bytes after those lines, once unpacked; -1: the last of the file
  std::int64_t start = 0;      ///< bytes of the header, if the values lie behind it

  VoxelSize voxel_size;
  std::vector<std::string> notes;

  std::int64_t bytes_per_file() const {
    return values / static_cast<std::int64_t>(files.size()) * type.bytes;
  }
};

/// The longest text header that is read, and so the most bytes that these functions want to see.
inline constexpr std::size_t longest_header = 4 << 20;

/// More than x, y, z, channels and frames need; what goes beyond must be 1.
inline constexpr int most_dimensions = 7;

/// \param path  for the messages, and the folder that files are relative to
/// \param head  the file, or its first `longest_header` bytes
/// \throws base::InputError: not whole, contradictory, or of a kind that is not read
VolumeHeader metaimage_header(const std::string& path, const std::string& head);
VolumeHeader nrrd_header(const std::string& path, const std::string& head);
/// NIfTI-1 and NIfTI-2, in one file or as .hdr beside .img.
/// \param path  of the file, for errors and for the .img beside it
/// \param head  unpacked
VolumeHeader nifti_header(const std::string& path, const std::string& head);

/// Bytes of a NIfTI header that nifti_header wants to see.
inline constexpr std::size_t nifti_head_bytes = 544;

/// Sets the strides of axes that follow one another in a file, the fastest first, and the number of
/// values.
/// \param header  gains the number of values
/// \param axes    {size, stride to set}
/// \throws base::InputError when the product of the sizes is no number
void set_strides(VolumeHeader& header,
                 const std::vector<std::pair<std::int64_t, std::int64_t*>>& axes);

/// Takes the spacing that a header states for an axis, in its unit, to the voxel size. A negative
/// one means an axis that runs backwards: its size is taken, with a note. Zero, NaN and infinity
/// are no length: with a note, the axis stays unknown.
void set_spacing(VolumeHeader& header, int axis, double spacing, double micrometres);

/// The note on a spacing without a unit of length.
void note_no_unit(VolumeHeader& header, const std::vector<double>& spacing);

/// Notes what the directions of the axes say beyond the order of the values in the file: turned or
/// mirrored axes, and axes that are not at right angles.
/// \param header  gains the notes
/// \param axes    a vector for each
void note_orientation(VolumeHeader& header, const std::vector<std::array<double, 3>>& axes);

/// Notes a largest value that a signed type cannot hold.
void note_range(VolumeHeader& header, double stated_max);

}  // namespace stroma::image
