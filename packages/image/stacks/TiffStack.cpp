// SPDX-License-Identifier: BSD-3-Clause

#include <tiffio.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>

#include "stroma/base/Error.hpp"
#include "stroma/image/formats/TiffDraft.hpp"
#include "stroma/image/formats/TiffPages.hpp"
#include "stroma/image/stacks/StackWriter.hpp"
#include "stroma/image/stacks/TiffDescriptions.hpp"

namespace stroma::image {
namespace {

constexpr std::int64_t strip_bytes = std::int64_t{1} << 22;

/// ImageJ's tags, and one that carries its description until the file is whole.
constexpr std::uint32_t imagej_byte_counts = 50838, imagej_bytes = 50839;
constexpr std::uint16_t carrier = TIFFTAG_MAKE, description = TIFFTAG_IMAGEDESCRIPTION;
static_assert(carrier == description + 1, "the tags of a page ascend");

std::uint16_t tag_of(Compression compression) {
  switch (compression) {
    case Compression::zlib:
      return COMPRESSION_ADOBE_DEFLATE;
    case Compression::zstd:
      return COMPRESSION_ZSTD;
    default:
      return COMPRESSION_NONE;
  }
}

/// Bytes of the file, but for what compression gains.
double bytes_of(const StackHeader& header) {
  constexpr double bytes_of_page = 512.0;
  const double pages =
      static_cast<double>(header.channels.size()) * static_cast<double>(header.size[2]);
  return pages * (bytes_of_page + sizeof(float) * static_cast<double>(header.size[0]) *
                                      static_cast<double>(header.size[1]));
}

/// Makes a second description of the first page's carrier: libtiff, which keeps one of a kind, does
/// not write it.
/// \return  whether it could be done
bool rename_carrier(const std::string& path, bool is_big) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "r+b"),
                                                             std::fclose);
  const auto read = [&](std::uint64_t at, std::size_t bytes) {
    std::uint64_t number = 0;
    const bool is_read = file && fseeko(file.get(), static_cast<off_t>(at), SEEK_SET) == 0 &&
                         std::fread(&number, 1, bytes, file.get()) == bytes;
    return is_read ? number : 0;
  };
  const std::uint64_t page = is_big ? read(8, 8) : read(4, 4);
  const std::uint64_t count_bytes = is_big ? 8 : 2, entry_bytes = is_big ? 20 : 12;
  const std::uint64_t count = read(page, count_bytes);
  for (std::uint64_t n = 0; n < count; ++n) {
    const std::uint64_t at = page + count_bytes + n * entry_bytes;
    if (read(at, 2) != carrier) continue;
    return fseeko(file.get(), static_cast<off_t>(at), SEEK_SET) == 0 &&
           std::fwrite(&description, sizeof description, 1, file.get()) == 1 &&
           std::fflush(file.get()) == 0;
  }
  return false;
}

class TiffStack : public StackWriter {
 public:
  TiffStack(const base::Communicator& communicator, const std::string& path,
            const StackHeader& header, Compression compression, double most_classic)
      : communicator_(communicator),
        header_(header),
        compression_(compression),
        is_big_(bytes_of(header) > most_classic),
        rows_(std::clamp<std::int64_t>(
            strip_bytes / (header.size[0] * static_cast<std::int64_t>(sizeof(float))), 1,
            header.size[1])) {
    const TiffMessages messages;
    base::collectively(communicator_, [&] {
      if (communicator_.is_root()) draft_.emplace(path, path + ".new", is_big_);
    });
  }

  void write(std::int64_t first_plane,
             const std::vector<voxels::Volume<float>>& channels) override {
    const TiffMessages messages;
    const voxels::Slabs slabs(channels.front().size[2], communicator_.size());
    std::vector<Bytes> strips;  // of this rank's planes: channels fastest, then planes
    base::collectively(communicator_, [&] { strips = packed(channels); });
    if (!communicator_.is_root()) {
      send(strips);
      return tell(true);
    }
    bool is_written = true;
    std::size_t own = 0;
    for (std::int64_t k = 0; k < channels.front().size[2]; ++k) {
      const int owner = slabs.owner(k);
      for (std::size_t c = 0; c < channels.size(); ++c) {
        is_written = is_written && begin_page(first_plane + k == 0 && c == 0);
        for (std::uint32_t s = 0; s < strips_of_page(); ++s) {
          const Bytes strip = owner == 0 ? std::move(strips[own++]) : receive(owner);
          is_written = is_written && put(s, strip);
        }
        is_written = is_written && TIFFWriteDirectory(draft_->file()) == 1;
      }
    }
    tell(is_written);
  }

