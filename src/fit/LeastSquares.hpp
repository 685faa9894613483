// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Least squares with bounds, by Ceres' Levenberg-Marquardt method.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace stroma {

/// Residuals r(x), and their derivatives where they are asked for.
struct LeastSquaresModel {
  int residuals = 0;
  /// \param x         parameters, near 1
  /// \param r         (residual)
  /// \param jacobian  (residual, parameter) dr/dx; null: not asked for
  /// \return whether x can be evaluated; where it cannot, shorter steps are tried
  std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian)>
      evaluate;
};

struct LeastSquaresSearch {
  Eigen::VectorXd start, lower, upper;  ///< (parameter); bounds may be infinite
  double tolerance = 1e-6;              ///< ||step|| <= tolerance * ||x|| ends the search
  /// So does a step that makes |r|^2 / 2 less by less than this, or a |r|^2 / 2 below it.
  double least_change = 0.0;
  int most_steps = 30;
};

struct LeastSquaresResult {
  Eigen::VectorXd x;
  bool converged = false;
  std::string how_it_ended;
};

/// Minimises |r(x)|^2 / 2 between bounds. The first step is one of Gauss-Newton but for 1e-6 of it.
LeastSquaresResult minimize(const LeastSquaresModel& model, const LeastSquaresSearch& search);

}  // namespace stroma
