// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The runs of a fit, each made once.

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fit/FitPlan.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Signals.hpp"

namespace stroma {

/// What a run says of the measured forces.
struct FitRun {
  std::vector<double> values;  ///< of the numbers that are looked for
  std::string folder;          ///< its name
  bool is_kept = false;        ///< it was there before
  std::string failure;         ///< why there are no forces; empty: there are
  Eigen::VectorXd forces;      ///< (point) [pN]
  Eigen::MatrixXd by_adjoint;  ///< (point, number) derivatives; empty without adjoint
  double chi2 = 0.0;           ///< sum of ((force - measured) / error)^2
};

/// Runs the base deck with numbers in place of those that are looked for, each in a folder of its
/// own, unless a finished run of that very deck is there. Member functions are collective.
class FitRuns {
 public:
  /// \param folder  where the runs' folders go
  /// \param log     gets a line on each run
  FitRuns(const base::Communicator& communicator, const FitPlan& plan, std::string folder,
          base::Log& log);

  /// Refuses what is in the way of the run of some numbers, if it has to be run: a file of the
  /// user's own, or one that the fit is read from. \throws base::InputError
  void refuse_foreign_files(const std::vector<double>& values) const;
  /// The run of some numbers, of which ten digits count.
  /// \throws base::Interrupted when a signal ends the fit
  /// \throws base::InputError as above
  const FitRun& at(const std::vector<double>& values);
  /// Derivatives of the forces there (point, number): the adjoint's, or differences by 1e-4 of a
  /// number, away from a bound. Empty where a run that this takes failed.
  Eigen::MatrixXd derivatives(const std::vector<double>& values);

  /// In the order in which they were first asked for.
  const std::vector<FitRun>& all() const { return runs_; }
  /// How many were not there before.
  std::size_t solved() const;

 private:
  FitRun make(const std::vector<double>& values);
  bool read_back(FitRun& run) const;

  base::Communicator communicator_;
  base::StopRequests signals_;
  const FitPlan* plan_;
  std::string folder_;
  base::Log* log_;
  std::map<std::vector<double>, std::size_t> places_;
  std::vector<FitRun> runs_;
};

}  // namespace stroma
