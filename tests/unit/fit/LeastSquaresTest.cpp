// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// V-FIT-4: The search of a fit, on residuals whose least squares are known.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fit/LeastSquares.hpp"

namespace stroma {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

LeastSquaresSearch search_from(double x, double y) {
  return {Eigen::Vector2d(x, y),
          Eigen::Vector2d(-infinity, -infinity),
          Eigen::Vector2d(infinity, infinity),
          1e-10,
          0.0,
          50};
}

/// Rosenbrock's valley, r = (1 - x, 10 (y - x^2)).
LeastSquaresModel rosenbrock() {
  return {2, [](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
            r << 1.0 - x[0], 10.0 * (x[1] - x[0] * x[0]);
            if (jacobian != nullptr) *jacobian << -1.0, 0.0, -20.0 * x[0], 10.0;
            return true;
          }};
}

TEST(LeastSquares, FindsTheEndOfRosenbrocksValley) {
  const LeastSquaresResult found = minimize(rosenbrock(), search_from(-1.2, 1.0));
  EXPECT_TRUE(found.converged) << found.how_it_ended;
  EXPECT_NEAR(found.x[0], 1.0, 1e-8);
  EXPECT_NEAR(found.x[1], 1.0, 1e-8);
}

/// On the bound x = 0.5 the least is at y = x^2.
TEST(LeastSquares, KeepsBounds) {
  LeastSquaresSearch search = search_from(-1.2, 1.0);
  search.upper[0] = 0.5;
  const LeastSquaresResult found = minimize(rosenbrock(), search);
  EXPECT_TRUE(found.converged) << found.how_it_ended;
  EXPECT_EQ(found.x[0], 0.5);
  EXPECT_NEAR(found.x[1], 0.25, 1e-3);
}

/// Linear residuals are solved by one step but for the damping of 1e-6.
TEST(LeastSquares, BeginsWithAStepOfGaussAndNewton) {
  const LeastSquaresModel line{
      3, [](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
        for (int i = 0; i < 3; ++i) r[i] = x[0] + i * x[1] - 7.0;
        if (jacobian != nullptr) *jacobian << 1.0, 0.0, 1.0, 1.0, 1.0, 2.0;
        return true;
      }};
  LeastSquaresSearch search = search_from(1.0, 1.0);
  search.most_steps = 1;
  const LeastSquaresResult found = minimize(line, search);
  EXPECT_NEAR(found.x[0], 7.0, 1e-4);
  EXPECT_NEAR(found.x[1], 0.0, 1e-4);
}

/// log x where x <= 0 cannot be evaluated: the long first step is taken back.
TEST(LeastSquares, TakesBackAStepThatCannotBeEvaluated) {
  const LeastSquaresModel logarithm{
      1, [](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
        if (x[0] <= 0.0) return false;
        r[0] = std::log(x[0]);
        if (jacobian != nullptr) (*jacobian)(0, 0) = 1.0 / x[0];
        return true;
      }};
  const LeastSquaresResult found = minimize(
      logarithm, {Eigen::VectorXd::Constant(1, 4.0), Eigen::VectorXd::Constant(1, -infinity),
                  Eigen::VectorXd::Constant(1, infinity), 1e-10, 0.0, 50});
  EXPECT_TRUE(found.converged) << found.how_it_ended;
  EXPECT_NEAR(found.x[0], 1.0, 1e-8);
}

TEST(LeastSquares, SaysThatItCameToNoEnd) {
  LeastSquaresSearch search = search_from(-1.2, 1.0);
  search.most_steps = 2;
  EXPECT_FALSE(minimize(rosenbrock(), search).converged);
}

}  // namespace
}  // namespace stroma