  void finish() override {
    const TiffMessages messages;
    base::collectively(communicator_, [&] {
      if (!communicator_.is_root()) return;
      draft_->close();
      if (!rename_carrier(draft_->draft(), is_big_)) draft_->fail();
      draft_->rename();
    });
  }

 private:
  static constexpr int tag = 4714;

  std::uint32_t strips_of_page() const {
    return static_cast<std::uint32_t>((header_.size[1] + rows_ - 1) / rows_);
  }

  std::vector<Bytes> packed(const std::vector<voxels::Volume<float>>& channels) const {
    std::vector<Bytes> strips;
    for (std::int64_t k = 0; k < channels.front().planes; ++k)
      for (const voxels::Volume<float>& channel : channels)
        for (std::int64_t j = 0; j < header_.size[1]; j += rows_) {
          const float* const values = channel.plane(k) + j * header_.size[0];
          const std::int64_t count = std::min(rows_, header_.size[1] - j) * header_.size[0];
          strips.push_back(pack(reinterpret_cast<const unsigned char*>(values),
                                static_cast<std::size_t>(count) * sizeof(float), compression_,
                                sizeof(float)));
        }
    return strips;
  }

  void send(const std::vector<Bytes>& strips) const {
    for (const Bytes& strip : strips)
      MPI_Send(strip.data(), static_cast<int>(strip.size()), MPI_BYTE, 0, tag, communicator_.raw());
  }
  Bytes receive(int owner) const {
    MPI_Status status;
    MPI_Probe(owner, tag, communicator_.raw(), &status);
    int count = 0;
    MPI_Get_count(&status, MPI_BYTE, &count);
    Bytes strip(static_cast<std::size_t>(count));
    MPI_Recv(strip.data(), count, MPI_BYTE, owner, tag, communicator_.raw(), MPI_STATUS_IGNORE);
    return strip;
  }

  void tell(bool is_written) const {
    base::collectively(communicator_, [&] {
      if (!is_written) draft_->fail();
    });
  }

  bool begin_page(bool is_first) {
    TIFF* const file = draft_->file();
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(header_.size[0]));
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(header_.size[1]));
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(file, TIFFTAG_COMPRESSION, tag_of(compression_));
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(rows_));
    TIFFSetField(file, TIFFTAG_SOFTWARE, stroma_software);
    TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
    TIFFSetField(file, TIFFTAG_XRESOLUTION, 1.0 / header_.voxel_size[0]);
    TIFFSetField(file, TIFFTAG_YRESOLUTION, 1.0 / header_.voxel_size[1]);
    return !is_first || describe(file);
  }

  bool describe(TIFF* file) {
    static char counts_name[] = "IJMetadataByteCounts", bytes_name[] = "IJMetadata";
    const TIFFFieldInfo fields[] = {
        {imagej_byte_counts, TIFF_VARIABLE2, TIFF_VARIABLE2, TIFF_LONG, FIELD_CUSTOM, 1, 1,
         counts_name},
        {imagej_bytes, TIFF_VARIABLE2, TIFF_VARIABLE2, TIFF_BYTE, FIELD_CUSTOM, 1, 1, bytes_name}};
    const ImageJLabels labels = imagej_labels(header_);
    return TIFFMergeFieldInfo(file, fields, 2) == 0 &&
           TIFFSetField(file, description, ome_xml(header_).c_str()) == 1 &&
           TIFFSetField(file, carrier, imagej_description(header_).c_str()) == 1 &&
           TIFFSetField(file, imagej_byte_counts,
                        static_cast<std::uint32_t>(labels.byte_counts.size()),
                        labels.byte_counts.data()) == 1 &&
           TIFFSetField(file, imagej_bytes, static_cast<std::uint32_t>(labels.bytes.size()),
                        labels.bytes.data()) == 1;
  }

  bool put(std::uint32_t strip, const Bytes& bytes) {
    const auto count = static_cast<tmsize_t>(bytes.size());
    return TIFFWriteRawStrip(draft_->file(), strip, const_cast<unsigned char*>(bytes.data()),
                             count) == count;
  }

  base::Communicator communicator_;
  StackHeader header_;
  Compression compression_;
  bool is_big_;
  std::int64_t rows_;               // of a strip
  std::optional<TiffDraft> draft_;  // of rank 0
};

}  // namespace

std::unique_ptr<StackWriter> tiff_stack(const base::Communicator& communicator,
                                        const std::string& path, const StackHeader& header,
                                        Compression compression, double most_classic) {
  return std::make_unique<TiffStack>(communicator, path, header, compression, most_classic);
}

}  // namespace stroma::image
