// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Draws of inputs, their bands and rank correlations (V-UNCERTAINTY-1).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "study/Bands.hpp"
#include "study/Draws.hpp"

namespace stroma {
namespace {

UncertaintyParameters three_inputs(int draws) {
  UncertaintyParameters uncertainty;
  uncertainty.draws = draws;
  InputParameters uniform{"A", Distribution::uniform, std::array<double, 2>{-2.0, 3.0}, {}, {}, {},
                          {}};
  InputParameters normal{"B", Distribution::normal, {}, 10.0, 2.0, {}, {}};
  InputParameters log_normal{"C", Distribution::log_normal, {}, {}, {}, 100.0, 0.25};
  uncertainty.inputs.all = {{"a", uniform}, {"b", normal}, {"c", log_normal}};
  return uncertainty;
}

/// z(0.975) and z(0.95), from tables.
TEST(Draws, HaveTheQuantilesOfTheirDistributions) {
  const auto inputs = three_inputs(5).inputs.all;
  EXPECT_NEAR(quantile(inputs[0].second, 0.3), -0.5, 1e-14);
  EXPECT_NEAR(quantile(inputs[1].second, 0.975), 10.0 + 2.0 * 1.959963984540054, 1e-12);
  EXPECT_NEAR(quantile(inputs[1].second, 0.5), 10.0, 1e-12);
  EXPECT_NEAR(quantile(inputs[2].second, 0.05), 100.0 * std::exp(-0.25 * 1.6448536269514722),
              1e-10);
}

/// Each n-th of an input's probability has one draw, and inputs do not follow each other.
TEST(Draws, AreALatinHypercube) {
  const UncertaintyParameters uncertainty = three_inputs(200);
  const auto draws = latin_hypercube(uncertainty);
  ASSERT_EQ(draws.size(), 200u);
  std::vector<std::vector<double>> columns(3);
  for (const auto& draw : draws)
    for (std::size_t i = 0; i < 3; ++i) columns[i].push_back(draw[i]);
  EXPECT_LT(std::abs(*rank_correlation(columns[0], columns[1])), 0.2);
  EXPECT_LT(std::abs(*rank_correlation(columns[1], columns[2])), 0.2);
  for (std::size_t i = 0; i < 3; ++i) {
    std::sort(columns[i].begin(), columns[i].end());
    const InputParameters& input = uncertainty.inputs.all[i].second;
    for (std::size_t n = 1; n < 200; ++n) {
      const double edge = quantile(input, static_cast<double>(n) / 200.0);
      EXPECT_LT(columns[i][n - 1], edge);
      EXPECT_GE(columns[i][n], edge);
    }
  }
  EXPECT_EQ(latin_hypercube(uncertainty), draws);
  UncertaintyParameters other = uncertainty;
  other.seed = 2;
  EXPECT_NE(latin_hypercube(other), draws);
}

/// Of few draws some follow each other; what is said is their rank correlation.
TEST(Draws, ThatFollowEachOtherAreTold) {
  EXPECT_TRUE(draw_notes(three_inputs(200)).empty());
  const UncertaintyParameters few = three_inputs(5);
  std::vector<std::vector<double>> columns(3);
  for (const auto& draw : latin_hypercube(few))
    for (std::size_t i = 0; i < 3; ++i) columns[i].push_back(draw[i]);
  std::size_t told = 0;
  const std::vector<std::string> notes = draw_notes(few);
  for (const auto& [a, b] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
    const double r = *rank_correlation(columns[a], columns[b]);
    if (std::abs(r) <= 0.3) continue;
    char figure[16];
    std::snprintf(figure, sizeof figure, "%.2f", r);
    ASSERT_LT(told, notes.size());
    EXPECT_NE(notes[told++].find(figure), std::string::npos) << notes[told - 1];
  }
  EXPECT_EQ(told, notes.size());
  EXPECT_GT(told, 0u);
}

/// Of 0 ... 100 in any order; between neighbours, linear.
TEST(Bands, AreQuantiles) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back((37 * i) % 101);
  const Band band = band_of(values);
  EXPECT_NEAR(band.low, 5.0, 1e-13);
  EXPECT_NEAR(band.median, 50.0, 1e-13);
  EXPECT_NEAR(band.high, 95.0, 1e-13);
  std::vector<double> two{4.0, 2.0};
  EXPECT_NEAR(band_of(two).low, 2.1, 1e-13);
}

/// By hand: 1 - 6 sum d^2 / (n (n^2 - 1)) without ties.
TEST(RankCorrelation, IsSpearmans) {
  EXPECT_NEAR(*rank_correlation({1, 2, 3, 4, 5}, {1, 8, 27, 64, 125}), 1.0, 1e-15);
  EXPECT_NEAR(*rank_correlation({1, 2, 3, 4, 5}, {9, 7, 5, 3, 1}), -1.0, 1e-15);
  EXPECT_NEAR(*rank_correlation({1, 2, 3, 4, 5}, {2, 1, 4, 3, 5}), 1.0 - 6.0 * 4.0 / 120.0, 1e-15);
  EXPECT_NEAR(*rank_correlation({1, 1, 2, 2}, {1, 2, 3, 4}), 2.0 / std::sqrt(5.0), 1e-15);
  EXPECT_FALSE(rank_correlation({1, 1, 1}, {1, 2, 3}));
  EXPECT_FALSE(rank_correlation({1, 2}, {1, 2}));
}

TEST(ForceBands, AreThoseOfEachLoad) {
  std::vector<ForceRecord> draws;
  for (int n = 0; n <= 20; ++n) draws.push_back({{0.0, 1.0}, {0.0, static_cast<double>(n)}});
  const auto bands = force_bands(draws, {0.0, 0.5, 1.0});
  EXPECT_EQ(bands[0].high, 0.0);
  EXPECT_NEAR(bands[1].high, 9.5, 1e-13);
  EXPECT_NEAR(bands[2].low, 1.0, 1e-13);
}

}  // namespace
}  // namespace stroma
