// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What cannot be written is an error, not a loss: full devices, files at their limit, pipes that
/// nobody reads.

#include <gtest/gtest.h>

#include "support/SmallDeck.hpp"

namespace stroma::test {
namespace {

// V-SIGNALS.
TEST(FailedWrites, AFullStandardOutputIsAnError) {
  const TemporaryFolder folder;
  folder.write("gel.yaml", small_deck());
  const Outcome outcome = run_script(folder, R"(
"$stroma" phantom -o a.tif --size 32,32,8 >/dev/full; echo $?
for words in "check gel.yaml" "image a.tif" reference --help; do
  "$stroma" $words >/dev/full; echo $?
done
"$stroma" run gel.yaml --set Output\|Pictures=false >/dev/full; echo $?
)");
  EXPECT_EQ(outcome.standard_output, "1\n1\n1\n1\n1\n1\n") << outcome.standard_error;
  EXPECT_NE(outcome.standard_error.find("cannot write to standard output: No space left on device"),
            std::string::npos)
      << outcome.standard_error;
  // The run came to its end all the same, and its log has what the screen has not.
  EXPECT_EQ(History(folder / "gel/history.csv").rows(), 3U);
  EXPECT_NE(content_of(folder / "gel/log.txt").find("results in gel"), std::string::npos);
  EXPECT_NE(outcome.standard_error.find("all of it is in 'gel/log.txt'"), std::string::npos);
}

TEST(FailedWrites, ABrokenPipeDoesNotEndARun) {
  const TemporaryFolder folder;
  folder.write("gel.yaml", small_deck());
  const Outcome outcome = run_script(folder, R"(
("$stroma" run gel.yaml --set Output\|Pictures=false; echo $? >status) | true
cat status
)");
  EXPECT_EQ(outcome.standard_output, "0\n") << outcome.standard_error;
  EXPECT_NE(content_of(folder / "gel/log.txt").find("results in gel"), std::string::npos);
}

// Files of more than so many KiB fail, whoever runs the test.
TEST(FailedWrites, AFileAtItsLimitIsAnErrorAndNotASignal) {
  const TemporaryFolder folder;
  folder.write("gel.yaml", small_deck());
  const Outcome outcome =
      run_script(folder, "ulimit -f 20\n\"$stroma\" run gel.yaml --quiet; echo $?");
  EXPECT_EQ(outcome.standard_output, "1\n") << outcome.standard_error;
  EXPECT_NE(outcome.standard_error.find("File too large"), std::string::npos)
      << outcome.standard_error;
  // What such a run left is known for its own, finished or not.
  EXPECT_EQ(run_stroma(folder.path(), "run gel.yaml --quiet").status, 0);
}

TEST(FailedWrites, APhantomIsWholeOrNotThere) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_script(folder, "ulimit -f 20\n\"$stroma\" phantom -o a.tif --size 64,64,20; echo $?");
  EXPECT_EQ(outcome.standard_output, "1\n") << outcome.standard_error;
  EXPECT_FALSE(fs::exists(folder / "a.tif"));
  fs::remove(folder / "script.sh");
  EXPECT_TRUE(fs::is_empty(folder.path())) << "a part of it was left";
}

}  // namespace
}  // namespace stroma::test
