// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Widths of objects: of strips, blocks and round tubes, whose widths are known.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stroma/image/labels/Widths.hpp"

namespace stroma::test {
namespace {

using Size = std::array<std::int64_t, 3>;

template <class Label>
voxels::LabelVolume volume_of(const Size& size, const std::array<double, 3>& voxel_size,
                              Label&& label) {
  voxels::LabelVolume volume(base::Communicator::world(), size, voxel_size);
  const std::int64_t first = volume.first_plane * volume.plane_voxels();
  for (std::size_t i = 0; i < volume.values.size(); ++i) {
    const std::int64_t v = first + static_cast<std::int64_t>(i);
    volume.values[i] = label(v % size[0], v / size[0] % size[1], v / (size[0] * size[1]));
  }
  return volume;
}

// A strip of 5 voxels of 2 um across x, in 20: its chords are 10 um along x, and the image's edges
// along y and z, where nothing ends.
TEST(Widths, ChordsOfAStripAreItsWidthAndTheImagesEdges) {
  const auto world = base::Communicator::world();
  const voxels::LabelVolume strip = volume_of(
      {20, 12, 9}, {2.0, 3.0, 0.5}, [](auto i, auto, auto) { return i >= 7 && i < 12 ? 3 : 0; });
  const auto found = image::widths(world, strip, {3, 0, 8});
  ASSERT_EQ(found.size(), 3u);
  EXPECT_DOUBLE_EQ(found[0].chords[0], 10.0);
  EXPECT_DOUBLE_EQ(found[0].chords[1], 36.0);
  EXPECT_DOUBLE_EQ(found[0].chords[2], 4.5);
  EXPECT_EQ(found[0].has_surface, (std::array<bool, 3>{true, false, false}));
  EXPECT_DOUBLE_EQ(found[1].chords[0],
                   15.0);  // 7 and 8 voxels, from the strip to the image's faces
  // S = 2 crossings / 3 directions / 40 um, times 2; V = 1/4.
  EXPECT_DOUBLE_EQ(found[0].tubes, 4.0 * 0.25 / (2.0 * 2.0 / 40.0 / 3.0));
  EXPECT_EQ(found[2].tubes, 0.0);
  EXPECT_EQ(found[2].chords, (std::array<double, 3>{0.0, 0.0, 0.0}));
}

// Slabs of ranks: blocks whose faces lie anywhere along z, cut by the image's upper face.
TEST(Widths, ChordsAlongZCrossSlabs) {
  const auto world = base::Communicator::world();
  const voxels::LabelVolume blocks =
      volume_of({4, 4, 14}, {1.0, 1.0, 1.0}, [](auto, auto, auto k) { return k % 6 < 4 ? 1 : 2; });
  const auto found = image::widths(world, blocks, {1, 2});
  EXPECT_DOUBLE_EQ(found[0].chords[2], 10.0 / 3.0);  // 4, 4 and 2
  EXPECT_DOUBLE_EQ(found[1].chords[2], 2.0);
  EXPECT_EQ(found[0].has_surface, (std::array<bool, 3>{false, false, true}));
}

TEST(Widths, ABodyWithoutSurfaceIsEndless) {
  const auto world = base::Communicator::world();
  const voxels::LabelVolume full =
      volume_of({4, 5, 6}, {1.0, 1.0, 1.0}, [](auto, auto, auto) { return 0; });
  const auto found = image::widths(world, full, {0});
  EXPECT_EQ(found[0].tubes, std::numeric_limits<double>::infinity());
  EXPECT_EQ(found[0].chords, (std::array<double, 3>{4.0, 5.0, 6.0}));
  EXPECT_EQ(found[0].has_surface, (std::array<bool, 3>{false, false, false}));
}

// A round tube along z of diameter 20 um. Of a convex outline the crossings along x and y are the two
// of each line that meets it: 4 D in a plane, so that S is 8/3 D for pi D, and the estimate 3 pi / 8 D.
// In a single slice, where both directions are taken as all, it is 4 (pi/4 D^2) / (pi/2 2 D) = D.
TEST(Widths, TubesAreMeasuredByStereology) {
  const auto world = base::Communicator::world();
  const auto tube = [](auto i, auto j, auto) {
    const double x = 0.1 * (static_cast<double>(i) + 0.5) - 15.0;
    const double y = 0.1 * (static_cast<double>(j) + 0.5) - 15.0;
    return std::hypot(x, y) < 10.0 ? 1 : 0;
  };
  const auto solid = image::widths(world, volume_of({300, 300, 3}, {0.1, 0.1, 1.0}, tube), {1});
  EXPECT_NEAR(solid[0].tubes, 0.375 * std::acos(-1.0) * 20.0, 0.02);
  const auto slice = image::widths(world, volume_of({300, 300, 1}, {0.1, 0.1, 1.0}, tube), {1});
  EXPECT_NEAR(slice[0].tubes, 20.0, 0.02);
  EXPECT_NEAR(slice[0].chords[0], 0.25 * std::acos(-1.0) * 20.0, 0.02);
  EXPECT_EQ(slice[0].has_surface, (std::array<bool, 3>{true, true, false}));
}

}  // namespace
}  // namespace stroma::test
