// SPDX-License-Identifier: BSD-3-Clause

#include "ReadBack.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "LibraryMessages.hpp"
#include "stroma/base/Error.hpp"

namespace stroma::test {

voxels::IntensityVolume read_back(const image::ImageParameters& parameters,
                                  image::ImageSummary& summary) {
  return image::read_volume(base::Communicator::world(), parameters, folder(), summary);
}

void expect_pattern(const voxels::IntensityVolume& volume, const Size& size, const Pattern& pattern,
                    std::int64_t channel, const Size& first) {
  ASSERT_EQ(volume.size, size);
  ASSERT_EQ(base::Communicator::world().sum(volume.planes), size[2]);
  std::size_t voxel = 0;
  for (std::int64_t z = 0; z < volume.planes; ++z) {
    for (std::int64_t y = 0; y < size[1]; ++y) {
      for (std::int64_t x = 0; x < size[0]; ++x, ++voxel) {
        ASSERT_EQ(volume.values[voxel],
                  pattern(first[0] + x, first[1] + y, first[2] + volume.first_plane + z, channel))
            << "at " << x << ", " << y << ", " << z + volume.first_plane;
      }
    }
  }
}

bool has_note(const image::ImageSummary& summary, const std::string& words) {
  return std::any_of(summary.notes.begin(), summary.notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

void expect_refused(const image::ImageParameters& parameters, const std::string& words) {
  std::string said = "nothing", printed;
  {
    const LibraryMessages messages;
    try {
      image::ImageSummary summary;
      read_back(parameters, summary);
    } catch (const base::InputError& error) {
      said = error.what();
    }
    printed = messages.text();
  }
  base::Communicator::world().barrier();
  EXPECT_NE(said.find(words), std::string::npos) << "said: " << said << "\nexpected: " << words;
  EXPECT_NE(said.find(*parameters.file), std::string::npos) << said;
  EXPECT_EQ(printed, "");
}

void expect_refused(const std::string& file, const std::string& words) {
  image::ImageParameters parameters;
  parameters.file = file;
  expect_refused(parameters, words);
}

void expect_refused(const std::string& file, const std::string& bytes, const std::string& words) {
  on_root([&] { write_bytes(folder() + "/" + file, bytes); });
  SCOPED_TRACE(file);
  expect_refused(file, words);
}

}  // namespace stroma::test
