// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// How sure fitted numbers are (V-FIT-4): against the covariance of a straight line, which books give.

#include <gtest/gtest.h>

#include <cmath>

#include "fit/Estimate.hpp"

namespace stroma {
namespace {

bool says(const Estimate& estimate, const std::string& text) {
  for (const std::string& statement : estimate.statements)
    if (statement.find(text) != std::string::npos) return true;
  return false;
}

/// y = a + b x at x = 0 ... 4, errors of 0.1: var b = s^2 / sum (x - 2)^2, var a = s^2 sum x^2 / (5 *
/// 10), cov = -s^2 * 2 / 10.
TEST(Estimate, IsThatOfAStraightLine) {
  Eigen::MatrixXd jacobian(5, 2);
  for (int i = 0; i < 5; ++i) jacobian.row(i) << 10.0, 10.0 * i;
  const Estimate line =
      estimate({{"a", 3.0, false, false}, {"b", -2.0, false, false}}, jacobian, 3.0);
  const double da = 0.1 * std::sqrt(30.0 / 50.0), db = 0.1 / std::sqrt(10.0);
  EXPECT_NEAR(*line.numbers[0].standard_deviation, da, 1e-13);
  EXPECT_NEAR(*line.numbers[1].standard_deviation, db, 1e-13);
  EXPECT_NEAR(*line.numbers[0].correlation[1], -0.002 / (da * db), 1e-12);
  EXPECT_NEAR(*line.numbers[0].correlation[0], 1.0, 1e-12);
  EXPECT_NEAR(line.numbers[1].low, -2.0 - 1.959963984540054 * db, 1e-12);
  EXPECT_NEAR(line.numbers[1].high, -2.0 + 1.959963984540054 * db, 1e-12);
  EXPECT_TRUE(line.statements.empty());
}

TEST(Estimate, OfALogarithmIsAFactor) {
  const Eigen::MatrixXd jacobian = Eigen::MatrixXd::Constant(4, 1, 0.05);
  const Estimate one = estimate({{"a", 100.0, true, false}}, jacobian, 2.0);
  EXPECT_NEAR(*one.numbers[0].standard_deviation, 10.0, 1e-12);
  EXPECT_NEAR(one.numbers[0].high / 100.0, 100.0 / one.numbers[0].low, 1e-12);
  EXPECT_NEAR(one.numbers[0].high, 100.0 * std::exp(0.1959963984540054), 1e-9);
}

TEST(Estimate, SaysWhatTheMeasurementsDoNotTell) {
  Eigen::MatrixXd alike(3, 2);
  alike << 1.0, 2.0, 2.0, 4.0, 3.0, 6.0;
  const Estimate twins = estimate({{"a", 4.0, false, false}, {"b", 2.0, false, false}}, alike, 1.0);
  EXPECT_FALSE(twins.numbers[0].standard_deviation);
  EXPECT_TRUE(says(twins, "do not determine this combination")) << twins.statements.size();
  EXPECT_NEAR(twins.singular_values[1], 0.0, 1e-12);

  Eigen::MatrixXd nearly = 100.0 * alike;
  nearly(2, 1) += 30.0;
  const Estimate close =
      estimate({{"a", 4.0, false, false}, {"b", 2.0, false, false}}, nearly, 1.0);
  EXPECT_TRUE(says(close, "a and b are hard to tell apart"));
  EXPECT_LT(*close.numbers[0].correlation[1], -0.95);

  Eigen::MatrixXd weak(3, 2);
  weak << 10.0, 0.1, 20.0, -0.1, 30.0, 0.1;
  const Estimate one = estimate({{"a", 1.0, false, false}, {"b", 1.0, false, false}}, weak, 1.0);
  EXPECT_TRUE(says(one, "b hardly moves the measured forces"));
  EXPECT_FALSE(says(one, "a hardly moves"));
}

TEST(Estimate, TakesANumberAtItsBoundAsKnown) {
  Eigen::MatrixXd jacobian(3, 2);
  jacobian << 1.0, 1.0, 1.0, 2.0, 1.0, 3.0;
  const Estimate both =
      estimate({{"a", 1.0, false, false}, {"b", 1.0, false, true}}, jacobian, 1.0);
  EXPECT_NEAR(*both.numbers[0].standard_deviation, 1.0 / std::sqrt(3.0), 1e-13);
  EXPECT_FALSE(both.numbers[1].standard_deviation);
  EXPECT_TRUE(says(both, "b is at its bound"));
}

TEST(Estimate, SaysThatTheErrorsAreTooSmall) {
  const Eigen::MatrixXd jacobian = Eigen::MatrixXd::Constant(9, 1, 10.0);
  EXPECT_TRUE(says(estimate({{"a", 1.0, false, false}}, jacobian, 80.0), "depart"));
  EXPECT_FALSE(says(estimate({{"a", 1.0, false, false}}, jacobian, 12.0), "depart"));
}

}  // namespace
}  // namespace stroma
