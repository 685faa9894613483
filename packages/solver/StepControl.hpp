// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The size of load steps.

#include "stroma/solver/SolverParameters.hpp"

namespace stroma::solver {

/// How far a load has come.
struct LoadProgress {
  double load = 0.0;
  double size = 0.0;  ///< of the next step; 0: a whole one of the deck
  int accepted = 0;   ///< steps
};

/// Hands out load factors from 0 to 1. A rejected step is halved; accepted ones let it double
/// again, up to a whole step of the deck. Ends of the deck's steps (multiples of 1 / Steps, or
/// Times) are never stepped over, so that results exist there whatever was rejected on the way.
class StepControl {
 public:
  explicit StepControl(const LoadingParameters& parameters, const LoadProgress& progress = {});

  const LoadProgress& progress() const { return now_; }
  double load() const { return now_.load; }
  bool finished() const { return now_.load >= 1.0; }
  /// The load factor to try.
  double next() const;
  /// The step to next() has converged.
  /// \param time_error  of it, which Step Error [um] bounds [um]
  void accept(double time_error = 0.0);
  /// Whether a step with this error is to be rejected.
  bool is_too_long(double time_error) const {
    return parameters_.step_error && time_error > *parameters_.step_error;
  }
  /// The step to next() has failed: halves it.
  /// \return false when the half would be below the smallest step
  bool reject();
  /// Steps accepted so far.
  int accepted() const { return now_.accepted; }
  /// Steps to come, if none of them is rejected.
  int remaining() const;

 private:
  /// The deck's step that a load factor lies in: its end, and its length.
  struct Step {
    double end, length;
  };
  Step step_at(double load) const;

  LoadingParameters parameters_;
  LoadProgress now_;
};

}  // namespace stroma::solver
