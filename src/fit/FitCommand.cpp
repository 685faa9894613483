// SPDX-License-Identifier: BSD-3-Clause

#include "fit/FitCommand.hpp"

#include <mpi.h>

#include <cmath>
#include <exception>
#include <limits>

#include "fit/FitPlan.hpp"
#include "fit/FitReport.hpp"
#include "fit/FitRuns.hpp"
#include "fit/FitTables.hpp"
#include "fit/LeastSquares.hpp"
#include "run/ReportFile.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/files/WriteFile.hpp"
#include "stroma/output/pictures/FitPicture.hpp"

namespace stroma {
namespace {

using base::format;

/// A number p as the search sees it, near 1: x = p / unit, or x = 1 + log(p / unit); the unit is its
/// start.
struct Scale {
  double unit = 1.0;
  bool is_logarithmic = false;

  explicit Scale(const FittedParameters& p)
      : unit(p.start == 0.0 ? 1.0 : p.start), is_logarithmic(p.logarithmic) {}
  double x(double p) const { return is_logarithmic ? 1.0 + std::log(p / unit) : p / unit; }
  double p(double x) const { return is_logarithmic ? unit * std::exp(x - 1.0) : x * unit; }
  double dp_dx(double x) const { return is_logarithmic ? p(x) : unit; }
};

/// Of chi^2 / 2: it moves numbers by some 1e-4 of their standard deviations.
constexpr double least_change = 1e-7;

/// The search of one fit.
class Search {
 public:
  Search(const FitPlan& plan, FitRuns& runs, std::function<void()> after_each)
      : plan_(&plan), runs_(&runs), after_each_(std::move(after_each)) {
    for (const auto& named : plan.parameters.parameters.all) scales_.emplace_back(named.second);
  }

  /// \return the numbers \throws base::RunError, base::Interrupted
  std::vector<double> run() {
    const auto& all = plan_->parameters.parameters.all;
    const auto count = static_cast<Eigen::Index>(all.size());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    LeastSquaresSearch search{Eigen::VectorXd::Ones(count),
                              Eigen::VectorXd::Constant(count, -infinity),
                              Eigen::VectorXd::Constant(count, infinity),
                              plan_->parameters.tolerance,
                              least_change,
                              plan_->parameters.most_steps};
    for (Eigen::Index j = 0; j < count; ++j) {
      const FittedParameters& one = all[static_cast<std::size_t>(j)].second;
      const Scale& scale = scales_[static_cast<std::size_t>(j)];
      if (one.start == 0.0) search.start[j] = 0.0;
      double low = one.lower ? scale.x(*one.lower) : -infinity;
      double high = one.upper ? scale.x(*one.upper) : infinity;
      if (scale.unit < 0.0) {
        low = one.upper ? scale.x(*one.upper) : -infinity;
        high = one.lower ? scale.x(*one.lower) : infinity;
      }
      search.lower[j] = low;
      search.upper[j] = high;
    }
    const LeastSquaresModel model{
        static_cast<int>(plan_->points.size()),
        [this](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
          return evaluate(x, r, jacobian);
        }};
    const LeastSquaresResult found = minimize(model, search);
    if (interrupted_) std::rethrow_exception(interrupted_);
    const FitRun& first = runs_->all().front();
    if (!first.failure.empty())
      throw base::RunError("the run at the start failed: " + first.failure);
    if (!found.converged)
      throw base::RunError("the search came to no end: " + found.how_it_ended +
                           "\nto go on: begin nearer by, or look for fewer numbers");
    return runs_->at(numbers(found.x)).values;
  }

 private:
  std::vector<double> numbers(const Eigen::VectorXd& x) const {
    std::vector<double> values;
    for (std::size_t j = 0; j < scales_.size(); ++j)
      values.push_back(scales_[j].p(x[static_cast<Eigen::Index>(j)]));
    return values;
  }

  /// What ends a fit is kept until the search, which knows no exceptions, has given up.
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
    if (interrupted_) return false;
    try {
      const std::vector<double> values = numbers(x);
      const FitRun run = runs_->at(values);
      after_each_();
      if (!run.failure.empty()) return false;
      Eigen::MatrixXd derivatives;
      if (jacobian != nullptr) {
        derivatives = runs_->derivatives(values);
        if (derivatives.size() == 0) return false;
      }
      for (Eigen::Index i = 0; i < r.size(); ++i) {
        const MeasuredForce& measured = plan_->points[static_cast<std::size_t>(i)].measured;
        r[i] = (run.forces[i] - measured.force) / measured.error;
        for (Eigen::Index j = 0; j < derivatives.cols(); ++j)
          (*jacobian)(i, j) =
              derivatives(i, j) / measured.error * scales_[static_cast<std::size_t>(j)].dp_dx(x[j]);
      }
      return true;
    } catch (...) {
      interrupted_ = std::current_exception();
      return false;
    }
  }

