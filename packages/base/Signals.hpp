// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What signals do to a run.

#include <csignal>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Error.hpp"

namespace stroma::base {

/// A signal, or a time limit, asked for the end of the run: what was computed is on disk. Exit status 1.
class Interrupted : public RunError {
 public:
  using RunError::RunError;
};

/// A write to a file that has reached its limit (SIGXFSZ) or to a pipe that nobody reads (SIGPIPE)
/// fails with an error from now on, instead of ending the process.
void let_writes_fail();

/// While it lives, SIGTERM, SIGINT and SIGUSR1 (by which batch systems warn) ask for a stop instead of ending the process; a second SIGINT
/// ends it. Of several, as a family of runs has one around that of each run, all see the signal.
class StopRequests {
 public:
  StopRequests();
  ~StopRequests();
  StopRequests(const StopRequests&) = delete;
  StopRequests& operator=(const StopRequests&) = delete;

  /// The signal that any rank got, "SIGTERM", "SIGINT" or "SIGUSR1"; empty when there was none. Collective.
  std::string asked(const Communicator& communicator) const;

 private:
  struct sigaction term_before_ {};
  struct sigaction int_before_ {};
  struct sigaction usr1_before_ {};
};

}  // namespace stroma::base
