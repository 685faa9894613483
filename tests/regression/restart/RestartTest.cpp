// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A run that goes on from a checkpoint comes to where an undisturbed one comes, on any number of
/// ranks; its files are continued.

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <tuple>

#include "regression/restart/LongDeck.hpp"
#include "stroma/output/files/ExodusFile.hpp"
#include "support/ExodusReader.hpp"
#include "support/SmallDeck.hpp"

namespace stroma::test {
namespace {

const char* const bare = "";
const char* const reset = ", Reset: true, Shape Functions: GIMP";
const char* const splines = ", Reset: true, Shape Functions: Quadratic B-Spline";

/// (number in the whole) a variable at a step, from the files of all ranks.
std::map<std::int64_t, double> field(const std::string& path, int ranks, int step,
                                     ex_entity_type type, const std::string& name) {
  std::map<std::int64_t, double> values;
  for (int r = 0; r < ranks; ++r) {
    const ExodusReader reader(output::spread_file_name(path, ranks, r));
    const auto ids = reader.numbers(type == EX_NODAL ? EX_NODE_MAP : EX_ELEM_MAP);
    std::size_t next = 0;
    const auto blocks = type == EX_NODAL ? 1 : reader.counts.num_elem_blk;
    for (std::int64_t b = 1; b <= blocks; ++b) {
      const std::int64_t count =
          type == EX_NODAL ? reader.counts.num_nodes : reader.block(b).elements;
      for (const double value : reader.variable(step, type, name, b, count))
        values[ids[next++]] = value;
    }
  }
  return values;
}

/// Expects five steps in both sets of files, with the same values wherever something has a number, and
/// no file of the first steps beside those of the second number of ranks.
void expect_same_fields(const std::string& one, int ranks, const std::string& other,
                        int other_ranks, ex_entity_type type,
                        const std::vector<std::string>& names) {
  if (ranks != other_ranks) {
    EXPECT_FALSE(fs::exists(output::spread_file_name(other, ranks, 0)));
  }
  const ExodusReader reader(output::spread_file_name(other, other_ranks, 0));
  ASSERT_EQ(reader.steps(), 5);
  for (int step = 1; step <= 5; ++step) {
    EXPECT_EQ(reader.time(step), step - 1.0);
    for (const std::string& name : names) {
      const auto a = field(one, ranks, step, type, name);
      const auto b = field(other, other_ranks, step, type, name);
      ASSERT_EQ(a.size(), b.size());
      double apart = 0.0, size = 0.0;
      for (const auto& [number, value] : a) {
        size = std::max(size, std::fabs(value));
        apart = std::max(apart, std::fabs(value - b.at(number)));
      }
      EXPECT_LE(apart, 1e-9 * size) << name << " of step " << step;
    }
  }
}

class Restart : public ::testing::TestWithParam<std::tuple<const char*, int, int>> {};

// V-RESTART-1.
TEST_P(Restart, ComesToWhereAnUndisturbedRunComes) {
  const auto [grid, before, after] = GetParam();
  const TemporaryFolder folder;
  const History whole = run_deck(folder, "whole", long_deck(grid, 4), before);
  run_deck(folder, "part", long_deck(grid, 2), before);
  folder.write("part.yaml", long_deck(grid, 4));
  const Outcome outcome =
      run_stroma(folder.path(), "run part.yaml -o part --quiet --restart", after);
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  const History both(folder / "part/history.csv");
  EXPECT_EQ(both.rows(), 5U);
  EXPECT_LT(difference(whole, both), 1e-10);
  if (before == after && grid == bare) {
    EXPECT_EQ(difference(whole, both), 0.0);
  }

  const std::string log = content_of(folder / "part/log.txt");
  EXPECT_NE(log.find("results in part"), log.rfind("results in part"))
      << "the log is not continued";
  EXPECT_NE(log.find("goes on    after step 2"), std::string::npos) << log;
  expect_same_fields(folder / "whole/particles.e", before, folder / "part/particles.e", after,
                     EX_ELEM_BLOCK, {"von_mises", "displacement_y"});
  if (grid == bare) {  // else each step has a file of its own
    expect_same_fields(folder / "whole/grid.e", before, folder / "part/grid.e", after, EX_NODAL,
                       {"displacement_y", "displacement_x"});
  }
  const Outcome verdict = run_stroma(folder.path(), "verify part");
  EXPECT_EQ(verdict.status, 0) << verdict.standard_output << verdict.standard_error;
}

INSTANTIATE_TEST_SUITE_P(All, Restart,
                         ::testing::Values(std::tuple{bare, 1, 1}, std::tuple{bare, 2, 2},
                                           std::tuple{bare, 2, 1}, std::tuple{reset, 1, 1},
                                           std::tuple{reset, 2, 3}, std::tuple{splines, 1, 2}));

TEST(Restart, CutsOffWhatCameBehindTheCheckpoint) {
  const TemporaryFolder folder;
  run_deck(folder, "gel", long_deck(bare, 2));
  const std::string checkpoint = content_of(folder / "gel/checkpoint.h5");
  folder.write("gel.yaml", long_deck(bare, 4));
  const Outcome first = run_stroma(folder.path(), "run gel.yaml --quiet --restart");
  EXPECT_EQ(first.status, 0) << first.standard_error;
  const History whole(folder / "gel/history.csv");
  // As if the run had been killed in its last step.
  folder.write("gel/checkpoint.h5", checkpoint);
  const std::regex finished("\t[0-9]+ bytes.*");
  folder.write("gel/.stroma_files", std::regex_replace(content_of(folder / "gel/.stroma_files"),
                                                       finished, "\tbeing written"));
  std::ofstream(folder / "gel/history.csv", std::ios::app) << "5,0.9,3.6,2,1";
  const Outcome again = run_stroma(folder.path(), "run gel.yaml --quiet --restart");
  EXPECT_EQ(again.status, 0) << again.standard_error;
  EXPECT_EQ(difference(whole, History(folder / "gel/history.csv")), 0.0);
  const ExodusReader reader(folder / "gel/particles.e");
  ASSERT_EQ(reader.steps(), 5);
  EXPECT_EQ(reader.time(5), 4.0);
}

TEST(Restart, AFinishedRunHasNothingLeftToDo) {
  const TemporaryFolder folder;
  const History before = run_deck(folder, "gel", long_deck(bare, 2));
  const Outcome again = run_stroma(folder.path(), "run gel.yaml --quiet --restart");
  EXPECT_EQ(again.status, 0) << again.standard_error;
  EXPECT_EQ(difference(before, History(folder / "gel/history.csv")), 0.0);
  EXPECT_EQ(run_stroma(folder.path(), "run gel.yaml --quiet").status, 0) << "its files are its own";
}

// V-RESTART-6.
TEST(Restart, SpringsThatPullOnAreVerified) {
  const TemporaryFolder folder;
  const std::string deck = R"(
Stroma:
  Image:
    Phantom: {Kind: Uniform, Size: [8, 8, 8], "Voxel Size [um]": [1, 1, 1]}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.3}
  Grid: {Elements: [4, 4, 4], Shape Functions: GIMP, Reset: true}
  Loading: {Steps: 3}
  Output: {Pictures: false, Report: false}
  Rig: )";
  for (const std::string rig :
       {"{Kind: Clamped Extension, Face: y+, Strain: 0.3, Imposed By: Penalty}",
        "{Kind: Simple Shear, Face: y+, Direction: x, Strain: 0.3, Sides: Sheared}"}) {
    run_deck(folder, "gel", deck + rig + "\n");
    const Outcome verdict = run_stroma(folder.path(), "verify gel");
    EXPECT_EQ(verdict.status, 0) << verdict.standard_output << verdict.standard_error;
    EXPECT_NE(verdict.standard_output.find("solved anew"), std::string::npos);
  }
}

