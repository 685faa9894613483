// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Distances to walls, against a search of all voxels of the other side. Claim V-TABLE-4,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "stroma/image/labels/WallDistance.hpp"
#include "stroma/image/phantom/CounterRandom.hpp"

namespace stroma::test {
namespace {

using Size = std::array<std::int64_t, 3>;
using Label = std::function<std::int32_t(std::int64_t voxel)>;

/// From the middle of a voxel to the nearest box of a voxel of the other side.
double nearest(const Size& size, const std::array<double, 3>& h, const Label& label,
               std::int32_t wanted, std::int64_t voxel) {
  const Size at{voxel % size[0], voxel / size[0] % size[1], voxel / (size[0] * size[1])};
  double least = HUGE_VAL;
  for (std::int64_t other = 0; other < size[0] * size[1] * size[2]; ++other) {
    if ((label(other) == wanted) == (label(voxel) == wanted)) continue;
    const Size to{other % size[0], other / size[0] % size[1], other / (size[0] * size[1])};
    double square = 0.0;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto away = static_cast<double>(std::abs(to[d] - at[d]));
      square += away > 0.0 ? std::pow((away - 0.5) * h[d], 2) : 0.0;
    }
    least = std::min(least, square);
  }
  return std::sqrt(least);
}

void expect_nearest(const Size& size, const std::array<double, 3>& h, double limit,
                    const Label& label, std::int32_t wanted) {
  voxels::LabelVolume labels(base::Communicator::world(), size, h);
  const std::int64_t first = labels.first_plane * labels.plane_voxels();
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    labels.values[v] = label(first + static_cast<std::int64_t>(v));
  const auto found = image::wall_distance(base::Communicator::world(), labels, wanted, limit);
  for (std::size_t v = 0; v < labels.values.size(); ++v) {
    const double is =
        std::min(nearest(size, h, label, wanted, first + static_cast<std::int64_t>(v)), limit);
    ASSERT_NEAR(found.values[v], is, 1e-6 * limit) << v;
  }
}

// V-TABLE-4.
TEST(WallDistance, IsThatToTheNearestVoxelOfTheOtherSide) {
  const Size size{13, 9, 11};
  for (const double share : {0.02, 0.3, 0.97})
    for (const std::array<double, 3>& h :
         {std::array<double, 3>{1.05, 1.05, 1.0}, {0.5, 2.0, 1.0}, {1.0, 0.4, 3.0}})
      for (const double limit : {3.0, 50.0}) {
        const Label noise = [&](std::int64_t v) {
          const double random = image::random_uniform(5, static_cast<std::uint64_t>(v));
          return random < share ? 1 : random < share + 0.02 ? -1 : 0;
        };
        expect_nearest(size, h, limit, noise, 1);
        expect_nearest(size, h, limit, noise, 0);
      }
}

TEST(WallDistance, IsTheLimitWhereThereIsNoWall) {
  expect_nearest(
      {4, 3, 5}, {1.0, 1.0, 1.0}, 7.0, [](std::int64_t) { return 0; }, 0);
  expect_nearest(
      {4, 3, 5}, {1.0, 1.0, 1.0}, 7.0, [](std::int64_t) { return 0; }, 1);
  // A plate at the end of a long block.
  expect_nearest(
      {2, 2, 300}, {1.0, 1.0, 1.0}, 200.0, [](std::int64_t v) { return v < 8 ? 1 : 0; }, 1);
}

}  // namespace
}  // namespace stroma::test
