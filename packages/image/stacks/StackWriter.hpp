// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Writes an image of several channels, some planes at a time: no rank holds it.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/image/formats/Compression.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

enum class StackFormat { ome_tiff, ome_zarr };

struct StackChannel {
  std::string name;       ///< with its unit: "von_mises [Pa]"
  bool is_label = false;  ///< numbers without a mean
};

/// An image of 32-bit floats.
struct StackHeader {
  std::string name;                  ///< for viewers
  std::string creator;               ///< the program and its version
  std::array<std::int64_t, 3> size;  ///< voxels: x, y, z
  std::array<double, 3> voxel_size;  ///< [um]
  std::array<double, 3> origin{};    ///< lower corner of voxel (0, 0, 0) [um]
  std::vector<StackChannel> channels;
};

/// An image that is being written under another name, PATH.new, and gets its own when it is whole.
/// Member functions are collective.
class StackWriter {
 public:
  virtual ~StackWriter() = default;

  /// Writes the next planes of all channels.
  /// \param first_plane  that follows the last one written; a multiple of planes_of_band()
  /// \param channels     the planes as volumes of their own
  /// \throws base::RunError on all ranks when the disk does not take them
  virtual void write(std::int64_t first_plane,
                     const std::vector<voxels::Volume<float>>& channels) = 0;
  /// All planes are written.
  /// \throws base::RunError
  virtual void finish() = 0;
};

/// Planes that are written at once, but at the end: as many as make about 2^22 values in all
/// channels and one more, a power of two, at most 32.
std::int64_t planes_of_band(const StackHeader& header);

/// A TIFF file that is an OME-TIFF and a hyperstack of ImageJ in one: a page a plane, channels
/// fastest, then z. The first page has two descriptions, OME-XML and then ImageJ's: readers of OME
/// take the first, ImageJ the last. Channels are named in OME-XML and, as labels of slices, in
/// ImageJ's tags. A BigTIFF where it may become larger than a classic TIFF can be. Ranks pack their
/// planes, rank 0 writes them. Collective.
/// \param communicator  of the ranks whose volumes it takes
/// \param path          of the file
/// \param header        what it holds, and how large
/// \param compression   none, zlib or zstd; of a strip of at most 4 MiB
/// \param most_classic  bytes of values and pages, before compression, of a classic TIFF
/// \throws base::RunError on all ranks when the file cannot be made
std::unique_ptr<StackWriter> tiff_stack(const base::Communicator& communicator,
                                        const std::string& path, const StackHeader& header,
                                        Compression compression, double most_classic = 4.0e9);

/// A folder that is an OME-Zarr of version 0.4 (Zarr 2): axes c, z, y, x; level 0 and coarser ones,
/// each with half the voxels along x and y, their mean without what is empty; of labels one of
/// them. Chunks of one channel, a band of planes and 256 x 256 voxels, each a file that one rank
/// writes. Collective.
/// \param communicator  of the ranks whose volumes it takes
/// \param path          of the folder
/// \param header        what it holds, and how large
/// \param compression   of a chunk
/// \throws base::RunError on all ranks when the folder cannot be made
std::unique_ptr<StackWriter> zarr_stack(const base::Communicator& communicator,
                                        const std::string& path, const StackHeader& header,
                                        Compression compression);

}  // namespace stroma::image
