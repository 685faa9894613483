// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// SIGTERM and SIGINT end a run after what is being written, with a line that says what is on disk.

#include <gtest/gtest.h>

#include "support/SmallDeck.hpp"

namespace stroma::test {
namespace {

class Signals : public ::testing::TestWithParam<std::pair<const char*, int>> {};

// V-SIGNALS.
// The signal comes with the third row of the table; on two ranks to one of them, whose lock names it, for
// mpirun kills its ranks a second after it has passed a signal on, and a busy machine may take longer.
TEST_P(Signals, EndTheRunWithWhatIsOnDisk) {
  const auto [signal, ranks] = GetParam();
  const TemporaryFolder folder;
  folder.write("gel.yaml", small_deck());
  const std::string start = ranks == 1 ? "\"$stroma\"" : "$mpirun -np 2 \"$stroma\"";
  const std::string to = ranks == 1 ? " $run" : " $(cut -d ' ' -f 2 out/.stroma_lock)";
  const Outcome outcome = run_script(folder, "set -m\n" + start + " run gel.yaml -o out --quiet" +
                                                 endless + R"( >output 2>errors &
run=$!
wait_for_steps out/history.csv
kill -)" + signal + to + R"(
wait $run
echo status $?
)");
  EXPECT_EQ(outcome.standard_output, "status 1\n") << content_of(folder / "errors");
  const std::string errors = content_of(folder / "errors");
  const std::string line = "stopped by SIG";
  EXPECT_NE(errors.find("stroma: " + line), std::string::npos) << errors;
  EXPECT_EQ(errors.find(line), errors.rfind(line)) << "told twice: " << errors;
  EXPECT_EQ(errors.find("MPI_ABORT"), std::string::npos) << errors;
  const std::string log = content_of(folder / "out/log.txt");
  const History history(folder / "out/history.csv");
  const std::string told =
      "on disk in out: history.csv to step " + std::to_string(history.rows() - 1) + " (load ";
  EXPECT_NE(log.find(told), std::string::npos) << log.substr(log.size() - 300);
  EXPECT_FALSE(fs::exists(folder / "out/.stroma_lock"));
  // The folder is free for the next run.
  EXPECT_EQ(run_stroma(folder.path(), "run gel.yaml -o out --quiet").status, 0);
}

INSTANTIATE_TEST_SUITE_P(All, Signals,
                         ::testing::Values(std::pair{"TERM", 1}, std::pair{"INT", 1},
                                           std::pair{"TERM", 2}, std::pair{"INT", 2}),
                         [](const auto& p) {
                           return std::string(p.param.first) + "_np" +
                                  std::to_string(p.param.second);
                         });

TEST(Signals, EndAStudyWithItsMember) {
  const TemporaryFolder folder;
  folder.write("base.yaml", small_deck() + "    Smallest Step: 1.0e-9\n");
  folder.write("study.yaml", R"(Study:
  Base Deck: base.yaml
  Vary:
    Loading|Steps: [900000, 900001]
)");
  const Outcome outcome = run_script(folder, R"(set -m
"$stroma" study study.yaml -o out >output 2>errors &
run=$!
wait_for_steps out/Steps_900000/history.csv
kill -TERM $run
wait $run
echo status $?
)");
  EXPECT_EQ(outcome.standard_output, "status 1\n") << content_of(folder / "errors");
  EXPECT_FALSE(fs::exists(folder / "out/Steps_900001"));
  EXPECT_NE(content_of(folder / "errors").find("give the same command again"), std::string::npos);
}

}  // namespace
}  // namespace stroma::test
