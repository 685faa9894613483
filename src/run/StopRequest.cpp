// SPDX-License-Identifier: BSD-3-Clause

#include "run/StopRequest.hpp"

#include <mpi.h>

#include <algorithm>

namespace stroma {

StopRequest::StopRequest(const base::Communicator& communicator, std::optional<double> time_limit)
    : communicator_(communicator), time_limit_(time_limit), start_(MPI_Wtime()) {}

void StopRequest::learn(double step, double checkpoint) {
  step_ = std::max(step_, step);
  checkpoint_ = std::max(checkpoint_, checkpoint);
}

/// A twentieth of the limit, but no more than half a minute, is kept for the end, and twice what a
/// checkpoint took.
void StopRequest::obey(bool is_between_steps) const {
  const std::string signal = signals_.asked(communicator_);
  if (!signal.empty()) throw base::Interrupted(signal);
  if (!time_limit_) return;
  const double kept = std::min(0.05 * *time_limit_, 30.0) + 2.0 * checkpoint_;
  const double next = is_between_steps ? step_ : 0.0;
  if (communicator_.any(MPI_Wtime() - start_ + next > *time_limit_ - kept))
    throw base::Interrupted("--time-limit");
}

}  // namespace stroma
