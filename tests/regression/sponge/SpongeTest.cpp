// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A porous body, of struts one voxel wide and elements that hold a single particle, runs by
/// default. docs/theory.md, "Barely filled elements".

#include <gtest/gtest.h>

#include <cmath>

#include "support/Places.hpp"
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
  fs::copy(clone_folder() / "tests/data/cases/sponge", folder.path(), fs::copy_options::recursive);
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

/// What stabilisation adds, as a log has it; not a number where it does not say.
double stated_share(const std::string& log) {
  const std::string key = "Stabilization adds ";
  const std::size_t at = log.find(key);
  EXPECT_NE(at, std::string::npos) << log;
  return at == std::string::npos ? NAN : std::stod(log.substr(at + key.size()));
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

/// Settings for another sponge of the folder, of so many voxels along an edge.
std::string sponge_of(const std::string& file, int voxels) {
  const std::string n = std::to_string(voxels / 2);
  return "--set 'Image|File=" + file + "' --set 'Grid|Elements=[" + n + ", " + n + ", " + n + "]'";
}

/// Struts that hang together by hinges, which 2e-5 stiffens by 2.2e-3.
TEST_P(Sponge, IsStabilisedLessWhereThatWouldShow) {  // V-STAB-4
  constexpr double direct = 1.389447665e11;  // by Direct, without stabilisation, in 13 steps [pN]
  const SpongeRun sponge = run(sponge_of("hinges.nrrd", 24), GetParam());
  const std::string& log = sponge.outcome.standard_output;
  ASSERT_EQ(sponge.outcome.status, 0) << sponge.outcome.standard_error;
  EXPECT_NEAR(sponge.force, direct, 1e-3 * direct);
  EXPECT_NE(log.find("2e-05 would add 1.5e-03 to the stiffness"), std::string::npos) << log;
  EXPECT_NE(log.find("Grid|Stabilization is 4e-06 now"), std::string::npos) << log;
  RecordProperty("departure", std::to_string(sponge.force / direct - 1.0));
}

/// A corner that buckles in the first step with 2e-5.
TEST_P(Sponge, IsStabilisedMoreWhereTheFirstStepFails) {  // V-STAB-5
  const SpongeRun sponge = run(sponge_of("corners.nrrd", 40), GetParam());
  const std::string& log = sponge.outcome.standard_output;
  ASSERT_EQ(sponge.outcome.status, 0) << sponge.outcome.standard_error;
  EXPECT_NE(log.find("Grid|Stabilization is 4e-05 now"), std::string::npos) << log;
  EXPECT_EQ(log.find(" rejected"), log.rfind(" rejected")) << log;
  EXPECT_NE(log.find("step   1   load 1.0000"), std::string::npos) << log;
  EXPECT_LE(largest_solve(log), 40);
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
  return {History(folder / "deck/history.csv")["top.reaction_z"].back(),
          stated_share(outcome.standard_output)};
}

TEST(Stabilization, HasTheEffectThatTheRunStatesAndLessOnFinerGrids) {  // V-STAB-3
  const TemporaryFolder folder;
  fs::copy(clone_folder() / "tests/data/cases/sponge/deck.yaml", folder.path());
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

/// The share is that of a body with all its stresses: driven ones, and those that it remembers.
TEST(Stabilization, IsStatedForBodiesThatContractOrRelax) {  // V-STAB-3
  for (const char* settings :
       {"--set 'Materials|bone|Active Stress|T0 [Pa]=1000000' "
        "--set 'Materials|bone|Active Stress|Kind=Isotropic'",
        "--set 'Materials|bone|Viscosity|Moduli=[0.9]' --set 'Loading|Duration [s]=1' "
        "--set 'Materials|bone|Viscosity|Relaxation Times [s]=[0.05]'"}) {
    const SpongeRun sponge = run(settings, 1);
    ASSERT_EQ(sponge.outcome.status, 0) << sponge.outcome.standard_error;
    EXPECT_NEAR(stated_share(sponge.outcome.standard_output), 1.2e-4, 3e-5) << settings;
  }
}

/// Runs the sponge with hinges to some of two seconds.
History pull_slowly(const TemporaryFolder& folder, const std::string& name,
                    const std::string& times, const std::string& options = "") {
  const std::string deck = content_of(folder / "deck.yaml");
  folder.write(name + ".yaml", deck.substr(0, deck.find("  Loading")) + R"(      Load Curve: pull
  Load Curves:
    pull: {"Times [s]": [0, 2], Values: [0, 1]}
  Loading: {"Times [s]": )" + times +
                                   "}\n");
  const Outcome outcome = run_stroma(
      folder.path(), "run " + name + ".yaml -o " + name + " " + sponge_of("hinges.nrrd", 24) +
                         " --set 'Output|Checkpoint Every=1' " + options);
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
  return History(folder / (name + "/history.csv"));
}

TEST(Stabilization, StaysWhatItIsWhenARunGoesOn) {  // V-STAB-6
  const TemporaryFolder folder;
  fs::copy(clone_folder() / "tests/data/cases/sponge", folder.path(), fs::copy_options::recursive);
  const History whole = pull_slowly(folder, "whole", "[1.0, 2.0]");
  pull_slowly(folder, "part", "[1.0]");
  const History both = pull_slowly(folder, "part", "[1.0, 2.0]", "--restart");
  ASSERT_EQ(both.rows(), 3U);
  EXPECT_EQ(both["top.reaction_z"], whole["top.reaction_z"]);
}

}  // namespace
}  // namespace stroma::test
