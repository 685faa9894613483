// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Signals that ask for a stop.

#include <gtest/gtest.h>

#include <csignal>

#include "stroma/base/Signals.hpp"

namespace stroma::base {
namespace {

/// A family of runs sees what came in the last moments of one of them; the next family does not.
TEST(StopRequests, OfAFamilySeeWhatCameInARun) {
  const auto communicator = Communicator::world();
  {
    const StopRequests family;
    {
      const StopRequests run;
      EXPECT_EQ(run.asked(communicator), "");
      std::raise(SIGTERM);
      EXPECT_EQ(run.asked(communicator), "SIGTERM");
    }
    EXPECT_EQ(family.asked(communicator), "SIGTERM");
  }
  const StopRequests next;
  EXPECT_EQ(next.asked(communicator), "");
}

}  // namespace
}  // namespace stroma::base
