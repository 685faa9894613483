// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Slabs, and boxes of voxels taken from wherever they lie.

#include <gtest/gtest.h>

#include "stroma/voxels/Volume.hpp"

namespace stroma::test {
namespace {

TEST(Volume, SlabsCoverAllPlanesOnceAndOwnersAgree) {
  for (const std::int64_t planes : {1, 2, 3, 7, 52}) {
    for (const int ranks : {1, 2, 3, 4, 9}) {
      const voxels::Slabs slabs(planes, ranks);
      std::int64_t next = 0;
      for (int rank = 0; rank < ranks; ++rank) {
        EXPECT_EQ(slabs.first(rank), next);
        for (std::int64_t plane = next; plane < next + slabs.count(rank); ++plane)
          EXPECT_EQ(slabs.owner(plane), rank);
        next += slabs.count(rank);
      }
      EXPECT_EQ(next, planes);
    }
  }
}

TEST(Volume, EachRankExtractsABoxOfItsOwn) {
  const base::Communicator world = base::Communicator::world();
  voxels::LabelVolume volume(world, {6, 5, 9}, {1.0, 1.0, 1.0});
  for (std::size_t i = 0; i < volume.values.size(); ++i)
    volume.values[i] =
        static_cast<std::int32_t>(i) + static_cast<std::int32_t>(volume.first_plane * 30);
  const std::int64_t r = world.rank();
  voxels::Box box{{r % 3, 1, r % 4}, {3, 3, 9 - r % 4 - r % 2}};
  const std::vector<std::int32_t> values = voxels::extract(world, volume, box);
  ASSERT_EQ(static_cast<std::int64_t>(values.size()), box.voxels());
  std::size_t at = 0;
  for (std::int64_t z = 0; z < box.count[2]; ++z) {
    for (std::int64_t y = 0; y < 3; ++y) {
      for (std::int64_t x = 0; x < 3; ++x)
        ASSERT_EQ(values[at++],
                  box.first[0] + x + 6 * (box.first[1] + y) + 30 * (box.first[2] + z));
    }
  }
  // An empty box for all but rank 0, and one for all.
  if (r != 0) box.count = {0, 3, 3};
  EXPECT_EQ(static_cast<std::int64_t>(voxels::extract(world, volume, box).size()), box.voxels());
  EXPECT_TRUE(voxels::extract(world, volume, voxels::Box{}).empty());
}

}  // namespace
}  // namespace stroma::test
