// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A line that does not reach its file is an error on every rank, and not before all can answer it.

#include <gtest/gtest.h>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {
namespace {

// V-SIGNALS.
TEST(Log, AFullDeviceIsARunErrorOnEveryRank) {
  const auto world = base::Communicator::world();
  base::Log log(world, true);
  log.line("before the file");
  log.open_file("/dev/full");
  log.line("lost");
  try {
    log.require_written();
    ADD_FAILURE() << "no error";
  } catch (const base::RunError& error) {
    EXPECT_STREQ(error.what(), "cannot write the log file '/dev/full': No space left on device");
  }
  EXPECT_THROW(log.finish(), base::RunError);
}

TEST(Log, WithoutLossThereIsNoError) {
  base::Log log(base::Communicator::world(), true);
  log.line("nowhere");
  EXPECT_NO_THROW(log.require_written());
  EXPECT_NO_THROW(log.finish());
}

}  // namespace
}  // namespace stroma
