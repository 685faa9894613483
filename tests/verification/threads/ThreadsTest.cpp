// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// 1, 2 and 3 threads: the same bits from every kernel, and the same history of a run. Claim
/// V-THREADS, docs/verification.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "support/Places.hpp"
#include "support/VesselBlock.hpp"

namespace stroma::test {
namespace {

/// The lines that Fingerprint.cpp prints, without the first, which says how many threads it had.
std::string fingerprint(int ranks, int threads) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(FINGERPRINT, folder.path(), "", ranks, threads);
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
  const std::string first = "threads " + std::to_string(threads) + "\n";
  EXPECT_EQ(outcome.standard_output.rfind(first, 0), 0u) << outcome.standard_output;
  return outcome.standard_output.substr(std::min(first.size(), outcome.standard_output.size()));
}

TEST(Threads, LeaveEveryBitOfTheKernels) {
  for (const int ranks : {1, 2}) {
    const std::string one = fingerprint(ranks, 1);
    // 3 bodies, 2 displacements, 11 quantities, and 3 more where the grid is reset.
    EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), ranks * 2 * (3 * 11 + 3));
    for (const int threads : {2, 3})
      EXPECT_EQ(fingerprint(ranks, threads), one) << ranks << " ranks, " << threads << " threads";
  }
}

const std::string deck = vessel_block("20, 24, 16") + clamped_stretch() + R"(  Loading:
    Steps: 3
  Solver:
    Newton Tolerance: 1.0e-10
  Output:
    Pictures: false
    Particles Every: 0
    Grid Every: 0
)";

class ThreadsHistory : public ::testing::TestWithParam<const char*> {};

// V-THREADS-2.
// The kernels give the same bits, but sums over all unknowns (dots, norms) are taken in parts of
// which there are as many as threads: conjugate gradients differ by rounding.
TEST_P(ThreadsHistory, IsTheSame) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("block.yaml", deck);
  std::vector<History> histories;
  for (const int threads : {1, 2}) {
    const std::string out = "out" + std::to_string(threads);
    const Outcome outcome =
        run_program(stroma_program(), folder.path(),
                    "run " + quoted(path) + " -o " + out + " " + GetParam(), 1, threads);
    ASSERT_EQ(outcome.status, 0) << threads << " threads: " << outcome.standard_error;
    const std::string expected = threads == 1 ? "on 1 rank\n" : "on 1 rank of 2 threads\n";
    EXPECT_NE(outcome.standard_output.find(expected), std::string::npos) << outcome.standard_output;
    EXPECT_EQ(outcome.standard_error, "");  // Kokkos' advice on OMP_PROC_BIND among others
    histories.emplace_back(folder.path() / out / "history.csv");
    ASSERT_EQ(histories.back().rows(), 4u);
  }
  const History &one = histories[0], &two = histories[1];
  ASSERT_EQ(two.names(), one.names());
  double worst = 0.0;
  for (const std::string& name : one.names()) {
    if (name == "wall_seconds" || name == "residual") continue;
    for (std::size_t s = 0; s < 4; ++s) {
      if (name == "linear_iterations") {
        EXPECT_NEAR(two[name][s], one[name][s], 1) << "step " << s;
        continue;
      }
      // Reactions are compared with the largest of the step.
      double size = std::abs(one[name][s]);
      if (name.find(".reaction_") != std::string::npos) size = std::abs(one["top.reaction_y"][s]);
      const double difference = std::abs(two[name][s] - one[name][s]);
      if (difference == 0.0) continue;
      EXPECT_LE(difference, 1e-12 * size) << name << ", step " << s;
      worst = std::max(worst, difference / size);
    }
  }
  std::printf("  %s: within %.1e\n", GetParam(), worst);
}

INSTANTIATE_TEST_SUITE_P(Decks, ThreadsHistory,
                         ::testing::Values("--set 'Solver|Preconditioner=Jacobi'",
                                           "--set 'Solver|Preconditioner=Multigrid'", "",
                                           "--set 'Grid|Reset=true'"));

/// "on 1 rank of N threads" in what `stroma run` says; 1 where it says nothing of threads.
int threads_told(const std::string& output) {
  const std::size_t place = output.find("on 1 rank");
  if (place == std::string::npos) return 0;
  int threads = 1;
  std::sscanf(output.c_str() + place, "on 1 rank of %d threads", &threads);
  return threads;
}

// V-THREADS-3.
TEST(ThreadNumber, IsWhatIsAskedFor) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("block.yaml", deck);
  const std::string run = "run " + quoted(path) + " --set 'Loading|Steps=1'";
  const auto told = [&](const std::string& words, int environment) {
    const Outcome outcome =
        run_program(stroma_program(), folder.path(), run + words, 1, environment);
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    return threads_told(outcome.standard_output);
  };
  EXPECT_EQ(told("", 2), 2);
  EXPECT_EQ(told(" --kokkos-num-threads=2", 0), 2);
  EXPECT_EQ(told(" --kokkos-threads=3", 1), 3);
  EXPECT_EQ(told(" --kokkos-num-threads=1", 2), 1);
}

TEST(ThreadNumber, IsRefusedWhenItIsNone) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("block.yaml", deck);
  for (const char* word :
       {"--kokkos-num-threads=two", "--kokkos-threads=0", "--kokkos-num-threads"}) {
    const Outcome outcome = run_stroma(folder.path(), "check " + quoted(path) + " " + word);
    EXPECT_EQ(outcome.status, 2) << word;
    EXPECT_NE(outcome.standard_error.find("N threads from 1 to"), std::string::npos)
        << outcome.standard_error;
  }
}

// Told nothing, several ranks share the processors of a machine and do not each take all.
TEST(ThreadNumber, IsAnEqualShareOfTheProcessors) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("block.yaml", deck);
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  for (const int ranks : {1, 2}) {
    const Outcome outcome =
        run_program(stroma_program(), folder.path(),
                    "run " + quoted(path) + " --set 'Loading|Steps=1'", ranks, 0);
    ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
    const int threads = std::max(1, processors / ranks);
    const std::string expected =
        "on " + std::to_string(ranks) + (ranks == 1 ? " rank" : " ranks") +
        (threads > 1 ? " of " + std::to_string(threads) + " threads" : "") + "\n";
    EXPECT_NE(outcome.standard_output.find(expected), std::string::npos) << outcome.standard_output;
    EXPECT_EQ(outcome.standard_output.find("share"), std::string::npos) << outcome.standard_output;
  }
}

// One says so when threads outnumber the processors.
TEST(ThreadNumber, TooManyAreNoted) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("block.yaml", deck);
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  const Outcome outcome =
      run_program(stroma_program(), folder.path(),
                  "run " + quoted(path) + " --set 'Loading|Steps=1'", 1, processors + 1);
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
  EXPECT_NE(outcome.standard_output.find("fewer threads (OMP_NUM_THREADS)"), std::string::npos)
      << outcome.standard_output;
}

}  // namespace
}  // namespace stroma::test
