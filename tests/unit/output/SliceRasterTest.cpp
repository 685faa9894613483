// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The numbers behind the pictures: the layer, the pixels, holes filled and not filled.

#include <gtest/gtest.h>

#include <cmath>

#include "stroma/output/pictures/SliceRaster.hpp"

namespace stroma {
namespace {

/// Particles at the centres of nx x ny x nz unit cubes, dealt round robin to the ranks; in the
/// layers of height z, material and value tell the place.
struct Cubes {
  Cubes(int nx, int ny, int nz) {
    const auto world = base::Communicator::world();
    int n = 0;
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i, ++n) {
          if (n % world.size() != world.rank()) continue;
          for (const int index : {i, j, k}) position.push_back(index + 0.5);
        }
    set.count = static_cast<std::int64_t>(position.size()) / 3;
    set.position = position.data();
  }
  std::vector<double> position;
  output::ParticleSet set;
};

/// Points at the cubes' centres, x stretched, with the value x + 100 y of the unstretched place.
std::vector<output::SlicePoint> points_of(const Cubes& cubes, double stretch) {
  std::vector<output::SlicePoint> points;
  for (std::int64_t p = 0; p < cubes.set.count; ++p) {
    const double x = cubes.position[static_cast<std::size_t>(3 * p)];
    const double y = cubes.position[static_cast<std::size_t>(3 * p + 1)];
    points.push_back({{x * stretch, y}, x + 100.0 * y});
  }
  return points;
}

TEST(MiddleLayer, IsOneLayerOfOddEvenAndSingleCounts) {
  const auto world = base::Communicator::world();
  for (const auto& [layers, height] : {std::pair(1, 0.5), std::pair(4, 1.5), std::pair(5, 2.5)}) {
    const Cubes cubes(3, 2, layers);
    double z = 0;
    const auto members = output::middle_layer(world, cubes.set, 1.0, &z);
    EXPECT_DOUBLE_EQ(z, height) << layers << " layers";
    for (const std::int64_t p : members) {
      EXPECT_DOUBLE_EQ(cubes.position[static_cast<std::size_t>(3 * p + 2)], height);
    }
    EXPECT_EQ(world.sum(static_cast<std::int64_t>(members.size())), 6);
  }
}

TEST(Raster, PutsEveryParticleOfALatticeIntoItsOwnPixelAtAnyStretch) {
  const auto world = base::Communicator::world();
  for (const double stretch : {1.0, 1.1, 0.9}) {
    const Cubes cubes(20, 7, 1);
    const auto raster = output::rasterise(world, points_of(cubes, stretch), {19.0, 6.0}, {1.0, 1.0},
                                          output::Merge::Mean);
    EXPECT_EQ(raster.columns, 20);
    EXPECT_EQ(raster.rows, 7);
    EXPECT_DOUBLE_EQ(raster.first[0], 0.5 * stretch);
    EXPECT_NEAR(raster.pixel[0], stretch, 1e-14);
    if (!world.is_root()) {
      EXPECT_TRUE(raster.value.empty());
      continue;
    }
    for (int j = 0; j < 7; ++j)
      for (int i = 0; i < 20; ++i) {
        EXPECT_FLOAT_EQ(raster.value[static_cast<std::size_t>(j * 20 + i)],
                        static_cast<float>(i + 0.5 + 100.0 * (j + 0.5)));
      }
  }
}

TEST(Raster, IsTheMeanOfTheParticlesInAPixel) {
  const auto world = base::Communicator::world();
  // 8 x 4 particles of spacing 0.5 into pixels of about the side 1.
  std::vector<output::SlicePoint> points;
  if (world.rank() == world.size() - 1) {
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 8; ++i) points.push_back({{0.5 * i, 0.5 * j}, 1.0 * i});
  }
  const auto raster =
      output::rasterise(world, points, {3.5, 1.5}, {0.5, 0.5}, output::Merge::Mean, 2);
  EXPECT_EQ(raster.columns, 2);
  EXPECT_EQ(raster.rows, 2);
  if (!world.is_root()) return;
  EXPECT_FLOAT_EQ(raster.value[0], 1.5F);  // of 0, 1, 2, 3
  EXPECT_FLOAT_EQ(raster.value[1], 5.5F);
}

TEST(Raster, MajorityTakesTheMaterialOfMostParticles) {
  const auto world = base::Communicator::world();
  std::vector<output::SlicePoint> points;
  if (world.is_root()) {
    points = {{{0.0, 0.0}, 2}, {{0.1, 0.0}, 0}, {{0.1, 0.0}, 2}, {{1.0, 0.0}, 1}, {{0.9, 0.0}, 0}};
  }
  const auto raster =
      output::rasterise(world, points, {1.0, 0.0}, {1.0, 1.0}, output::Merge::Majority);
  if (!world.is_root()) return;
  ASSERT_EQ(raster.value.size(), 2U);
  EXPECT_EQ(raster.value[0], 2.0F);
  EXPECT_EQ(raster.value[1], 0.0F) << "of equals, the lowest";
}

// A stretch that is not even leaves gaps wider than a pixel in its stretched part: they are filled
// from their neighbours. What is empty in the specimen itself, or outside it, stays empty.
TEST(Raster, FillsHolesBetweenParticlesButNotVoids) {
  const auto world = base::Communicator::world();
  std::vector<output::SlicePoint> points;
  if (world.is_root()) {
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i) {
        if (i >= 4 && i < 8 && j >= 4 && j < 8) continue;  // a void of 4 x 4 particles
        if (i > j + 8) continue;                           // a corner that is not there
        points.push_back({{i < 6 ? 0.9 * i : 5.4 + 1.3 * (i - 6), 1.0 * j}, 7.0});
      }
  }
  const auto raster =
      output::rasterise(world, points, {11.0, 11.0}, {1.0, 1.0}, output::Merge::Mean);
  if (!world.is_root()) return;
  ASSERT_EQ(raster.columns, 12);
  const auto at = [&](int i, int j) { return raster.value[static_cast<std::size_t>(j * 12 + i)]; };
  for (int j = 0; j < 12; ++j) {
    const bool beside_the_void = j < 4 || j >= 8;
    for (int i = 0; i < 8 && beside_the_void; ++i) EXPECT_EQ(at(i, j), 7.0F) << i << ' ' << j;
  }
  for (int j = 5; j < 7; ++j) EXPECT_TRUE(std::isnan(at(5, j)));
  EXPECT_TRUE(std::isnan(at(11, 0)));
  EXPECT_TRUE(std::isnan(at(11, 1)));
  EXPECT_EQ(at(11, 11), 7.0F);
}

TEST(Raster, IsBoundedAndMayBeEmpty) {
  const auto world = base::Communicator::world();
  const Cubes cubes(40, 3, 1);
  const auto raster = output::rasterise(world, points_of(cubes, 1.0), {39.0, 2.0}, {1.0, 1.0},
                                        output::Merge::Mean, 16);
  EXPECT_EQ(raster.columns, 16);
  EXPECT_EQ(raster.rows, 3);
  EXPECT_EQ(output::rasterise(world, {}, {0.0, 0.0}, {1.0, 1.0}, output::Merge::Mean).columns, 0);
}

}  // namespace
}  // namespace stroma
