// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// One open image file, whatever its format: what read_volume() sees of a reader.

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/image/formats/ImageSummary.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// An image file of which boxes of voxels can be read, one channel of it.
class ImageSource {
 public:
  virtual ~ImageSource() = default;

  /// Path, format, file_size, type, channels, channel, frames, frame, dataset, voxel size as the
  /// file states it, notes; in `files` those that are read beside the one opened, if any.
  const ImageSummary& summary() const { return summary_; }

  /// The values of a box of the file, x fastest. Not collective.
  /// \throws base::InputError when the file is broken there
  virtual void read(const voxels::Box& box, double* values) = 0;

  /// False when the file can only be read as a whole: then rank 0 alone reads.
  virtual bool readable_in_parts() const { return true; }

 protected:
  ImageSummary summary_;
};

/// What of a file is wanted.
struct ImageRequest {
  std::string path;
  std::string dataset;  ///< HDF5 only; empty: the only one
  int channel = 0;
  int frame = 0;            ///< of a time series
  bool reads_whole = true;  ///< this rank will read a file that cannot be read in parts
};

std::unique_ptr<ImageSource> open_tiff(const ImageRequest& request);
std::unique_ptr<ImageSource> open_pic(const ImageRequest& request);
std::unique_ptr<ImageSource> open_metaimage(const ImageRequest& request);
std::unique_ptr<ImageSource> open_nrrd(const ImageRequest& request);
std::unique_ptr<ImageSource> open_nifti(const ImageRequest& request);
std::unique_ptr<ImageSource> open_hdf5(const ImageRequest& request);
std::unique_ptr<ImageSource> open_zarr(const ImageRequest& request);

/// Whether a folder is one of Zarr.
bool is_zarr(const std::string& folder);

/// Opens a file by what it begins with, not by its name. Collective.
/// \throws base::InputError on all ranks: missing, a folder, empty, no known format, or broken
std::unique_ptr<ImageSource> open_image(const base::Communicator& communicator,
                                        const ImageRequest& wanted);

/// \throws base::InputError  "PATH: what"
[[noreturn]] void refuse(const std::string& path, const std::string& what);

/// Refuses a size that is zero, or that a file of this length cannot hold, before anything is
/// allocated.
/// \param path              of the file, for errors
/// \param size              voxels along x, y, z, as the header says
/// \param values_per_voxel  stored for each
/// \param bytes_per_value   of the stored type
/// \param file_length       [bytes]
/// \param expansion         the most that the file's compression can gain; 1: there is none
void check_size(const std::string& path, const std::array<std::int64_t, 3>& size,
                std::int64_t values_per_voxel, int bytes_per_value, std::uint64_t file_length,
                double expansion);

/// Attributes of netCDF's custom, which say that values are factor x stored + offset.
inline constexpr std::array<const char*, 2> linear_map_attributes{"scale_factor", "add_offset"};

/// The note on one of them.
std::string not_applied(const std::string& attribute);

/// More than any compression met in image files gains (deflate: 1032, LZW: 2731).
inline constexpr double largest_expansion = 4096.0;

/// \throws base::InputError unless 0 <= channel < channels
void check_channel(const std::string& path, std::int64_t channel, std::int64_t channels);

/// \throws base::InputError unless 0 <= frame < frames. open_image() asks it of every source; one
///   that knows time series asks before it looks for the frame's planes.
void check_frame(const std::string& path, std::int64_t frame, std::int64_t frames);

/// Converts `count` values, `stride` values apart, to doubles.
/// \param bytes    where the first value begins
/// \param type     of the stored values
/// \param swapped  the bytes of each value are in reverse order
/// \param count    of the values
/// \param stride   from one value to the next [values]
/// \param values   (out) `count` of them
void decode(const unsigned char* bytes, const ValueType& type, bool swapped, std::int64_t count,
            std::int64_t stride, double* values);

/// Reads a box out of planes that lie one after another, uncompressed, from some byte of a file on.
/// \throws base::InputError when the file ends too early
void read_raw(const std::string& path, std::uint64_t offset, const ValueType& type, bool swapped,
              const std::array<std::int64_t, 3>& size, const voxels::Box& box, double* values);

}  // namespace stroma::image
