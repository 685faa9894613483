// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Writes an image stack whose values tell their voxels, as large as is asked for; big_tiff.py reads
/// it.
///
///     benchmark_big_stack PATH X Y Z CHANNELS

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "stroma/base/Session.hpp"
#include "stroma/image/stacks/StackWriter.hpp"

int main(int argc, char** argv) {
  using namespace stroma;
  const base::MpiSession session(&argc, &argv);
  if (argc != 6) {
    std::fprintf(stderr, "usage: benchmark_big_stack PATH X Y Z CHANNELS\n");
    return 2;
  }
  image::StackHeader header;
  header.name = "values that tell their voxels";
  header.creator = "benchmark_big_stack";
  header.size = {std::atoll(argv[2]), std::atoll(argv[3]), std::atoll(argv[4])};
  header.voxel_size = {1.05, 1.05, 1.0};
  for (int c = 0; c < std::atoi(argv[5]); ++c) header.channels.push_back({"c" + std::to_string(c)});

  const auto world = base::Communicator::world();
  const auto writer = image::tiff_stack(world, argv[1], header, image::Compression::none);
  const std::int64_t band = image::planes_of_band(header);
  for (std::int64_t first = 0; first < header.size[2]; first += band) {
    const std::int64_t planes = std::min(band, header.size[2] - first);
    std::vector<voxels::Volume<float>> channels;
    for (std::size_t c = 0; c < header.channels.size(); ++c) {
      voxels::Volume<float>& channel = channels.emplace_back(
          world, std::array<std::int64_t, 3>{header.size[0], header.size[1], planes},
          header.voxel_size);
      float* value = channel.values.data();
      for (std::int64_t k = 0; k < channel.planes; ++k)
        for (std::int64_t j = 0; j < header.size[1]; ++j)
          for (std::int64_t i = 0; i < header.size[0]; ++i)  // each a number below 2^24: exact
            *value++ = static_cast<float>((i + 31 * j + 1009 * (first + channel.first_plane + k) +
                                           100003 * static_cast<std::int64_t>(c)) %
                                          16777216);
    }
    writer->write(first, channels);
  }
  writer->finish();
  return 0;
}
