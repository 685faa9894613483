// SPDX-License-Identifier: BSD-3-Clause

#include "fit/LeastSquares.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <cmath>

namespace stroma {
namespace {

class Residuals : public ceres::CostFunction {
 public:
  Residuals(const LeastSquaresModel& model, Eigen::Index parameters) : model_(model) {
    set_num_residuals(model.residuals);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameters));
  }

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Index count = parameter_block_sizes().front();
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters[0], count);
    Eigen::VectorXd r(num_residuals());
    Eigen::MatrixXd jacobian(num_residuals(), count);
    const bool wants_jacobian = jacobians != nullptr && jacobians[0] != nullptr;
    if (!model_.evaluate(x, r, wants_jacobian ? &jacobian : nullptr)) return false;
    Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = r;
    for (Eigen::Index i = 0; wants_jacobian && i < num_residuals(); ++i)
      for (Eigen::Index j = 0; j < count; ++j) jacobians[0][i * count + j] = jacobian(i, j);
    return true;
  }

 private:
  const LeastSquaresModel& model_;
};

/// Ends the search where residuals do not get smaller any more by what they can tell.
class Enough : public ceres::IterationCallback {
 public:
  explicit Enough(double least_change) : least_change_(least_change) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    const bool is_small =
        step.step_is_successful && step.iteration > 0 && std::abs(step.cost_change) < least_change_;
    return is_small || step.cost < least_change_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                                 : ceres::SOLVER_CONTINUE;
  }

 private:
  double least_change_;
};

}  // namespace

LeastSquaresResult minimize(const LeastSquaresModel& model, const LeastSquaresSearch& search) {
  FLAGS_minloglevel = google::GLOG_FATAL;  // what went wrong is in the summary
  LeastSquaresResult result;
  result.x = search.start;
  ceres::Problem problem;
  problem.AddResidualBlock(new Residuals(model, search.start.size()), nullptr, result.x.data());
  for (int i = 0; i < static_cast<int>(search.start.size()); ++i) {
    if (std::isfinite(search.lower[i]))
      problem.SetParameterLowerBound(result.x.data(), i, search.lower[i]);
    if (std::isfinite(search.upper[i]))
      problem.SetParameterUpperBound(result.x.data(), i, search.upper[i]);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.initial_trust_region_radius = 1e6;
  options.parameter_tolerance = search.tolerance;
  options.function_tolerance = 0.0;
  Enough enough(search.least_change);
  options.callbacks.push_back(&enough);
  options.max_num_iterations = search.most_steps;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  result.converged = summary.termination_type == ceres::CONVERGENCE ||
                     summary.termination_type == ceres::USER_SUCCESS;
  result.how_it_ended = summary.message;
  return result;
}

}  // namespace stroma
