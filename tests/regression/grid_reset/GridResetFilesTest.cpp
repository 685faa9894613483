// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What a run with grid reset leaves on disk: particles in one order whatever they did, a grid file
/// for each grid, the same on any number of ranks. Claim V-RESET-8, docs/verification.md.

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/ExodusReader.hpp"
#include "support/VesselBlock.hpp"

namespace stroma::test {
namespace {

const std::string deck = vessel_block("16, 20, 12") + R"(    Reset: true
  Boundary Conditions:
    bottom:
      Face: y-
      Components: xyz
      Displacement [um]: [2.6, 2.2, 0.5]
      Imposed By: Grip
    top:
      Face: y+
      Components: xyz
      Displacement [um]: [3.1, 4.3, -2.1]
      Imposed By: Grip
  Loading:
    Steps: 4
  Solver:
    Newton Tolerance: 1.0e-11
    Linear Tolerance: 1.0e-9
  Output:
    Pictures: false
)";

std::pair<double, double> ends_of(const std::vector<double>& coordinates) {
  const auto ends = std::minmax_element(coordinates.begin(), coordinates.end());
  return {*ends.first, *ends.second};
}

struct Particle {
  std::array<double, 3> X;
  double von_mises, displacement_y;
};

/// All particles of a step, by number, from a file or its spread parts.
std::map<std::int64_t, Particle> particles_of(const fs::path& folder, int ranks, int step) {
  std::map<std::int64_t, Particle> all;
  for (int rank = 0; rank < ranks; ++rank) {
    std::string name = "particles.e";
    if (ranks > 1) name += "." + std::to_string(ranks) + "." + std::to_string(rank);
    const ExodusReader file((folder / name).string());
    const auto X = file.coordinates();
    const auto numbers = file.numbers(EX_NODE_MAP);
    std::map<std::int64_t, std::size_t> place;
    for (std::size_t n = 0; n < numbers.size(); ++n) place[numbers[n]] = n;
    const auto elements = file.numbers(EX_ELEM_MAP);
    std::size_t element = 0;
    for (std::int64_t block = 1; block <= 2; ++block) {
      const auto count = file.block(block).elements;
      const auto von_mises = file.variable(step, EX_ELEM_BLOCK, "von_mises", block, count);
      const auto u = file.variable(step, EX_ELEM_BLOCK, "displacement_y", block, count);
      for (std::size_t e = 0; e < static_cast<std::size_t>(count); ++e, ++element) {
        const std::size_t n = place.at(elements[element]);
        EXPECT_TRUE(all.emplace(elements[element],
                                Particle{{X[0][n], X[1][n], X[2][n]}, von_mises[e], u[e]})
                        .second);
      }
    }
  }
  return all;
}

TEST(GridResetFiles, AreTheSameOnAnyNumberOfRanks) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("gel.yaml", deck);
  std::map<std::int64_t, Particle> one;
  for (const int ranks : {1, 2, 4}) {
    const fs::path out = folder.path() / ("out" + std::to_string(ranks));
    const Outcome outcome =
        run_stroma(folder.path(), "run " + quoted(path) + " -o " + quoted(out) + " --quiet", ranks);
    ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
    const History history(out / "history.csv");
    ASSERT_EQ(history.rows(), 5u);

    // Particles: where they were seeded, moved as the grips say at both ends.
    const auto particles = particles_of(out, ranks, 5);
    ASSERT_EQ(particles.size(), 16u * 20 * 12);
    double highest = 0.0;
    for (const auto& [number, particle] : particles) {
      const std::int64_t id = number - 1;
      EXPECT_NEAR(particle.X[0], (static_cast<double>(id % 16) + 0.5) * 1.05, 1e-12);
      EXPECT_NEAR(particle.X[1], (static_cast<double>(id / 16 % 20) + 0.5) * 1.05, 1e-12);
      if (particle.X[1] < 2.1) {
        EXPECT_NEAR(particle.displacement_y, 2.2, 1e-12);
      }
      if (particle.X[1] > 18.9) {
        EXPECT_NEAR(particle.displacement_y, 4.3, 1e-12);
      }
      highest = std::max(highest, particle.von_mises);
    }
    EXPECT_NEAR(
        std::max(history["collagen.von_mises_max"].back(), history["vessel.von_mises_max"].back()),
        highest, 1e-12 * highest);
    if (ranks == 1) {
      one = particles;
    } else {
      for (const auto& [number, particle] : particles) {
        EXPECT_NEAR(particle.von_mises, one.at(number).von_mises, 1e-8 * highest);
        EXPECT_NEAR(particle.displacement_y, one.at(number).displacement_y, 1e-9);
      }
    }

    // Grids: one file for each of the five, with the elements of that step and nothing else.
    for (int step = 0; step <= 4; ++step) {
      std::string name = step == 0 ? "grid.e" : "grid.e-s00" + std::to_string(step + 1);
      if (ranks > 1) name += "." + std::to_string(ranks) + ".0";
      ASSERT_TRUE(fs::exists(out / name)) << name;
      const ExodusReader grid((out / name).string());
      EXPECT_EQ(grid.steps(), 1);
      EXPECT_NEAR(grid.time(1), 0.25 * step, 1e-12);
      if (ranks == 1 && step <= 1) {
        EXPECT_EQ(grid.counts.num_elem, 8 * 10 * 6);
      }
      if (ranks == 1 && step > 1) {      // it has gone with the body, whose particles it holds
        constexpr double depth = 0.525;  // of the outermost particles [um]
        const double before = 0.25 * (step - 1);
        const auto [left, right] = ends_of(grid.coordinates()[0]);
        EXPECT_GT(left, before * 2.0);
        EXPECT_GT(right, 16.8 + before * 2.0);
        const auto [bottom, top] = ends_of(grid.coordinates()[1]);
        EXPECT_LE(bottom, before * 2.2 + depth);
        EXPECT_GE(top, 21.0 + before * 4.3 - depth);
      }
    }
  }
  // An earlier run's grid files do not survive the next run in the same folder.
  run_stroma(folder.path(), "run " + quoted(path) +
                                " -o out1 --quiet --set 'Grid|Reset=false' "
                                "--set 'Boundary Conditions|bottom|Imposed By=Grip'");
  EXPECT_FALSE(fs::exists(folder.path() / "out1" / "grid.e-s002"));
}

// A load that cannot be taken: all that was computed is on disk, and the message says how to go on.
TEST(GridResetFiles, AFailedRunKeepsWhatItHas) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("gel.yaml", deck);
  const Outcome outcome = run_stroma(folder.path(),
                                     "run " + quoted(path) +
                                         " -o out --quiet --set 'Loading|Smallest Step=0.2' --set "
                                         "'Boundary Conditions|top|Displacement [um]={0, -17, 0}'",
                                     2);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.standard_error.find("to go on"), std::string::npos) << outcome.standard_error;
  const History history(folder.path() / "out" / "history.csv");
  ASSERT_GE(history.rows(), 1u);
  const ExodusReader particles((folder.path() / "out" / "particles.e.2.0").string());
  EXPECT_EQ(particles.steps(), static_cast<int>(history.rows()));
}

}  // namespace
}  // namespace stroma::test
