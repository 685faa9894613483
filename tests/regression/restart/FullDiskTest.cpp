// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A disk that takes no more: exit status 1, readable files, and the run goes on once there is room.

#include <gtest/gtest.h>

#include "regression/restart/LongDeck.hpp"
#include "support/ExodusReader.hpp"
#include "support/SmallDeck.hpp"

namespace stroma::test {
namespace {

// V-RESTART-5. Files of no more than so many KiB, in several sizes, whoever runs the test.
TEST(FullDisk, LosesNothing) {
  const TemporaryFolder folder;
  const History whole = run_deck(folder, "whole", long_deck("", 4));
  folder.write("gel.yaml", long_deck("", 4));
  for (const int limit : {20, 60, 120, 200, 300, 400, 500, 600, 700, 800}) {
    fs::remove_all(folder / "gel");
    const Outcome outcome = run_script(folder, "ulimit -f " + std::to_string(limit) +
                                                   "\n\"$stroma\" run gel.yaml --quiet; echo $?");
    const std::string& said = outcome.standard_error;
    ASSERT_EQ(outcome.standard_output, "1\n") << limit << said;
    EXPECT_NE(said.find("File too large"), std::string::npos) << said;
    const bool has_checkpoint = fs::exists(folder / "gel/checkpoint.h5");
    EXPECT_NE(said.find(has_checkpoint ? "to go on: " : "to begin anew: "), std::string::npos)
        << said;
    if (fs::exists(folder / "gel/history.csv")) {
      const std::size_t rows = History(folder / "gel/history.csv").rows();
      if (has_checkpoint) {  // nothing that was accepted is lost
        const std::string told = "checkpoint.h5 of step " + std::to_string(rows - 1);
        EXPECT_NE(said.find(told), std::string::npos) << said;
        EXPECT_LE(ExodusReader(folder / "gel/particles.e").steps(), static_cast<int>(rows));
      }
    }
    const Outcome again = run_stroma(
        folder.path(), std::string("run gel.yaml --quiet") + (has_checkpoint ? " --restart" : ""));
    ASSERT_EQ(again.status, 0) << limit << again.standard_error;
    EXPECT_LT(difference(whole, History(folder / "gel/history.csv")), 1e-12) << limit;
    EXPECT_EQ(ExodusReader(folder / "gel/particles.e").steps(), 5) << limit;
    EXPECT_EQ(ExodusReader(folder / "gel/grid.e").steps(), 5) << limit;
  }
}

TEST(FullDisk, AFolderThatIsGoneIsTold) {
  const TemporaryFolder folder;
  folder.write("gel.yaml", small_deck());
  const Outcome outcome = run_script(folder, "\"$stroma\" run gel.yaml -o out --quiet" + endless +
                                                 R"( 2>errors &
run=$!
wait_for_steps out/history.csv
mv out elsewhere
wait $run
echo status $?
)");
  EXPECT_EQ(outcome.standard_output, "status 1\n");
  const std::string errors = content_of(folder / "errors");
  EXPECT_NE(errors.find("No such file or directory"), std::string::npos) << errors;
  EXPECT_NE(errors.find("the folder out is not there any more"), std::string::npos) << errors;
}

}  // namespace
}  // namespace stroma::test
