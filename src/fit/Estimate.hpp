// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How sure fitted numbers are.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace stroma {

/// A number as the search left it.
struct FittedNumber {
  std::string name;
  double value = 0.0;
  bool is_logarithmic = false;  ///< its interval is that of its logarithm
  bool is_at_bound = false;     ///< it counts as known for the others
};

/// Half the width of an interval that holds 95 % of a normal distribution, in standard deviations.
constexpr double two_sided_95 = 1.959963984540054;

/// What is known of one number. Nothing is known of one at its bound, nor of one that the
/// measurements do not tell at all.
struct NumberEstimate {
  std::optional<double> standard_deviation;
  double low = 0.0, high = 0.0;                    ///< 95 %
  double alone = 0.0;                              ///< relative half width if all others were known
  std::vector<std::optional<double>> correlation;  ///< with each number
};

struct Estimate {
  std::vector<NumberEstimate> numbers;
  std::vector<double> singular_values;  ///< of S, largest first
  std::vector<std::string> statements;  ///< in plain words: what the measurements tell
};

/// The covariance of numbers p whose forces were measured with normal, independent errors:
///
///     C = (J^T J)^-1,    J_ij = df_i/dp_j / error_i,
///
/// the inverse of the Hessian of chi^2 / 2, but for its part that vanishes with the residuals. It is
/// computed from the singular values s_k of S_ij = J_ij |p_j|, the change of the forces in errors
/// by a relative change of the numbers. A combination of numbers is determined to 1.96 / s_k of
/// them; one with more than 1 is called not determined. Numbers whose correlation is beyond 0.95
/// are called hard to tell apart.
///
/// \param numbers   the numbers
/// \param jacobian  J (force, number)
/// \param chi2      sum of squares that is left, in errors
Estimate estimate(const std::vector<FittedNumber>& numbers, const Eigen::MatrixXd& jacobian,
                  double chi2);

}  // namespace stroma
