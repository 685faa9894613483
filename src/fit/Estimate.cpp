// SPDX-License-Identifier: BSD-3-Clause

#include "fit/Estimate.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "stroma/base/Log.hpp"

namespace stroma {
namespace {

using base::format;

constexpr double large_correlation = 0.95;
constexpr double vanishing = 1e-10;  // singular values, of the largest

/// "vessel by +1, gel by -0.3": a direction in which relative changes leave the forces as they are.
std::string combination(const Eigen::VectorXd& direction, const std::vector<std::string>& names) {
  const double largest = direction.cwiseAbs().maxCoeff();
  std::string text;
  for (Eigen::Index j = 0; j < direction.size(); ++j) {
    const double share = direction[j] / largest;
    if (std::abs(share) < 0.05) continue;
    text += format("%s%s by %+.2g", text.empty() ? "" : ", ",
                   names[static_cast<std::size_t>(j)].c_str(), share);
  }
  return text;
}

void add_fit_quality(double chi2, Eigen::Index freedom, std::vector<std::string>& statements) {
  if (freedom <= 0) return;
  const double ratio = chi2 / static_cast<double>(freedom);
  const double spread = std::sqrt(2.0 / static_cast<double>(freedom));
  if (ratio > 1.0 + 3.0 * spread)
    statements.push_back(
        format("the forces depart from the measurements by more than the errors allow (chi^2 per "
               "degree of freedom %.3g): the deck does not describe them, or the errors are given "
               "too small; the intervals are too narrow then",
               ratio));
}

}  // namespace

Estimate estimate(const std::vector<FittedNumber>& numbers, const Eigen::MatrixXd& jacobian,
                  double chi2) {
  Estimate result;
  result.numbers.resize(numbers.size());
  std::vector<std::size_t> free;
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    result.numbers[j].correlation.resize(numbers.size());
    if (numbers[j].is_at_bound)
      result.statements.push_back(numbers[j].name +
                                  " is at its bound: it has no interval, and counts as known for "
                                  "the others");
    else
      free.push_back(j);
  }
  const auto count = static_cast<Eigen::Index>(free.size());
  add_fit_quality(chi2, jacobian.rows() - count, result.statements);
  if (count == 0) return result;

  Eigen::MatrixXd S(jacobian.rows(), count);
  std::vector<double> scale;
  std::vector<std::string> names;
  for (Eigen::Index k = 0; k < count; ++k) {
    const FittedNumber& number = numbers[free[static_cast<std::size_t>(k)]];
    scale.push_back(number.value == 0.0 ? 1.0 : std::abs(number.value));
    names.push_back(number.name);
    S.col(k) =
        jacobian.col(static_cast<Eigen::Index>(free[static_cast<std::size_t>(k)])) * scale.back();
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(S, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& s = svd.singularValues();
  result.singular_values.assign(s.data(), s.data() + s.size());
  const Eigen::MatrixXd& V = svd.matrixV();
  const bool is_singular = !(s[count - 1] > vanishing * s[0]);

  for (Eigen::Index k = 0; k < count; ++k) {
    NumberEstimate& one = result.numbers[free[static_cast<std::size_t>(k)]];
    one.alone = two_sided_95 / S.col(k).norm();
    if (!(one.alone <= 1.0))
      result.statements.push_back(names[static_cast<std::size_t>(k)] +
                                  " hardly moves the measured forces: they do not determine it");
  }
  for (Eigen::Index k = 0; k < s.size(); ++k)
    if (count > 1 && !(two_sided_95 / s[k] <= 1.0))
      result.statements.push_back(
          "the measurements do not determine this combination of numbers: " +
          combination(V.col(k), names) +
          " (relative changes that leave the forces within their errors)");
  if (is_singular) return result;

  const Eigen::MatrixXd covariance =
      V * s.array().square().inverse().matrix().asDiagonal() * V.transpose();
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::size_t j = free[static_cast<std::size_t>(k)];
    NumberEstimate& one = result.numbers[j];
    const double relative = std::sqrt(covariance(k, k));
    const double deviation = relative * scale[static_cast<std::size_t>(k)];
    one.standard_deviation = deviation;
    one.low = numbers[j].is_logarithmic ? numbers[j].value * std::exp(-two_sided_95 * relative)
                                        : numbers[j].value - two_sided_95 * deviation;
    one.high = numbers[j].is_logarithmic ? numbers[j].value * std::exp(two_sided_95 * relative)
                                         : numbers[j].value + two_sided_95 * deviation;
    for (Eigen::Index l = 0; l < count; ++l) {
      const std::size_t i = free[static_cast<std::size_t>(l)];
      one.correlation[i] = covariance(k, l) / std::sqrt(covariance(k, k) * covariance(l, l));
      if (l < k && std::abs(*one.correlation[i]) > large_correlation)
        result.statements.push_back(format("%s and %s are hard to tell apart (correlation %.3f)",
                                           numbers[i].name.c_str(), numbers[j].name.c_str(),
                                           *one.correlation[i]));
    }
  }
  return result;
}

}  // namespace stroma
