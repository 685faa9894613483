// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Stacks of several channels, written by any number of ranks and read back as images. Claim
/// V-STACK-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "ReadBack.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/image/stacks/StackWriter.hpp"
#include "stroma/image/stacks/TiffDescriptions.hpp"
#include "support/World.hpp"

namespace stroma::test {
namespace {

using image::Compression;
using image::StackFormat;

/// A number that tells its voxel and channel; a few voxels are empty.
float value_at(std::int64_t x, std::int64_t y, std::int64_t z, std::size_t channel) {
  if (x < 2 && y == 0 && channel == 0) return std::numeric_limits<float>::quiet_NaN();
  return static_cast<float>(x + 1000 * y + 0.25 * static_cast<double>(z)) +
         1e6f * static_cast<float>(channel);
}

image::StackHeader header_of(const Size& size) {
  image::StackHeader header;
  header.name = "gel & \"fibres\" <1>";
  header.creator = "test";
  header.size = size;
  header.voxel_size = {1.05, 0.5, 2.0};
  header.origin = {10.5, -1.0, 4.0};
  header.channels = {{"von_mises [Pa]"}, {"jacobian"}, {"label", true}};
  return header;
}

std::string write(const image::StackHeader& header, StackFormat format, Compression compression,
                  double most_classic = 4e9) {
  const std::string path =
      folder() + (format == StackFormat::ome_tiff ? "/stack.ome.tif" : "/stack.ome.zarr");
  const auto writer = format == StackFormat::ome_tiff
                          ? image::tiff_stack(world(), path, header, compression, most_classic)
                          : image::zarr_stack(world(), path, header, compression);
  const std::int64_t band = image::planes_of_band(header);
  for (std::int64_t first = 0; first < header.size[2]; first += band) {
    const Size size{header.size[0], header.size[1], std::min(band, header.size[2] - first)};
    std::vector<voxels::Volume<float>> channels;
    for (std::size_t c = 0; c < header.channels.size(); ++c) {
      channels.emplace_back(world(), size, header.voxel_size);
      float* value = channels.back().values.data();
      for (std::int64_t k = 0; k < channels.back().planes; ++k)
        for (std::int64_t j = 0; j < size[1]; ++j)
          for (std::int64_t i = 0; i < size[0]; ++i)
            *value++ = value_at(i, j, first + channels.back().first_plane + k, c);
    }
    writer->write(first, channels);
  }
  writer->finish();
  world().barrier();
  return path;
}

void expect_stack(const std::string& path, const image::StackHeader& header) {
  for (std::size_t c = 0; c < header.channels.size(); ++c) {
    image::ImageParameters parameters;
    parameters.file = path;
    parameters.channel = static_cast<int>(c);
    image::ImageSummary summary;
    const auto volume = read_back(parameters, summary);
    EXPECT_EQ(volume.size, header.size);
    EXPECT_EQ(summary.channels, 3);
    EXPECT_EQ(summary.type.name(), "32-bit float");
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_DOUBLE_EQ(summary.voxel_size.um[d], header.voxel_size[d]);
    std::int64_t n = 0, wrong = 0;
    for (std::int64_t k = 0; k < volume.planes; ++k)
      for (std::int64_t j = 0; j < header.size[1]; ++j)
        for (std::int64_t i = 0; i < header.size[0]; ++i) {
          const double found = volume.values[static_cast<std::size_t>(n++)];
          const auto expected = static_cast<double>(value_at(i, j, volume.first_plane + k, c));
          if (std::isnan(expected) ? !std::isnan(found) : found != expected) ++wrong;
        }
    EXPECT_EQ(wrong, 0) << path << ", channel " << c;
  }
}

TEST(Stack, IsReadAsItWasWritten) {
  for (const StackFormat format : {StackFormat::ome_tiff, StackFormat::ome_zarr})
    for (const Compression compression :
         {Compression::none, Compression::zlib, Compression::zstd, Compression::blosc}) {
      if (format == StackFormat::ome_tiff && compression == Compression::blosc) continue;
      const image::StackHeader header = header_of({13, 7, 35});  // bands of 32 planes
      expect_stack(write(header, format, compression), header);
    }
}

TEST(Stack, PlanesMayBeCutIntoStripsAndChunks) {
  // A plane of 4.8 MB: strips of at most 4 MiB; chunks of 256 x 256, at the ends parts of them.
  const image::StackHeader header = header_of({600, 2000, 3});
  for (const StackFormat format : {StackFormat::ome_tiff, StackFormat::ome_zarr})
    expect_stack(write(header, format, Compression::zlib), header);
}

TEST(Stack, CoarserLevelsAreMeansOfWhatIsNotEmpty) {
  const image::StackHeader header = header_of({600, 300, 2});
  const std::string path = write(header, StackFormat::ome_zarr, Compression::none);
  image::ImageParameters parameters;
  parameters.file = path + "/1";  // an array by itself
  image::ImageSummary summary;
  const auto volume = read_back(parameters, summary);
  EXPECT_EQ(volume.size, (Size{300, 150, 2}));
  EXPECT_TRUE(has_note(summary, "axes are not stated; read as czyx"));
  for (std::int64_t k = 0; k < volume.planes; ++k) {
    const std::int64_t z = volume.first_plane + k;
    // Voxels (0, 0), (1, 0) are empty: the mean of (0, 1) and (1, 1); then one of all four.
    EXPECT_EQ(volume.plane(k)[0], 0.5 * (static_cast<double>(value_at(0, 1, z, 0)) +
                                         static_cast<double>(value_at(1, 1, z, 0))));
    EXPECT_NEAR(volume.plane(k)[1], 2.5 + 500.0 + 0.25 * static_cast<double>(z), 1e-4);
  }
  parameters.channel = 2;  // labels have no mean
  const auto labels = read_back(parameters, summary);
  for (std::int64_t k = 0; k < labels.planes; ++k)
    EXPECT_EQ(labels.plane(k)[1], static_cast<double>(value_at(2, 0, labels.first_plane + k, 2)));
}

/// Number at a place of a file of the machine's byte order.
std::uint64_t number(const std::string& bytes, std::uint64_t at, std::size_t size) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes.data() + at, size);
  return value;
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The descriptions (tag 270) of the first page of a TIFF, classic or big.
std::vector<std::string> descriptions_of(const std::string& bytes) {
  const bool is_big = number(bytes, 2, 2) == 43;
  const std::size_t offset = is_big ? 8 : 4, count = is_big ? 8 : 2, entry = is_big ? 20 : 12;
  const std::uint64_t page = number(bytes, offset, offset);
  std::vector<std::string> descriptions;
  std::uint64_t last = 0;
  for (std::uint64_t n = 0; n < number(bytes, page, count); ++n) {
    const std::uint64_t at = page + count + entry * n, tag = number(bytes, at, 2);
    EXPECT_GE(tag, last);  // tags ascend
    last = tag;
    if (tag == 270)
      descriptions.push_back(
          bytes.substr(number(bytes, at + 4 + offset, offset), number(bytes, at + 4, offset) - 1));
  }
  return descriptions;
}

TEST(Stack, OfTiffHasTwoDescriptions) {
  const image::StackHeader header = header_of({13, 7, 5});
  for (const double most_classic : {4e9, 1e3}) {
    const std::string path = write(header, StackFormat::ome_tiff, Compression::none, most_classic);
    const auto descriptions = descriptions_of(bytes_of(path));
    ASSERT_EQ(descriptions.size(), 2u);
    EXPECT_EQ(descriptions[0], image::ome_xml(header));
    EXPECT_EQ(descriptions[1], image::imagej_description(header));
    EXPECT_NE(descriptions[0].find("Name=\"gel &amp; &quot;fibres&quot; &lt;1&gt;\""),
              std::string::npos);
  }
}

TEST(Stack, ThatMayBecomeTooLargeForAClassicTiffIsABigOne) {
  const image::StackHeader header = header_of({13, 7, 35});  // 3 x 35 pages of 364 bytes
  for (const Compression compression : {Compression::none, Compression::zlib})
    for (const bool is_big : {false, true}) {
      const double pages = 3.0 * 35.0 * (364.0 + 512.0);
      const std::string path =
          write(header, StackFormat::ome_tiff, compression, is_big ? pages - 1.0 : pages);
      EXPECT_EQ(number(bytes_of(path), 2, 2), is_big ? 43u : 42u);
      expect_stack(path, header);
    }
}

TEST(Stack, ThatCannotBeWrittenIsARunErrorOnAllRanks) {
  for (const StackFormat format : {StackFormat::ome_tiff, StackFormat::ome_zarr}) {
    const std::string path = "/proc/no/stack";
    EXPECT_THROW(format == StackFormat::ome_tiff
                     ? image::tiff_stack(world(), path, header_of({4, 4, 4}), Compression::none)
                     : image::zarr_stack(world(), path, header_of({4, 4, 4}), Compression::none),
                 base::RunError);
  }
}

}  // namespace
}  // namespace stroma::test
