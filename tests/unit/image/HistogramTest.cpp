// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Histograms, percentiles and Otsu's threshold against their definitions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "stroma/base/Error.hpp"
#include "stroma/image/labels/Histogram.hpp"
#include "stroma/image/phantom/CounterRandom.hpp"

namespace stroma::test {
namespace {

using voxels::IntensityVolume;

const image::ValueType u8{image::ValueType::Kind::unsigned_integer, 1};
const image::ValueType f32{image::ValueType::Kind::floating, 4};

/// A volume whose values follow from the voxel's number alone.
template <class Value>
IntensityVolume volume_of(const std::array<std::int64_t, 3>& size, Value&& value) {
  IntensityVolume volume(base::Communicator::world(), size, {1.0, 1.0, 1.0});
  const std::int64_t first = volume.first_plane * volume.plane_voxels();
  for (std::size_t i = 0; i < volume.values.size(); ++i)
    volume.values[i] = value(static_cast<std::uint64_t>(first) + i);
  return volume;
}

/// Two overlapping bumps of integer levels.
double two_bumps(std::uint64_t voxel) {
  image::RandomSequence random(voxel + 99);
  const bool bright = random.uniform() < 0.3;
  return std::clamp(
      std::round(bright ? 150.0 + 30.0 * random.normal() : 60.0 + 20.0 * random.normal()), 0.0,
      255.0);
}

TEST(Histogram, LevelsAreCountedOverAllRanks) {
  const base::Communicator world = base::Communicator::world();
  const IntensityVolume volume =
      volume_of({10, 10, 7}, [](auto i) { return static_cast<double>(i % 5) + 3.0; });
  const image::Histogram histogram = image::histogram(world, volume, u8);
  EXPECT_TRUE(histogram.levels);
  EXPECT_EQ(histogram.counts, std::vector<std::int64_t>(5, 140));
  EXPECT_EQ(histogram.center(0), 3.0);
  const image::Statistics statistics = image::statistics(world, volume);
  EXPECT_EQ(statistics.min, 3.0);
  EXPECT_EQ(statistics.max, 7.0);
  EXPECT_NEAR(statistics.mean, 5.0, 1e-13);
  EXPECT_NEAR(statistics.deviation, std::sqrt(2.0), 1e-13);
}

TEST(Histogram, PercentileIsLinearBetweenOrderStatistics) {
  // 0, 1, ..., 10: the p-th percentile is p / 10.
  const base::Communicator world = base::Communicator::world();
  const IntensityVolume volume =
      volume_of({1, 1, 11}, [](auto i) { return static_cast<double>(i); });
  const image::Histogram histogram = image::histogram(world, volume, u8);
  for (const double percent : {0.0, 12.5, 50.0, 99.9, 100.0})
    EXPECT_NEAR(image::percentile(histogram, percent), percent / 10.0, 1e-12);
}

// Exhaustive search over all thresholds, with the variances taken from the voxels' values.
TEST(Histogram, OtsuMaximisesTheVarianceBetweenClasses) {
  const base::Communicator world = base::Communicator::world();
  const IntensityVolume volume = volume_of({20, 20, 9}, two_bumps);
  double best = -1.0, best_threshold = 0.0;
  for (int t = 0; t < 255; ++t) {
    double n1 = 0, n2 = 0, s1 = 0, s2 = 0;
    for (std::uint64_t i = 0; i < 3600; ++i) {
      const double value = two_bumps(i);
      (value <= t ? n1 : n2) += 1.0;
      (value <= t ? s1 : s2) += value;
    }
    if (n1 == 0 || n2 == 0) continue;
    const double between = n1 * n2 * std::pow(s1 / n1 - s2 / n2, 2);
    if (between > best * (1.0 + 1e-12)) {
      best = between;
      best_threshold = t;
    }
  }
  const double found = image::otsu_threshold(image::histogram(world, volume, u8));
  EXPECT_EQ(found, best_threshold);
  EXPECT_GT(found, 85.0);
  EXPECT_LT(found, 125.0);
}

TEST(Histogram, FloatsGet256EqualBins) {
  const base::Communicator world = base::Communicator::world();
  const IntensityVolume volume = volume_of({8, 8, 8}, [](auto i) { return i < 300 ? -0.5 : 0.5; });
  const image::Histogram histogram = image::histogram(world, volume, f32);
  EXPECT_FALSE(histogram.levels);
  EXPECT_EQ(histogram.counts.size(), 256u);
  EXPECT_EQ(histogram.counts.front(), 300);
  EXPECT_EQ(histogram.counts.back(), 212);  // the largest value lies in the last bin
  EXPECT_NEAR(image::otsu_threshold(histogram), -0.5 + 0.5 / 256.0, 1e-14);
}

// Percentiles of a mask in floats are values of the mask, not places within bins.
TEST(Histogram, PercentilesOfFloatsLieBetweenValuesOfTheirBin) {
  const base::Communicator world = base::Communicator::world();
  const IntensityVolume mask = volume_of({8, 8, 8}, [](auto i) { return i % 10 == 0 ? 1.0 : 0.0; });
  const image::Histogram histogram = image::histogram_with_extremes(world, mask, 65536);
  for (const double percent : {0.0, 5.0, 50.0, 89.0})
    EXPECT_EQ(image::percentile(histogram, percent), 0.0) << percent;
  for (const double percent : {91.0, 99.9, 100.0})
    EXPECT_EQ(image::percentile(histogram, percent), 1.0) << percent;
  const IntensityVolume even =
      volume_of({8, 8, 8}, [](auto i) { return 0.25 + static_cast<double>(i); });
  const image::Histogram few = image::histogram_with_extremes(world, even, 7);
  for (const double percent : {0.0, 12.5, 50.0, 99.9, 100.0})
    EXPECT_NEAR(image::percentile(few, percent), 0.25 + 5.11 * percent, 1e-9);
}

TEST(Histogram, WhatIsNotFiniteIsCountedAndPlaced) {
  const base::Communicator world = base::Communicator::world();
  const IntensityVolume broken = volume_of({4, 4, 4}, [](auto i) {
    return i == 45 || i == 57 ? -std::numeric_limits<double>::infinity() : 1.0;
  });
  const image::NotFinite found = image::not_finite(world, broken);
  EXPECT_EQ(found.count, 2);
  EXPECT_EQ(found.first, "voxel (1, 3, 2)");
  EXPECT_EQ(image::not_finite(world, volume_of({4, 4, 4}, [](auto) { return 1.0; })).count, 0);
}

TEST(Histogram, WhatHasNoHistogramIsAnInputError) {
  const base::Communicator world = base::Communicator::world();
  const IntensityVolume constant = volume_of({4, 4, 4}, [](auto) { return 7.0; });
  EXPECT_THROW(image::otsu_threshold(image::histogram(world, constant, u8)), base::InputError);
  const IntensityVolume broken = volume_of(
      {4, 4, 4}, [](auto i) { return i == 13 ? std::numeric_limits<double>::quiet_NaN() : 1.0; });
  EXPECT_THROW(image::histogram(world, broken, f32), base::InputError);
  EXPECT_THROW(image::statistics(world, broken), base::InputError);
}

}  // namespace
}  // namespace stroma::test
