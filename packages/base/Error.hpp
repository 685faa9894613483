// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What can go wrong, by whom it is answered, and how all ranks come to agree on it.

#include <exception>
#include <functional>
#include <stdexcept>
#include <string>

#include "stroma/base/Communicator.hpp"

namespace stroma::base {

/// The user's input (deck, image, options) is wrong: nothing was run. Exit status 2. The message
/// says, in a few plain lines, where, what was found, and what is admissible.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The run failed: what was computed is on disk. Exit status 1. The message says how to go on.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The load step cannot be completed with this increment. Caught by the step control, which tries a
/// smaller one.
class StepRejected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Exit status of the program for each kind of error (0: done).
enum class ExitStatus { done = 0, run_failed = 1, wrong_input = 2 };

/// Runs work() on every rank of the communicator, then tells all ranks how it ended: when any rank
/// threw, every rank throws an exception of the same class (InputError, RunError, StepRejected;
/// anything else becomes a RunError) with the message of the lowest rank that failed. Collective.
/// work() itself must not communicate after a point where one rank alone may throw.
void collectively(const Communicator& communicator, const std::function<void()>& work);

}  // namespace stroma::base
