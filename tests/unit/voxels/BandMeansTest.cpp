// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Means over voxels of boxes that lie anywhere, added by any rank. Claim V-STACK-1,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "stroma/voxels/BandMeans.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using voxels::BandMeans;
using voxels::FilledBox;
using voxels::Rule;

constexpr std::array<std::int64_t, 3> size{7, 5, 6};

struct Piece {
  FilledBox box;
  double value;
  double label;
};

/// The value of a voxel by brute force: sums over all boxes of all ranks.
struct Expected {
  double volume = 0.0, sum = 0.0, largest = 0.0, label = -1.0;
};

Expected expected_of(const std::vector<Piece>& pieces, const std::array<std::int64_t, 3>& voxel) {
  Expected expected;
  for (const Piece& piece : pieces) {
    double volume = piece.box.filling;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto begin = static_cast<double>(voxel[d]);
      volume *= std::max(
          0.0, std::min(piece.box.high[d], begin + 1.0) - std::max(piece.box.low[d], begin));
    }
    expected.volume += volume;
    expected.sum += volume * piece.value;
    if (volume > expected.largest) {
      expected.largest = volume;
      expected.label = piece.label;
    }
  }
  return expected;
}

/// Each rank adds every so-manieth piece, of which it knows no more than that they are in its reach.
void expect_means(const std::vector<Piece>& pieces, std::int64_t planes) {
  const voxels::Box everything{{-3, -3, -3}, {20, 20, 20}};
  int filled = 0, empty = 0;
  for (std::int64_t first = 0; first < size[2]; first += planes) {
    const std::int64_t count = std::min(planes, size[2] - first);
    BandMeans means(world(), size, first, count, everything, {Rule::mean, Rule::largest});
    for (std::size_t n = static_cast<std::size_t>(world().rank()); n < pieces.size();
         n += static_cast<std::size_t>(world().size())) {
      const double values[] = {pieces[n].value, pieces[n].label};
      if (means.is_reached_by(pieces[n].box)) means.add(pieces[n].box, values);
    }
    const auto values = means.values();
    ASSERT_EQ(values.size(), 2u);
    for (std::int64_t k = 0; k < values[0].planes; ++k)
      for (std::int64_t j = 0; j < size[1]; ++j)
        for (std::int64_t i = 0; i < size[0]; ++i) {
          const Expected expected = expected_of(pieces, {i, j, first + values[0].first_plane + k});
          const float mean = values[0].plane(k)[j * size[0] + i];
          const float label = values[1].plane(k)[j * size[0] + i];
          if (expected.volume >= 0.5) {
            ++filled;
            EXPECT_NEAR(mean, expected.sum / expected.volume, 1e-6);
            EXPECT_EQ(label, static_cast<float>(expected.label));
          } else {
            ++empty;
            EXPECT_TRUE(std::isnan(mean));
            EXPECT_EQ(label, -1.0f);
          }
        }
  }
  EXPECT_GT(world().sum(filled), 20);
  EXPECT_GT(world().sum(empty), 20);
}

TEST(BandMeans, AreThoseOfAllBoxesByTheVolumesThatTheyShare) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  std::vector<Piece> pieces;
  for (int n = 0; n < 90; ++n) {
    Piece piece;
    for (std::size_t d = 0; d < 3; ++d) {
      piece.box.low[d] = between(-1.0, static_cast<double>(size[d]));
      piece.box.high[d] = piece.box.low[d] + between(0.2, 2.3);
    }
    piece.box.filling = between(0.5, 1.0);
    piece.value = between(-1.0, 1.0);
    piece.label = static_cast<double>(random() % 4);
    pieces.push_back(piece);
  }
  for (const std::int64_t planes : {1, 2, 4, 32}) expect_means(pieces, planes);
}

TEST(BandMeans, BoxesThatMeetAtFacesOfVoxelsFillNoOthers) {
  BandMeans means(world(), {3, 1, 1}, 0, 1, {{0, 0, 0}, {3, 1, 1}}, {Rule::mean});
  // A face that rounding has put beyond that of the voxel.
  const FilledBox box{{1.0 - 1e-12, 0.0, 0.0}, {2.0 + 1e-12, 1.0, 1.0}, 1.0};
  const double value = 3.0;
  EXPECT_TRUE(means.is_reached_by(box));
  EXPECT_FALSE(means.is_reached_by({{3.0, 0.0, 0.0}, {4.0, 1.0, 1.0}, 1.0}));
  if (world().is_root()) means.add(box, &value);
  const auto found = means.values();
  if (found[0].planes == 0) return;
  EXPECT_TRUE(std::isnan(found[0].values[0]));
  EXPECT_EQ(found[0].values[1], 3.0f);
  EXPECT_TRUE(std::isnan(found[0].values[2]));
}

TEST(BandMeans, OfEqualBoxesTheSmallestLabelIsTaken) {
  BandMeans means(world(), {1, 1, 1}, 0, 1, {{0, 0, 0}, {1, 1, 1}}, {Rule::largest});
  const FilledBox left{{0.0, 0.0, 0.0}, {0.5, 1.0, 1.0}, 1.0};
  const FilledBox right{{0.5, 0.0, 0.0}, {1.0, 1.0, 1.0}, 1.0};
  const double one = 1.0, two = 2.0;
  const bool is_last = world().rank() == world().size() - 1;
  if (world().is_root()) means.add(left, &two);
  if (is_last) means.add(right, &one);
  const auto found = means.values();
  for (const float value : found[0].values) EXPECT_EQ(value, 1.0f);
}

}  // namespace
}  // namespace stroma
