// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The extrapolation is exact for f = f0 + c h^p, and says when there is none.

#include <gtest/gtest.h>

#include <cmath>

#include "study/Richardson.hpp"

namespace stroma {
namespace {

SizedFigure at(double size, double f0, double c, double p) {
  return {size, f0 + c * std::pow(size, p)};
}

// V-RICHARDSON.
TEST(Richardson, IsExactForAPower) {
  for (const double p : {0.5, 1.0, 1.7, 2.0, 4.0}) {
    for (const double c : {3.0, -0.02}) {
      for (const double ratio : {2.0, 1.5}) {
        const double h = 2.1;
        const auto result = richardson({at(h, 79379.0, c, p), at(h * ratio, 79379.0, c, p),
                                        at(h * ratio * ratio, 79379.0, c, p)});
        ASSERT_TRUE(result.extrapolation) << result.undefined_because;
        EXPECT_NEAR(result.extrapolation->value, 79379.0, 1e-12 * 79379.0);
        EXPECT_NEAR(result.extrapolation->order, p, 1e-8);
        EXPECT_EQ(result.extrapolation->sizes[2], h);
      }
    }
  }
}

TEST(Richardson, TakesTheFinestThreeWithAConstantRatio) {
  // 1, 2, 4 follow one law; 8 and the odd 3 do not.
  const auto result = richardson({{8.0, -50.0},
                                  at(4.0, 10.0, 1.0, 2.0),
                                  {3.0, 77.0},
                                  at(1.0, 10.0, 1.0, 2.0),
                                  at(2.0, 10.0, 1.0, 2.0)});
  ASSERT_TRUE(result.extrapolation);
  EXPECT_NEAR(result.extrapolation->value, 10.0, 1e-13);
  EXPECT_NEAR(result.extrapolation->order, 2.0, 1e-13);
  EXPECT_EQ(result.extrapolation->sizes, (std::array<double, 3>{4.0, 2.0, 1.0}));
}

std::string why_not(const std::vector<SizedFigure>& figures, double noise = 0.0) {
  const auto result = richardson(figures, noise);
  EXPECT_FALSE(result.extrapolation);
  return result.undefined_because;
}

TEST(Richardson, SaysWhyItIsUndefined) {
  EXPECT_EQ(why_not({{2.0, 1.0}, {1.0, 1.5}}), "it takes three sizes");
  EXPECT_EQ(why_not({{4.0, 1.0}, {2.0, 1.5}, {1.1, 1.6}}), "no three sizes have a constant ratio");
  const std::string growing = "the differences do not shrink monotonically";
  EXPECT_EQ(why_not({{4.0, 1.0}, {2.0, 2.0}, {1.0, 1.5}}), growing);  // there and back
  EXPECT_EQ(why_not({{4.0, 1.0}, {2.0, 2.0}, {1.0, 3.5}}), growing);  // growing
  EXPECT_EQ(why_not({{4.0, 1.0}, {2.0, 2.0}, {1.0, 3.0}}), growing);  // steady: order 0
  EXPECT_EQ(why_not({{4.0, 1.0}, {2.0, 1.0}, {1.0, 2.0}}), growing);
  EXPECT_EQ(why_not({{4.0, 1.0}, {2.0, 2.0}, {1.0, 2.0}}), growing);
}

TEST(Richardson, DoesNotReadMeaningIntoNoise) {
  const std::vector<SizedFigure> figures{{4.0, 100.0 + 4e-8}, {2.0, 100.0 + 1e-8}, {1.0, 100.0}};
  EXPECT_EQ(why_not(figures, 1e-7), "the figure does not depend on the size");
  EXPECT_TRUE(richardson(figures, 1e-12).extrapolation);
}

}  // namespace
}  // namespace stroma