// V-RESTART-7.
TEST(Restart, ProjectedGradientsAreVerified) {
  for (const std::string shape : {"Linear", "CPDI"}) {
    const TemporaryFolder folder;
    run_deck(folder, "gel",
             R"(
Stroma:
  Image:
    Phantom: {Kind: Uniform, Size: [8, 12, 8], "Voxel Size [um]": [1, 1, 1]}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.4}
  Grid: {Elements: [4, 6, 4], Deformation Gradient: Projected Displacement, Reset: true, Shape Functions: )" +
                 shape + R"(}
  Loading: {Steps: 4}
  Output: {Pictures: false, Report: false}
  Rig: {Kind: Torsion, Face: y+, "Angle [deg]": 30}
)");
    const Outcome verdict = run_stroma(folder.path(), "verify gel");
    EXPECT_EQ(verdict.status, 0) << verdict.standard_output << verdict.standard_error;
  }
}

// V-RESTART-2.
TEST(Restart, ATimeLimitLeavesACheckpoint) {
  const TemporaryFolder folder;
  folder.write("gel.yaml", small_deck());
  const Outcome outcome =
      run_stroma(folder.path(), "run gel.yaml --quiet --time-limit 00:00:03" + endless);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.standard_error.find("stopped by --time-limit; on disk in gel: history.csv"),
            std::string::npos)
      << outcome.standard_error;
  EXPECT_NE(
      outcome.standard_error.find("to go on: stroma run gel.yaml -o gel" + endless + "--restart"),
      std::string::npos)
      << outcome.standard_error;
  const std::size_t rows = History(folder / "gel/history.csv").rows();
  EXPECT_GT(rows, 1U);
  EXPECT_EQ(run_stroma(folder.path(), "verify gel").status, 0);
  EXPECT_EQ(
      run_stroma(folder.path(), "run gel.yaml --quiet --restart --set 'Loading|Steps=2'").status,
      0);
  EXPECT_GE(History(folder / "gel/history.csv").rows(), rows + 1);
  EXPECT_EQ(run_stroma(folder.path(), "run gel.yaml --time-limit 3").status, 2);
}

// SIGUSR1, by which batch systems warn.
TEST(Restart, AWarningSignalLeavesACheckpoint) {
  const TemporaryFolder folder;
  folder.write("gel.yaml", small_deck());
  const Outcome outcome = run_script(
      folder, "set -m\n\"$stroma\" run gel.yaml -o out --quiet" + endless + R"( 2>errors &
run=$!
wait_for_steps out/history.csv
kill -USR1 $run
wait $run
echo status $?
"$stroma" verify out >verdict
echo status $?
)");
  EXPECT_EQ(outcome.standard_output, "status 1\nstatus 0\n")
      << content_of(folder / "errors") << content_of(folder / "verdict");
  EXPECT_NE(content_of(folder / "errors").find("stopped by SIGUSR1"), std::string::npos);
}

}  // namespace
}  // namespace stroma::test
