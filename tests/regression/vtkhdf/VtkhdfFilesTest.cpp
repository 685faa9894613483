// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Output|VTKHDF: what particles.e and grid.e have, of runs that are killed and go on, too.

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "regression/restart/LongDeck.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/output/files/ExodusFile.hpp"
#include "stroma/output/files/StateFile.hpp"
#include "support/ExodusReader.hpp"
#include "support/SmallDeck.hpp"
#include "support/WriteStack.hpp"

namespace stroma::test {
namespace {

const std::string vtkhdf = " --set 'Output|VTKHDF=true' ";

struct Listed {
  fs::path path;
  double time;
};

/// What a list names; all of it is there, and can be read.
std::vector<Listed> listed(const fs::path& folder, const std::string& name) {
  std::vector<Listed> all;
  const auto list = nlohmann::json::parse(content_of(folder / (name + ".hdf.series")));
  for (const auto& file : list["files"]) {
    all.push_back({folder / file["name"].get<std::string>(), file["time"]});
    const output::StateReader reader(all.back().path);
    EXPECT_GT(reader.get<double>("VTKHDF/Points").size(), 0U);
  }
  return all;
}

using Values = std::map<std::int64_t, double>;  // by the number in the whole

Values of_exodus(const fs::path& path, int ranks, int step, ex_entity_type type,
                 const std::string& name) {
  Values values;
  for (int r = 0; r < ranks; ++r) {
    const ExodusReader reader(output::spread_file_name(path, ranks, r));
    const auto ids = reader.numbers(type == EX_NODAL ? EX_NODE_MAP : EX_ELEM_MAP);
    std::size_t next = 0;
    for (std::int64_t b = 1; b <= (type == EX_NODAL ? 1 : reader.counts.num_elem_blk); ++b)
      for (const double value :
           reader.variable(step, type, name, b,
                           type == EX_NODAL ? reader.counts.num_nodes : reader.block(b).elements))
        values[ids[next++]] = value;
  }
  return values;
}

Values of_vtkhdf(const fs::path& path, const std::string& name, std::size_t component,
                 std::size_t components) {
  const output::StateReader reader(path);
  const auto ids = reader.get<std::int64_t>("VTKHDF/PointData/id");
  const auto all = reader.get<double>("VTKHDF/PointData/" + name);
  EXPECT_EQ(all.size(), components * ids.size());
  Values values;
  for (std::size_t n = 0; n < ids.size(); ++n) values[ids[n]] = all[components * n + component];
  return values;
}

/// Of each step the same values, to the last bit.
void expect_same(const fs::path& folder, int ranks, bool is_reset,
                 const std::vector<std::string>& vectors = {"displacement", "residual"}) {
  const auto particles = listed(folder, "particles"), grids = listed(folder, "grid");
  const History history(folder / "history.csv");
  ASSERT_EQ(particles.size(), history.rows());
  ASSERT_EQ(grids.size(), history.rows());
  for (int s = 0; s < static_cast<int>(particles.size()); ++s) {
    const auto n = static_cast<std::size_t>(s);
    EXPECT_EQ(particles[n].time, history["time"][n]);
    EXPECT_EQ(grids[n].time, history["time"][n]);
    const output::StateReader reader(particles[n].path);
    EXPECT_EQ(reader.value<double>("VTKHDF/FieldData/gel.von_mises_mean"),
              history["gel.von_mises_mean"][n]);
    const auto of_particles = [&](const std::string& name) {
      return of_exodus(folder / "particles.e", ranks, s + 1, EX_ELEM_BLOCK, name);
    };
    EXPECT_EQ(of_vtkhdf(particles[n].path, "von_mises", 0, 1), of_particles("von_mises"));
    EXPECT_EQ(of_vtkhdf(particles[n].path, "stress", 3, 6), of_particles("stress_xy"));
    EXPECT_EQ(of_vtkhdf(particles[n].path, "strain", 5, 6), of_particles("strain_zx"));
    EXPECT_EQ(of_vtkhdf(particles[n].path, "displacement", 1, 3), of_particles("displacement_y"));
    const std::string grid = is_reset && s > 0 ? base::format("grid.e-s%03d", s + 1) : "grid.e";
    const int step = is_reset ? 1 : s + 1;
    for (const std::string& name : vectors)
      EXPECT_EQ(of_vtkhdf(grids[n].path, name, 1, 3),
                of_exodus(folder / grid, ranks, step, EX_NODAL, name + "_y"));
  }
}

}  // namespace

// V-VTKHDF-1.
TEST(VtkhdfFiles, HaveWhatTheExodusFilesHave) {
  const TemporaryFolder folder;
  for (const bool is_reset : {false, true})
    for (const int ranks : {1, 2}) {
      const std::string out = std::string(is_reset ? "reset" : "plain") + std::to_string(ranks);
      folder.write("gel.yaml", long_deck(is_reset ? ", Reset: true" : "", 2));
      const Outcome outcome =
          run_stroma(folder.path(), "run gel.yaml --quiet -o " + out + vtkhdf, ranks);
      ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
      expect_same(folder / out, ranks, is_reset);
      const Outcome verified = run_stroma(folder.path(), "verify " + out, ranks);
      EXPECT_EQ(verified.status, 0) << verified.standard_output;
      EXPECT_NE(verified.standard_output.find("grid.hdf.series good"), std::string::npos)
          << verified.standard_output;
    }
}

/// The same body with inertia, set out with a shear that images hold.
std::string moving_deck(const std::string& grid) {
  std::string deck = long_deck(grid, 2);
  const auto replace = [&](const std::string& what, const std::string& by) {
    deck.replace(deck.find(what), what.size(), by);
  };
  replace(
      "      Poisson Ratio: 0.4\n      Viscosity: {Moduli: [0.6], \"Relaxation Times [s]\": [1.5]}",
      "      Poisson Ratio: 0.4\n      \"Density [kg/m^3]\": 1000");
  replace("1000, Poisson", "1000, \"Density [kg/m^3]\": 1000, Poisson");
  replace("    bottom: {Face: y-, Components: xyz, \"Displacement [um]\": [0, 0, 0]}\n",
          "    bottom: {Face: y-, Components: y, \"Displacement [um]\": [0, 0, 0]}\n");
  replace("Components: xyz, Strain", "Components: y, Strain");
  replace("{\"Times [s]\": [1.0, 2.0]}", "{Inertia: true, \"Times [s]\": [1.0e-5, 2.0e-5]}");
  replace("  Loading:",
          "  Initial Conditions:\n    shear: {Velocity Images: {Images: [v.mhd, v.mhd, v.mhd], "
          "\"Voxel Size [um]\": [1, 1, 1]}}\n  Loading:");
  return deck;
}

// V-VTKHDF-1. Velocities of a body in motion, too: at rest they are those of the images.
TEST(VtkhdfFiles, HaveTheVelocitiesOfABodyWithInertia) {
  const TemporaryFolder folder;
  write_stack<double>(folder, "v", {12, 12, 12},
                      [](int, int, int k) { return 1000.0 * (k + 0.5); });
  for (const bool is_reset : {false, true})
    for (const int ranks : {1, 2}) {
      const std::string out = std::string(is_reset ? "reset" : "plain") + std::to_string(ranks);
      folder.write("gel.yaml", moving_deck(is_reset ? ", Reset: true, Shape Functions: GIMP" : ""));
      const Outcome outcome =
          run_stroma(folder.path(), "run gel.yaml --quiet -o " + out + vtkhdf, ranks);
      ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
      expect_same(folder / out, ranks, is_reset, {"displacement", "residual", "velocity"});
      const output::StateReader grid(listed(folder / out, "grid").front().path);
      const auto places = grid.get<double>("VTKHDF/Points"),
                 velocities = grid.get<double>("VTKHDF/PointData/velocity");
      ASSERT_EQ(velocities.size(), places.size());
      for (std::size_t n = 0; n < places.size(); n += 3)
        EXPECT_NEAR(velocities[n], 1000.0 * places[n + 2], 1e-6) << places[n + 2];
    }
}

// V-VTKHDF-2.
TEST(VtkhdfFiles, GoOnWithTheRunOnOtherRanks) {
  const TemporaryFolder folder;
  folder.write("gel.yaml", long_deck("", 2));
  ASSERT_EQ(run_stroma(folder.path(), "run gel.yaml --quiet" + vtkhdf).status, 0);
  const std::string checkpoint = content_of(folder / "gel/checkpoint.h5"),
                    files = content_of(folder / "gel/.stroma_files");
  folder.write("gel.yaml", long_deck("", 4));
  ASSERT_EQ(run_stroma(folder.path(), "run gel.yaml --quiet --restart" + vtkhdf).status, 0);
  EXPECT_EQ(listed(folder / "gel", "particles").size(), 5U);
  // As if it had been killed behind the old checkpoint, and goes on by two ranks for one step.
  folder.write("gel/checkpoint.h5", checkpoint);
  folder.write("gel.yaml", long_deck("", 3));
  const Outcome again = run_stroma(folder.path(), "run gel.yaml --quiet --restart" + vtkhdf, 2);
  EXPECT_EQ(again.status, 0) << again.standard_error;
  EXPECT_EQ(listed(folder / "gel", "particles").size(), 4U);
  EXPECT_FALSE(fs::exists(folder / "gel/particles-s0004.hdf"));
  EXPECT_FALSE(fs::exists(folder / "gel/grid-s0004.hdf"));
  expect_same(folder / "gel", 2, false);
}

// V-VTKHDF-2.
TEST(VtkhdfFiles, OfAKilledRunCanBeReadAsFarAsTheyGo) {
  const TemporaryFolder folder;
  folder.write("gel.yaml", small_deck());
  for (const std::string delay : {"0", "0.05", "0.11", "0.17"}) {
    const std::string out = "out" + delay;
    const Outcome outcome = run_script(
        folder, "set -m\n\"$stroma\" run gel.yaml --quiet -o " + out + vtkhdf + endless +
                    " >output 2>errors &\nrun=$!\nwait_for_steps " + out + "/history.csv\nsleep " +
                    delay + "\nkill -KILL -$run\nwait $run\ntrue\n");
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    EXPECT_GE(listed(folder / out, "particles").size(), 2U);
    EXPECT_GE(listed(folder / out, "grid").size(), 2U);
  }
  // A file that is another step's is found.
  EXPECT_EQ(run_stroma(folder.path(), "run gel.yaml -o whole --quiet" + vtkhdf).status, 0);
  fs::remove(folder / "whole/particles-s0001.hdf");
  fs::copy_file(folder / "whole/particles-s0002.hdf", folder / "whole/particles-s0001.hdf");
  const Outcome verified = run_stroma(folder.path(), "verify whole");
  EXPECT_EQ(verified.status, 1);
  EXPECT_NE(verified.standard_output.find("particles.hdf.series WRONG"), std::string::npos)
      << verified.standard_output;
  // The next run knows them for its own.
  EXPECT_EQ(run_stroma(folder.path(), "run gel.yaml -o out0 --quiet").status, 0);
  EXPECT_FALSE(fs::exists(folder / "out0/particles.hdf.series"));
  EXPECT_FALSE(fs::exists(folder / "out0/particles-s0001.hdf"));
}

}  // namespace stroma::test
