// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What ends a run before its load is whole.

#include <optional>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Signals.hpp"

namespace stroma {

/// Ends a run where a signal or a time limit asks for it. Member functions are collective.
class StopRequest {
 public:
  /// \param communicator  of the run
  /// \param time_limit    from now on [s]
  StopRequest(const base::Communicator& communicator, std::optional<double> time_limit);

  /// An accepted step took so long [s], and a checkpoint so long.
  void learn(double step, double checkpoint);
  /// \param is_between_steps  whether the next step should fit in as well
  /// \throws base::Interrupted  with who asked: "SIGTERM"
  void obey(bool is_between_steps) const;

 private:
  base::Communicator communicator_;
  base::StopRequests signals_;
  std::optional<double> time_limit_;
  double start_, step_ = 0.0, checkpoint_ = 0.0;
};

}  // namespace stroma
