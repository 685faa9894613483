// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a run says while it goes on.

#include <string>

#include "run/Specimen.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/mechanics/MovingBody.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/solver/NewtonSolver.hpp"
#include "stroma/solver/StepControl.hpp"

namespace stroma {

/// The lines and notes of one run's log, its line of progress, which goes with it, and its clock,
/// which starts with it.
class RunLog {
 public:
  RunLog(const base::Communicator& communicator, const Deck& deck, base::Log& log);
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;
  ~RunLog() { log_->progress(""); }

  /// Wall time since the run began [s], that of the runs included which it goes on from.
  double seconds() const;

  /// The run goes on after this step, and its clock with it.
  void go_on(const output::HistoryRow& row);
  /// Specimen, grid and particles, and what should be known of them. Collective.
  void describe(const Specimen& specimen, const mechanics::MomentumBalance& balance);
  /// The step to load.next() begins.
  void begin_step(const solver::StepControl& load);
  void newton(int iteration, double residual, long long linear_iterations);
  /// Says so when the body came apart, or together, with the grid's reset.
  void compare_pieces(const mechanics::PiecesSummary& before, const mechanics::Supports& now,
                      double load);
  /// Says once that elements have become barely filled with the grid's reset. Collective.
  void filling(const mechanics::MomentumBalance& balance, double load);
  /// An accepted step, and, once each, what a converged one leaves to be said.
  void accepted(const solver::StepControl& load, const solver::NewtonResult& solved);
  /// Says once where the body, as it is after the accepted step of a row, has lost ellipticity.
  /// Collective.
  void localization(const mechanics::MovingBody& body, const output::HistoryRow& row);
  /// Says, where a row ends a run in which nothing strained the body, that its stresses are none.
  void rest(const output::HistoryRow& row, bool is_last);
  void rejected(double load, const std::string& reason);
  /// What Grid|Stabilization adds to the body, where it does. Collective.
  void stabilization(const mechanics::MovingBody& body);

 private:
  void show_progress(const std::string& state);

  base::Communicator communicator_;
  const Deck* deck_;
  base::Log* log_;
  double start_;
  std::string step_ = {};      ///< that is being solved, as the line of progress has it
  double full_load_at_ = 0.0;  ///< seconds() by the steps so far; 0: none yet
  bool has_told_of_holds_ = false, has_told_of_localization_ = false, has_told_of_filling_ = false;
  double most_energy_ = 0.0;       ///< of strain, in the steps so far [aJ]
  double told_of_rounding_ = 0.0;  ///< the largest residual of which it was said
};

/// Why the step from one load to the next failed at the smallest size, where, and how to go on.
/// Collective.
/// \param trial  its last iterate
std::string failure(const Deck& deck, const mechanics::MomentumBalance& balance,
                    const grid::Vector& trial, const solver::StepControl& load,
                    const std::string& reason, const std::string& folder);

}  // namespace stroma
