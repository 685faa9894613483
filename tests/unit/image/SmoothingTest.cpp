// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Gaussian smoothing against the analytic Gaussian, and its invariants.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "stroma/image/labels/Smoothing.hpp"
#include "stroma/image/phantom/CounterRandom.hpp"

namespace stroma::test {
namespace {

using voxels::IntensityVolume;
using Size = std::array<std::int64_t, 3>;

template <class Value>
IntensityVolume volume_of(const base::Communicator& communicator, const Size& size, Value&& value) {
  IntensityVolume volume(communicator, size, {1.0, 1.0, 1.0});
  std::size_t voxel = 0;
  for (std::int64_t z = 0; z < volume.planes; ++z) {
    for (std::int64_t y = 0; y < size[1]; ++y) {
      for (std::int64_t x = 0; x < size[0]; ++x)
        volume.values[voxel++] = value(x, y, z + volume.first_plane);
    }
  }
  return volume;
}

// A Gaussian of standard deviation s0 smoothed by s is one of sqrt(s0^2 + s^2) and the same sum.
// Cutting the weights at 4 s leaves out 6e-5 of them, and the sampled sums are exact far beyond
// that.
TEST(Smoothing, AGaussianBecomesTheWiderGaussian) {
  const base::Communicator world = base::Communicator::world();
  const Size size{41, 37, 33};
  const std::array<double, 3> before{2.5, 2.0, 1.5}, sigma{1.5, 1.0, 2.0};
  const auto gaussian = [&](const std::array<double, 3>& width, double amplitude) {
    return [=](std::int64_t x, std::int64_t y, std::int64_t z) {
      const std::array<double, 3> d{(x - 20.0) / width[0], (y - 18.0) / width[1],
                                    (z - 16.0) / width[2]};
      return amplitude * std::exp(-0.5 * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
    };
  };
  std::array<double, 3> after{};
  double amplitude = 1.0;
  for (std::size_t a = 0; a < 3; ++a) {
    after[a] = std::hypot(before[a], sigma[a]);
    amplitude *= before[a] / after[a];
  }
  IntensityVolume volume = volume_of(world, size, gaussian(before, 1.0));
  image::smooth(world, volume, sigma);
  const IntensityVolume expected = volume_of(world, size, gaussian(after, amplitude));
  double error = 0.0;
  for (std::size_t i = 0; i < volume.values.size(); ++i)
    error = std::max(error, std::abs(volume.values[i] - expected.values[i]));
  EXPECT_LT(error, 2e-4 * amplitude);
}

double noise(std::int64_t x, std::int64_t y, std::int64_t z) {
  return image::random_uniform(3, static_cast<std::uint64_t>(x + 100 * (y + 100 * z)));
}

TEST(Smoothing, ConstantsAndSumsAreKept) {
  const base::Communicator world = base::Communicator::world();
  IntensityVolume constant = volume_of(world, {9, 8, 7}, [](auto...) { return 3.25; });
  image::smooth(world, constant, {1.0, 2.0, 5.0});  // reaches over the volume's far face along z
  for (const double value : constant.values) EXPECT_NEAR(value, 3.25, 1e-13);

  const auto sum = [&](const IntensityVolume& volume) {
    return world.sum(std::accumulate(volume.values.begin(), volume.values.end(), 0.0));
  };
  IntensityVolume volume = volume_of(world, {9, 8, 7}, noise);
  const double before = sum(volume);
  image::smooth(world, volume, {1.3, 0.7, 2.0});
  EXPECT_NEAR(sum(volume), before, 1e-11 * before);
}

TEST(Smoothing, TheSameBitsOnAnyNumberOfRanks) {
  const base::Communicator world = base::Communicator::world(), self = base::Communicator::self();
  IntensityVolume spread = volume_of(world, {12, 11, 10}, noise),
                  whole = volume_of(self, {12, 11, 10}, noise);
  image::smooth(world, spread, {1.3, 0.7, 1.6});
  image::smooth(self, whole, {1.3, 0.7, 1.6});
  const std::int64_t first = spread.first_plane * spread.plane_voxels();
  for (std::size_t i = 0; i < spread.values.size(); ++i)
    ASSERT_EQ(spread.values[i], whole.values[static_cast<std::size_t>(first) + i]);
}

// Where the mean takes over, at two lengths of the image, the Gaussian leaves hardly anything else;
// the cut at 4 sigma does, less than 1e-4.
TEST(Smoothing, TheMeanTakesOverWithoutAJump) {
  const base::Communicator world = base::Communicator::world();
  const Size size{9, 8, 7};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<double, 3> sigma{};
    const double length = static_cast<double>(size[axis]);
    IntensityVolume before = volume_of(world, size, noise), behind = before, far = before;
    sigma[axis] = 1.999 * length;
    image::smooth(world, before, sigma);
    sigma[axis] = 2.001 * length;
    image::smooth(world, behind, sigma);
    sigma[axis] = HUGE_VAL;
    image::smooth(world, far, sigma);
    EXPECT_EQ(behind.values, far.values);
    for (std::size_t i = 0; i < before.values.size(); ++i)
      ASSERT_NEAR(before.values[i], behind.values[i], 1e-4);
  }
}

TEST(Smoothing, TheMeanIsTheSameBitsOnAnyNumberOfRanks) {
  const base::Communicator world = base::Communicator::world(), self = base::Communicator::self();
  IntensityVolume spread = volume_of(world, {12, 11, 10}, noise),
                  whole = volume_of(self, {12, 11, 10}, noise);
  image::smooth(world, spread, {1e9, 1e9, 1e9});
  image::smooth(self, whole, {1e9, 1e9, 1e9});
  for (const double value : spread.values) ASSERT_EQ(value, whole.values.front());
}

TEST(Smoothing, NothingForASigmaOfZero) {
  const base::Communicator world = base::Communicator::world();
  IntensityVolume volume = volume_of(world, {5, 6, 4}, noise);
  const std::vector<double> before = volume.values;
  image::smooth(world, volume, {0.0, 0.0, 0.0});
  EXPECT_EQ(volume.values, before);
}

// A linear volume keeps its slope, but for the reach of its mirror images at the faces along the axis;
// along z planes come from other ranks.
TEST(Smoothing, TheDerivativeOfALinearVolumeIsItsSlope) {
  const base::Communicator world = base::Communicator::world();
  const Size size{14, 15, 16};
  const std::array<double, 3> slope{2.0, -3.0, 5.0};
  const auto linear = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    return slope[0] * static_cast<double>(x) + slope[1] * static_cast<double>(y) +
           slope[2] * static_cast<double>(z);
  };
  for (const double sigma : {0.0, 1.0})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      IntensityVolume volume = volume_of(world, size, linear);
      image::differentiate(world, volume, static_cast<int>(axis), {sigma, sigma, sigma});
      std::size_t voxel = 0;
      for (std::int64_t z = 0; z < volume.planes; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
          for (std::int64_t x = 0; x < size[0]; ++x, ++voxel) {
            const std::int64_t at[3] = {x, y, z + volume.first_plane};
            const std::int64_t reach = sigma > 0.0 ? 4 : 1;
            if (at[axis] >= reach && at[axis] < size[axis] - reach) {
              ASSERT_NEAR(volume.values[voxel], slope[axis], 1e-12);
            }
          }
    }
}

// What lies in the margin counts nowhere, in it neither.
TEST(Smoothing, MeansInsideLeaveOutTheMargin) {
  const base::Communicator world = base::Communicator::world();
  const Size size{10, 11, 12};
  IntensityVolume volume = volume_of(world, size, [&](auto x, auto y, auto z) {
    const bool is_inside = x >= 1 && x < 9 && y >= 2 && y < 9 && z >= 3 && z < 9;
    return is_inside ? 7.0 : 1e6;
  });
  image::average_inside(world, volume, {1.0, 1.5, 2.0}, {1, 2, 3});
  for (const double value : volume.values) ASSERT_NEAR(value, 7.0, 1e-12);
}

}  // namespace
}  // namespace stroma::test
