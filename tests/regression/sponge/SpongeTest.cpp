// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A porous body, of struts one voxel wide and elements that hold a single particle, runs by
/// default. docs/theory.md, "Barely filled elements".

#include <gtest/gtest.h>

#include <cmath>

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

/// A gyroid in a cube of 1.5 periods along an edge, 40 % solid, as signed bytes: 0 solid, -1 empty.
std::string gyroid(int voxels) {
  std::string values;
  const auto angle = [&](int i) { return 3.0 * M_PI * (i + 0.5) / voxels; };
  for (int k = 0; k < voxels; ++k)
    for (int j = 0; j < voxels; ++j)
      for (int i = 0; i < voxels; ++i) {
        const double x = angle(i) + 0.4, y = angle(j) + 1.1, z = angle(k) + 2.3;  // on no node
        const double f =
            std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
        values += f > 0.3 ? '\0' : '\xff';
      }
  const std::string n = std::to_string(voxels);
  return "NRRD0004\ntype: int8\ndimension: 3\nsizes: " + n + " " + n + " " + n +
         "\nencoding: raw\n\n" + values;
}

struct Stabilized {
  double force = 0.0, stated = 0.0;
};

Stabilized pull_gyroid(const TemporaryFolder& folder, int voxels, double stabilization) {
  folder.write("gyroid.nrrd", gyroid(voxels));
  const std::string n = std::to_string(voxels / 2);
  const Outcome outcome = run_stroma(
      folder.path(), "run deck.yaml --set 'Image|File=gyroid.nrrd' --set 'Grid|Elements=[" + n +
                         ", " + n + ", " + n +
                         "]' --set 'Grid|Stabilization=" + std::to_string(stabilization) + "'");
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
  if (outcome.status != 0) return {};
  const std::string key = "Stabilization adds ";
  const std::size_t at = outcome.standard_output.find(key);
  EXPECT_NE(at, std::string::npos) << outcome.standard_output;
  if (at == std::string::npos) return {};
  return {History(folder / "deck/history.csv")["top.reaction_z"].back(),
          std::stod(outcome.standard_output.substr(at + key.size()))};
}

TEST(Stabilization, HasTheEffectThatTheRunStatesAndLessOnFinerGrids) {  // V-STAB-3
  const TemporaryFolder folder;
  fs::copy(fs::path(STROMA_SOURCE_DIR) / "tests/data/cases/sponge/deck.yaml", folder.path());
  double coarser = 1e-3;
  for (const int voxels : {24, 48}) {
    const Stabilized half = pull_gyroid(folder, voxels, 1e-5);
    const Stabilized whole = pull_gyroid(folder, voxels, 2e-5);
    const double measured = 2.0 * (whole.force / half.force - 1.0);
    EXPECT_NEAR(measured, whole.stated, 0.1 * whole.stated);  // two digits are stated
    EXPECT_LT(measured, 0.6 * coarser);
    coarser = measured;
    RecordProperty("effect" + std::to_string(voxels), std::to_string(measured));
  }
}

}  // namespace
}  // namespace stroma::test
