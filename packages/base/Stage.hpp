// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Where the time of a run goes.

#include <Teuchos_RCP.hpp>
#include <string>
#include <utility>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace Teuchos {
class TimeMonitor;
}

namespace stroma::base {

/// Counts the time from its construction to its destruction to a named stage of the run, in
/// Teuchos' timers, where other tools find it too.
class Stage {
 public:
  explicit Stage(const std::string& name);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

 private:
  Teuchos::RCP<Teuchos::TimeMonitor> monitor_;
};

/// Seconds of each stage so far, of the rank that spent most in it, in order of first use.
/// Collective; every rank must have been in the same stages.
std::vector<std::pair<std::string, double>> stage_seconds(const Communicator& communicator);

}  // namespace stroma::base
