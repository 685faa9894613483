// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// MetaImage, NRRD and NIfTI: a header that tells how numbers lie in the file behind it or in files
/// beside it. Plain numbers are read in parts; packed ones and text as a whole, by rank 0.

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/StoredValues.hpp"
#include "stroma/image/formats/UnpackedFile.hpp"

namespace stroma::image {
namespace {

class HeaderedSource : public ImageSource {
 public:
  HeaderedSource(const ImageRequest& request, const VolumeHeader& header)
      : header_(header), stored_(check(request, header), request.reads_whole, header_.notes) {
    summary_.path = header.path;
    for (const std::string& file : header.files)
      if (file != header.path) summary_.files.push_back(file);
    summary_.format = header.format;
    summary_.channel = request.channel;
    summary_.file_size = header.size;
    summary_.type = header.type;
    if (scaled()) summary_.type = {ValueType::Kind::floating, 8};
    summary_.channels = header.channels;
    summary_.frames = header.frames;
    summary_.frame = request.frame;
    summary_.voxel_size = header.voxel_size;
    summary_.notes = header_.notes;
  }

  bool readable_in_parts() const override { return header_.encoding == Encoding::raw; }

  void read(const voxels::Box& box, double* values) override {
    const auto& stride = header_.stride;
    const std::int64_t row = (box.count[0] - 1) * stride[0] + 1;
    const std::int64_t rows = (box.count[1] - 1) * stride[1] + row;
    for (std::int64_t k = 0; k < box.count[2]; ++k) {
      const std::int64_t first =
          box.first[0] * stride[0] + box.first[1] * stride[1] + (box.first[2] + k) * stride[2] +
          summary_.channel * header_.channel_stride + summary_.frame * header_.frame_stride;
      const unsigned char* const bytes = stored_.bytes(first, rows);
      for (std::int64_t j = 0; j < box.count[1]; ++j) {
        decode(bytes + j * stride[1] * stored_.type().bytes, stored_.type(), stored_.swapped(),
               box.count[0], stride[0], values + (k * box.count[1] + j) * box.count[0]);
      }
    }
    if (!scaled()) return;
    for (std::int64_t i = 0; i < box.voxels(); ++i)
      values[i] = header_.slope * values[i] + header_.intercept;
  }

 private:
  bool scaled() const { return header_.slope != 1.0 || header_.intercept != 0.0; }

  /// What can be told without looking at the files.
  static const VolumeHeader& check(const ImageRequest& request, const VolumeHeader& header) {
    check_frame(header.path, request.frame, header.frames);
    check_channel(header.path, request.channel, header.channels);
    return header;
  }

  VolumeHeader header_;
  StoredValues stored_;
};

std::string header_text(const std::string& path) {
  return first_unpacked_bytes(path, longest_header, Packing::none);
}

}  // namespace

std::unique_ptr<ImageSource> open_metaimage(const ImageRequest& request) {
  return std::make_unique<HeaderedSource>(
      request, metaimage_header(request.path, header_text(request.path)));
}

std::unique_ptr<ImageSource> open_nrrd(const ImageRequest& request) {
  return std::make_unique<HeaderedSource>(request,
                                          nrrd_header(request.path, header_text(request.path)));
}

std::unique_ptr<ImageSource> open_nifti(const ImageRequest& request) {
  const bool packed = is_gzip(first_unpacked_bytes(request.path, 2, Packing::none));
  VolumeHeader header = nifti_header(
      request.path,
      first_unpacked_bytes(request.path, nifti_head_bytes, packed ? Packing::gzip : Packing::none));
  // The values may be packed beside a header that is not, and the other way round.
  namespace fs = std::filesystem;
  std::string& file = header.files[0];
  if (!fs::exists(file) && fs::exists(file + ".gz")) file += ".gz";
  if (fs::is_regular_file(file) && is_gzip(first_unpacked_bytes(file, 2, Packing::none)))
    header.encoding = Encoding::gzip;
  return std::make_unique<HeaderedSource>(request, header);
}

}  // namespace stroma::image