  const FitPlan* plan_;
  FitRuns* runs_;
  std::function<void()> after_each_;
  std::vector<Scale> scales_;
  std::exception_ptr interrupted_;
};

std::vector<FittedNumber> fitted_numbers(const FitPlan& plan, const std::vector<double>& values) {
  std::vector<FittedNumber> numbers;
  for (std::size_t j = 0; j < values.size(); ++j) {
    const auto& [name, one] = plan.parameters.parameters.all[j];
    const double near = 1e-9 * std::abs(values[j]);
    const bool is_at_bound = (one.lower && values[j] <= *one.lower + near) ||
                             (one.upper && values[j] >= *one.upper - near);
    numbers.push_back({name, values[j], one.logarithmic, is_at_bound});
  }
  return numbers;
}

std::string draw(const base::Communicator& communicator, const FitPlan& plan, const FitRun& best,
                 const std::string& folder) {
  std::vector<output::FittedCurve> curves;
  const auto& measurements = plan.parameters.measurements.all;
  for (const auto& [name, measurement] : measurements)
    curves.push_back({name, measurement.against == Against::strain, {}, {}, {}, {}});
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    const FitPoint& point = plan.points[i];
    output::FittedCurve& curve = curves[point.measurement];
    curve.abscissa.push_back(point.measured.abscissa);
    curve.measured.push_back(point.measured.force);
    curve.error.push_back(point.measured.error);
    curve.fitted.push_back(best.forces[static_cast<Eigen::Index>(i)]);
  }
  return output::draw_fit(communicator, folder, plan.title, curves);
}

}  // namespace

void fit_command(const base::Communicator& communicator, const std::string& fit_deck,
                 const std::string& output_folder, base::Log& log) {
  const double start = MPI_Wtime();
  const output::RunFolder folder(communicator, output_folder, output::fit_files());
  const FitPlan plan = plan_fit(communicator, fit_deck);
  folder.refuse_foreign_files(plan.files);
  FitRuns runs(communicator, plan, folder.folder(), log);
  runs.refuse_foreign_files(starts(plan));
  folder.remove_old_results(log);
  base::collectively(communicator, [&] { log.open_file(folder.log()); });
  if (!plan.title.empty()) log.line("title       " + plan.title);
  log.line(format("fit         %s: %zu number%s, %zu measured forces", fit_deck.c_str(),
                  plan.parameters.parameters.all.size(),
                  plan.parameters.parameters.all.size() == 1 ? "" : "s", plan.points.size()));
  log.line(plan.has_adjoint()
               ? "derivatives by the adjoint, with each run"
               : "derivatives by differences, a run for each: " + plan.no_adjoint_because);

  const auto write = [&](const std::string& name, const std::string& text) {
    base::collectively(communicator, [&] {
      if (communicator.is_root()) output::write_file(folder.file(name), text);
    });
  };
  const std::vector<double> values =
      Search(plan, runs, [&] { write("fit.csv", runs_table(plan, runs.all())); }).run();
  const FitRun best = runs.at(values);
  Eigen::MatrixXd jacobian = runs.derivatives(values);
  if (jacobian.size() == 0) throw base::RunError("a run beside the fitted numbers failed");
  for (Eigen::Index i = 0; i < jacobian.rows(); ++i)
    jacobian.row(i) /= plan.points[static_cast<std::size_t>(i)].measured.error;
  const std::vector<FittedNumber> numbers = fitted_numbers(plan, values);
  const Estimate how_sure = estimate(numbers, jacobian, best.chi2);
  write("fit.csv", runs_table(plan, runs.all()));
  write("estimates.csv", estimates_table(plan, numbers, how_sure));
  write("fitted.csv", fitted_table(plan, runs.all().front(), best));
  log.line("");
  for (const std::string& line : fit_summary(plan, numbers, how_sure, best)) log.line(line);
  log.line("");
  const std::string failure = draw(communicator, plan, best, folder.folder());
  if (!failure.empty()) log.note(failure);
  report_at_end(log, [&] { fit_report(communicator, folder.folder(), log); });
  folder.finish();
  log.line(format("%zu runs, %zu of them new, %.1f s on %d rank%s; %s", runs.all().size(),
                  runs.solved(), MPI_Wtime() - start, communicator.size(),
                  communicator.size() == 1 ? "" : "s", folder.file("estimates.csv").c_str()));
  folder.finish("log.txt");
}

}  // namespace stroma
