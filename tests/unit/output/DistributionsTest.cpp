// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Percentiles and histograms over ranks, against sorted lists on one.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "TemporaryFolder.hpp"
#include "stroma/output/tables/Distributions.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using output::Distribution;
using output::Groups;

struct Portion {
  double value, volume;
};

std::vector<Portion> random_portions(int count, double low, double high) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(low, high), volume(0.1, 2.0);
  std::vector<Portion> all;
  for (int n = 0; n < count; ++n) all.push_back({value(random), volume(random)});
  return all;
}

/// Of groups whose portions are dealt to the ranks, with some that belong to none.
std::vector<Distribution> found(const std::vector<std::vector<Portion>>& groups,
                                const std::vector<double>& shares) {
  Groups of{{Groups::none}, groups.size()};
  std::vector<double> volume{1e9}, values{-1e9};
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t n = 0; n < groups[g].size(); ++n) {
      if (static_cast<int>(n * 7 / 3) % world().size() != world().rank()) continue;
      of.of.push_back(static_cast<std::uint16_t>(g));
      volume.push_back(groups[g][n].volume);
      values.push_back(groups[g][n].value);
    }
  return output::distributions(world(), of, volume, values, shares);
}

void expect_sorted_list(std::vector<Portion> group, const std::vector<double>& shares,
                        const Distribution& is) {
  std::sort(group.begin(), group.end(), [](auto& a, auto& b) { return a.value < b.value; });
  double volume = 0.0, sum = 0.0;
  for (const Portion& one : group) {
    volume += one.volume;
    sum += one.volume * one.value;
  }
  EXPECT_NEAR(is.volume, volume, 1e-12 * volume);
  EXPECT_NEAR(is.mean, sum / volume, 1e-12 * std::abs(sum / volume));
  EXPECT_EQ(is.minimum, group.front().value);
  EXPECT_EQ(is.maximum, group.back().value);
  for (std::size_t s = 0; s < shares.size(); ++s) {
    double up_to = 0.0;
    std::size_t n = 0;
    while ((up_to += group[n].volume) < shares[s] * volume) ++n;
    EXPECT_EQ(is.percentiles[s], group[n].value);
  }
  std::array<double, Distribution::bin_count> bins{};
  const double range = is.maximum - is.minimum;
  for (const Portion& one : group) {
    std::size_t bin = 0;  // by its edges, not by division
    while (range > 0.0 && bin + 1 < bins.size() &&
           one.value >= is.minimum + range * static_cast<double>(bin + 1) / 64.0)
      ++bin;
    bins[bin] += one.volume;
  }
  for (std::size_t bin = 0; bin < bins.size(); ++bin)
    EXPECT_NEAR(is.bins[bin], bins[bin], 1e-12 * volume);
}

// V-TABLE-1.
TEST(Distributions, AreThoseOfASortedList) {
  const std::vector<double> shares{0.05, 0.25, 0.5, 0.75, 0.95};
  std::vector<std::vector<Portion>> groups{
      random_portions(1000, -3.0, 8.0), random_portions(1, 1e-300, 2e-300),
      random_portions(77, -2e5, -1e5), random_portions(500, 1.0, 1.0 + 1e-6)};
  groups.push_back(groups[0]);
  groups.back().push_back({1e9, 0.5});   // leaves all others in one bin
  for (const int repeated : {1, 100}) {  // many groups have coarser buckets
    std::vector<std::vector<Portion>> all;
    for (int n = 0; n < repeated; ++n) all.insert(all.end(), groups.begin(), groups.end());
    const auto are = found(all, shares);
    ASSERT_EQ(are.size(), all.size());
    for (std::size_t g = 0; g < groups.size(); ++g)
      expect_sorted_list(groups[g], shares, are[all.size() - groups.size() + g]);
  }
}

TEST(Distributions, PercentilesAtATieAreTheLowerValue) {
  // Of 100 equal volumes, 5 are 5 %, however their sums are rounded.
  std::vector<Portion> all;
  for (int n = 0; n < 100; ++n) all.push_back({static_cast<double>((n * 37) % 100) - 50.0, 0.1});
  EXPECT_EQ(found({all}, {0.05, 0.5, 0.55, 0.95})[0].percentiles,
            (std::vector<double>{-46.0, -1.0, 4.0, 44.0}));
}

TEST(Distributions, OfNothingAreZeros) {
  const auto are = found({{}, {{-0.0, 1.0}, {0.0, 1.0}}, {}}, {0.5});
  for (const std::size_t empty : {0, 2}) {
    EXPECT_EQ(are[empty].volume, 0.0);
    EXPECT_EQ(are[empty].percentiles, std::vector<double>{0.0});
    EXPECT_EQ(are[empty].bins[0], 0.0);
  }
  EXPECT_EQ(are[1].percentiles[0], 0.0);
  EXPECT_EQ(are[1].bins[0], 2.0);
  EXPECT_TRUE(found({}, {0.5}).empty());
}

}  // namespace
}  // namespace stroma
