/// \file
/// A porous body, of struts one voxel wide and elements that hold a single particle, runs by
/// default. docs/theory.md, "Barely filled elements".

#include <gtest/gtest.h>

#include "support/Program.hpp"

namespace stroma::test {
namespace {

constexpr double direct_force = 6.02918e11;  // by Direct, without stabilisation, in 5 steps [pN]

struct SpongeRun {
  Outcome outcome;
  double force = 0.0;
};

SpongeRun run(const std::string& settings, int ranks) {
  const TemporaryFolder folder;
  fs::copy(fs::path(STROMA_SOURCE_DIR) / "tests/data/cases/sponge", folder.path(),
           fs::copy_options::recursive);
  SpongeRun result{run_stroma(folder.path(), "run deck.yaml " + settings, ranks)};
  if (result.outcome.status != 0) return result;
  result.force = History(folder / "deck/history.csv")["top.reaction_z"].back();
  return result;
}

/// The most linear iterations of one solve that a log tells of.
long long largest_solve(const std::string& log) {
  long long largest = 0, before = 0;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t end = line.find(" linear iterations");
    if (end == std::string::npos) continue;
    const std::size_t begin = line.find_last_of(' ', end - 1) + 1;
    const long long sum = std::stoll(line.substr(begin, end - begin));
    largest = std::max(largest, sum - before);
    before = sum;
  }
  return largest;
}

class Sponge : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Ranks, Sponge, ::testing::Values(1, 2));

TEST_P(Sponge, RunsByDefault) {
  const SpongeRun sponge = run("", GetParam());
  const std::string& log = sponge.outcome.standard_output;
  ASSERT_EQ(sponge.outcome.status, 0) << sponge.outcome.standard_error;
  EXPECT_NEAR(sponge.force, direct_force, 1e-3 * direct_force);
  EXPECT_EQ(log.find("rejected"), std::string::npos) << log;
  EXPECT_NE(log.find("are filled by less than half"), std::string::npos) << log;
  EXPECT_NE(log.find("to the stiffness of the body"), std::string::npos) << log;
  const long long most = largest_solve(log);
  EXPECT_GT(most, 0);
  EXPECT_LE(most, 40);
}

}  // namespace
}  // namespace stroma::test
