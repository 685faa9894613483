// SPDX-License-Identifier: BSD-3-Clause

#include "fit/FitRuns.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "stroma/base/Error.hpp"
#include "stroma/output/files/HistoryTable.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "study/ForceDeparture.hpp"
#include "study/MemberRun.hpp"

namespace stroma {
namespace {

using base::format;

/// Ten digits, as the run's deck has them.
std::vector<double> tidy(const std::vector<double>& values) {
  std::vector<double> result;
  for (const double value : values)
    result.push_back(std::strtod(format("%.10g", value).c_str(), nullptr));
  return result;
}

/// A column by load factor; 0 at the unloaded body, which a table of derivatives leaves out.
ForceRecord record_of(const output::HistoryTable& table, const std::string& column) {
  ForceRecord record{table.column("load"), table.column(column)};
  if (record.load.empty() || record.load.front() > 0.0) {
    record.load.insert(record.load.begin(), 0.0);
    record.force.insert(record.force.begin(), 0.0);
  }
  return record;
}

}  // namespace

FitRuns::FitRuns(const base::Communicator& communicator, const FitPlan& plan, std::string folder,
                 base::Log& log)
    : communicator_(communicator), plan_(&plan), folder_(std::move(folder)), log_(&log) {}

/// Reads forces and derivatives from the files of a finished run. \return whether all are there
bool FitRuns::read_back(FitRun& run) const {
  const auto points = static_cast<Eigen::Index>(plan_->points.size());
  const auto count = static_cast<Eigen::Index>(run.values.size());
  run.forces = Eigen::VectorXd::Zero(points);
  if (plan_->has_adjoint()) run.by_adjoint = Eigen::MatrixXd::Zero(points, count);
  int is_whole = 1;
  if (communicator_.is_root()) {
    try {
      const std::string folder = folder_ + "/" + run.folder;
      const output::HistoryTable history(folder + "/history.csv");
      const output::HistoryTable sensitivity =
          plan_->has_adjoint() ? output::HistoryTable(folder + "/sensitivity.csv")
                               : output::HistoryTable();
      if (plan_->has_adjoint() && sensitivity.rows() + 1 != history.rows()) is_whole = 0;
      for (Eigen::Index i = 0; is_whole == 1 && i < points; ++i) {
        const FitPoint& point = plan_->points[static_cast<std::size_t>(i)];
        const Reaction& reaction = plan_->reactions[point.reaction];
        run.forces[i] = force_at(record_of(history, reaction.column()), point.load);
        for (Eigen::Index j = 0; j < run.by_adjoint.cols(); ++j) {
          const std::string& path =
              plan_->parameters.parameters.all[static_cast<std::size_t>(j)].second.path;
          run.by_adjoint(i, j) =
              force_at(record_of(sensitivity, Sensitivity::column(reaction, path)), point.load);
        }
      }
    } catch (const base::RunError&) {
      is_whole = 0;
    }
  }
  communicator_.broadcast(is_whole);
  communicator_.broadcast(run.forces.data(), static_cast<std::size_t>(run.forces.size()));
  communicator_.broadcast(run.by_adjoint.data(), static_cast<std::size_t>(run.by_adjoint.size()));
  for (Eigen::Index i = 0; i < points; ++i) {
    const MeasuredForce& measured = plan_->points[static_cast<std::size_t>(i)].measured;
    run.chi2 += std::pow((run.forces[i] - measured.force) / measured.error, 2);
  }
  return is_whole == 1;
}

void FitRuns::refuse_foreign_files(const std::vector<double>& values) const {
  const std::string folder = folder_ + "/" + folder_of(*plan_, values);
  std::optional<Deck> deck;
  base::collectively(communicator_, [&] { deck = deck_with(*plan_, values); });
  int kept = communicator_.is_root() && is_finished(folder, *deck) ? 1 : 0;
  communicator_.broadcast(kept);
  if (kept == 0)
    output::refuse_foreign_files(communicator_, folder, run_files(*deck), plan_->files);
}

FitRun FitRuns::make(const std::vector<double>& values) {
  FitRun run;
  run.values = values;
  run.folder = folder_of(*plan_, values);
  const std::string folder = folder_ + "/" + run.folder;
  std::optional<Deck> deck;
  std::optional<Sensitivity> sensitivity;
  try {
    base::collectively(communicator_, [&] {
      deck = deck_with(*plan_, values);
      if (!plan_->has_adjoint()) return;
      std::vector<std::string> paths;
      for (const auto& named : plan_->parameters.parameters.all) paths.push_back(named.second.path);
      sensitivity.emplace(communicator_, *deck, paths, values, plan_->reactions,
                          folder + "/sensitivity.csv");
    });
  } catch (const base::InputError& error) {
    run.failure = in_terms_of("the fit", error.what());
    return run;
  }
  int kept = communicator_.is_root() && is_finished(folder, *deck) ? 1 : 0;
  communicator_.broadcast(kept);
  run.is_kept = kept == 1 && read_back(run);
  if (run.is_kept) return run;
  output::refuse_foreign_files(communicator_, folder, run_files(*deck), plan_->files);
  run.chi2 = 0.0;
  RunOptions options;
  options.folder = folder;
  if (sensitivity) options.accepted = [&](const AcceptedStep& step) { (*sensitivity)(step); };
  run.failure = run_member(communicator_, name_of(*plan_, values), *deck, options, signals_);
  if (run.failure.empty() && !read_back(run)) run.failure = "its files cannot be read: " + folder;
  return run;
}

const FitRun& FitRuns::at(const std::vector<double>& values) {
  std::vector<double> tried = tidy(values);
  communicator_.broadcast(tried.data(), tried.size());
  const auto known = places_.find(tried);
  if (known != places_.end()) return runs_[known->second];
  const double before = MPI_Wtime();
  places_[tried] = runs_.size();
  runs_.push_back(make(tried));
  const FitRun& run = runs_.back();
  const std::string head = format("[%zu] %s: ", runs_.size(), name_of(*plan_, tried).c_str());
  if (!run.failure.empty())
    log_->line(head + "failed\n  " + run.failure.substr(0, run.failure.find('\n')));
  else
    log_->line(head + format("chi^2 %.8g", run.chi2) +
               (run.is_kept ? ", finished before" : format(", %.1f s", MPI_Wtime() - before)));
  log_->require_written();
  return run;
}

Eigen::MatrixXd FitRuns::derivatives(const std::vector<double>& values) {
  const FitRun here = at(values);
  if (!here.failure.empty() || plan_->has_adjoint()) return here.by_adjoint;
  Eigen::MatrixXd result(here.forces.size(), static_cast<Eigen::Index>(values.size()));
  for (std::size_t j = 0; j < values.size(); ++j) {
    const FittedParameters& one = plan_->parameters.parameters.all[j].second;
    std::vector<double> beside = here.values;
    double h = 1e-4 * (here.values[j] == 0.0 ? std::max(1.0, std::abs(one.start))
                                             : std::abs(here.values[j]));
    if (one.upper && here.values[j] + h > *one.upper) h = -h;
    beside[j] += h;
    const FitRun& there = at(beside);
    if (!there.failure.empty()) return {};
    result.col(static_cast<Eigen::Index>(j)) =
        (there.forces - here.forces) / (there.values[j] - here.values[j]);
  }
  return result;
}

std::size_t FitRuns::solved() const {
  return static_cast<std::size_t>(
      std::count_if(runs_.begin(), runs_.end(), [](const FitRun& run) { return !run.is_kept; }));
}

}  // namespace stroma
