// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Conditions and forces that follow curves of time: an elastic body feels where its faces are, and
/// not when they came there. Claims V-TIME-2 to V-TIME-5, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/ExodusReader.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

/// A block of gel with a stiff ball in it; `rest` are further sections, by two spaces deeper.
std::string deck(const std::string& top, const std::string& rest, const std::string& grid = "") {
  return "Stroma:\n"
         "  Image:\n"
         "    Phantom:\n"
         "      Kind: Shapes\n"
         "      Size: [8, 8, 8]\n"
         "      Voxel Size [um]: [1, 1, 1]\n"
         "      Shapes:\n"
         "        ball: {Kind: Ball, 'Center [um]': [4, 4, 4], 'Radius [um]': 2.5}\n"
         "  Materials:\n"
         "    gel: {Label: 0, 'Shear Modulus [Pa]': 520.8, Poisson Ratio: 0.4}\n"
         "    ball: {Label: 1, 'Shear Modulus [Pa]': 5208, Poisson Ratio: 0.4}\n"
         "  Grid:\n"
         "    Elements: [4, 4, 4]\n" +
         grid +
         "  Solver: {Newton Tolerance: 1e-11}\n"
         "  Output: {Pictures: false}\n"
         "  Boundary Conditions:\n"
         "    bottom: {Face: y-, Components: xyz}\n"
         "    top: {Face: y+, Components: xyz, " +
         top + "}\n" + rest;
}

const std::string hold =
    "  Load Curves:\n"
    "    hold: {'Times [s]': [0, 1], Values: [0, 1]}\n"
    "    late: {'Times [s]': [2, 4], Values: [0, 1], Interpolation: Smooth}\n"
    "    there and back: {'Times [s]': [0, 2, 4], Values: [0, 1, 0]}\n";

class LoadCurves : public ::testing::Test {
 protected:
  History run(const std::string& text, int ranks = 1) {
    const std::string name = "deck" + std::to_string(++runs_) + ".yaml";
    std::ofstream(folder_ / name) << text;
    const std::string out = "out" + std::to_string(runs_);
    const Outcome outcome = run_stroma(folder_.path(), "run " + name + " --quiet -o " + out, ranks);
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    return History(folder_.path() / out / "history.csv");
  }
  fs::path last() const { return folder_.path() / ("out" + std::to_string(runs_)); }

  TemporaryFolder folder_;
  int runs_ = 0;
};

void expect_same_state(const History& found, std::size_t row, const History& expected,
                       std::size_t expected_row) {
  const double size =
      std::abs(expected["top.reaction_y"].back()) + std::abs(expected["top.reaction_x"].back());
  for (const std::string& name : found.names()) {
    if (name.find("reaction") == std::string::npos) continue;
    EXPECT_NEAR(found[name][row], expected[name][expected_row], 1e-9 * size) << name << row;
  }
  EXPECT_NEAR(found["strain_energy"][row], expected["strain_energy"][expected_row],
              1e-9 * expected["strain_energy"].back());
}

// V-TIME-2. A ramp and a hold, with steps at listed times: at 1/4, 1/2 and 1 s the states of a plain
// run at 1/4, 1/2 and full load, and no change afterwards.
TEST_F(LoadCurves, ARampMeetsThePlainRunAndAHoldStays) {
  const History plain = run(deck("Strain: 0.2", "  Loading: {Steps: 4}\n"));
  for (const int ranks : {1, 2}) {
    const History held =
        run(deck("Strain: 0.2, Load Curve: hold",
                 hold + "  Loading: {'Duration [s]': 5, 'Times [s]': [0.25, 0.5, 1, 2.5, 5]}\n"),
            ranks);
    const std::vector<double> times{0.0, 0.25, 0.5, 1.0, 2.5, 5.0};
    const std::size_t same_as[] = {0, 1, 2, 4, 4, 4};
    ASSERT_EQ(held.rows(), times.size());
    for (std::size_t s = 0; s < times.size(); ++s) {
      EXPECT_DOUBLE_EQ(held["time"][s], times[s]);
      EXPECT_DOUBLE_EQ(held["load"][s], times[s] / 5.0);
      expect_same_state(held, s, plain, same_as[s]);
    }
  }
  const ExodusReader particles((last() / "particles.e.2.0").string());
  EXPECT_EQ(particles.steps(), 6);
  EXPECT_DOUBLE_EQ(particles.time(4), 1.0);
}

TEST_F(LoadCurves, TimeIsTheLoadFactorWithoutADuration) {
  const History plain = run(deck("Strain: 0.1", "  Loading: {Steps: 2}\n"));
  EXPECT_EQ(plain["time"], plain["load"]);
}

// Imposed in each way, and turned: what goes there and back leaves nothing behind.
TEST_F(LoadCurves, ThereAndBackIsNothing) {
  for (const char* way : {"Strain: 0.2, Imposed By: Nodes", "Strain: 0.2, Imposed By: Grip",
                          "Strain: 0.2, Imposed By: Penalty", "'Rotation [deg]': 30"}) {
    SCOPED_TRACE(way);
    const History run_back = run(deck(std::string(way) + ", Load Curve: there and back",
                                      hold + "  Loading: {'Duration [s]': 4, Steps: 8}\n"));
    const double most = run_back["strain_energy"][4];
    EXPECT_GT(most, 0.0);
    EXPECT_NEAR(run_back["strain_energy"].back(), 0.0, 1e-12 * most);
    for (std::size_t s = 0; s <= 8; ++s)
      EXPECT_NEAR(run_back["strain_energy"][s], run_back["strain_energy"][8 - s], 1e-8 * most);
  }
}

// On a grid that is reset, the path is walked back, too: what is left is the method's own error.
TEST_F(LoadCurves, ThereAndBackWithResetIsNearlyNothing) {
  const History run_back =
      run(deck("Strain: 0.1, Load Curve: there and back",
               hold + "  Loading: {'Duration [s]': 4, Steps: 8}\n", "    Reset: true\n"));
  EXPECT_NEAR(run_back["strain_energy"].back(), 0.0, 0.02 * run_back["strain_energy"][4]);
}

// V-TIME-4. The body begins undeformed, and what a curve has from its start on comes with the first
// step: in the end it is where a plain run takes it, or back at rest.
TEST_F(LoadCurves, ACurveMayBeginWithAValue) {
  const std::string curves =
      "  Load Curves:\n"
      "    at once: {'Times [s]': [0], Values: [1]}\n"
      "    back: {'Times [s]': [0, 4], Values: [1, 0]}\n"
      "  Loading: {'Duration [s]': 4, Steps: 4}\n";
  for (const char* way : {"Strain: 0.1, Imposed By: Nodes", "Strain: 0.1, Imposed By: Grip",
                          "Strain: 0.1, Imposed By: Penalty", "'Rotation [deg]': 20"})
    for (const char* grid : {"", "    Reset: true\n    Shape Functions: GIMP\n"}) {
      SCOPED_TRACE(std::string(way) + grid);
      const History plain = run(deck(way, "  Loading: {Steps: 1}\n", grid));
      const History at_once = run(deck(std::string(way) + ", Load Curve: at once", curves, grid));
      EXPECT_EQ(at_once["strain_energy"][0], 0.0);
      EXPECT_EQ(at_once["top.reaction_y"][0], 0.0);
      expect_same_state(at_once, 1, plain, 1);
      EXPECT_NEAR(at_once["strain_energy"].back(), plain["strain_energy"].back(),
                  (*grid == 0 ? 1e-9 : 0.03) * plain["strain_energy"].back());
      if (*grid != 0) continue;
      const History back = run(deck(std::string(way) + ", Load Curve: back", curves, grid));
      EXPECT_NEAR(back["strain_energy"].back(), 0.0, 1e-12 * plain["strain_energy"].back());
    }
}

// V-TIME-5. Generalised alpha has its balance within a step: faces that follow a curve, or turn, are
// on the way to where they shall be at its end, or what goes there from the balance would be strained
// beside them. Slow, so that inertia is nothing, the forces are those of a body without, at order 2.
TEST_F(LoadCurves, GeneralisedAlphaFollowsThem) {
  const std::string moving = ", Inertia: true, Scheme: Generalised Alpha";
  const auto run_in = [&](const std::string& way, int steps, const std::string& motion) {
    std::string text =
        deck(way + ", Load Curve: smooth",
             "  Load Curves:\n"
             "    smooth: {'Times [s]': [0, 4], Values: [0, 1], Interpolation: Smooth}\n"
             "  Loading: {'Duration [s]': 4, Steps: " +
                 std::to_string(steps) + motion + "}\n");
    for (std::size_t at = text.find("Poisson"); at != std::string::npos;
         at = text.find("Poisson", at + 40))
      text.insert(at, "'Density [kg/m^3]': 1000, ");
    return run(text);
  };
  for (const std::string way :
       {"Strain: 0.1, Imposed By: Nodes", "Strain: 0.1, Imposed By: Penalty, Penalty Factor: 1e3",
        "Strain: 0.1, Imposed By: Penalty", "'Rotation [deg]': 40"}) {
    SCOPED_TRACE(way);
    const std::string figure = way[0] == 'S' ? "top.reaction_y" : "top.torque";
    double error[2];
    for (const int refined : {0, 1}) {
      const int steps = refined == 0 ? 10 : 20;
      const std::vector<double> slow = run_in(way, steps, "")[figure],
                                found = run_in(way, steps, moving)[figure];
      error[refined] = 0.0;
      for (std::size_t s = 0; s < slow.size(); ++s)
        error[refined] = std::max(error[refined], std::abs(found[s] - slow[s]) / slow.back());
    }
    EXPECT_LT(error[0], 1e-3);
    EXPECT_NEAR(error[0] / error[1], 4.0, 0.4);
  }
}

// V-TIME-3. A traction that comes late and smoothly beside one that grows with the load: at the end
// both are there; until 2 s there is the first alone; the supports bear what acts.
TEST_F(LoadCurves, ForcesFollowTheirCurves) {
  const std::string forces =
      "  External Forces:\n"
      "    pull: {'Traction [Pa]': [0, 40, 0], Face: y+}\n"
      "    push: {'Traction [Pa]': [25, 0, 0], Face: y+, Load Curve: late}\n";
  const std::string loading = "  Loading: {'Duration [s]': 4, Steps: 4}\n";
  std::string text = deck("", hold + forces + loading);
  text.erase(text.find("    top: "),
             text.find('\n', text.find("    top: ")) + 1 - text.find("    top: "));
  const History history = run(text);
  const double area = 64.0;
  const double late[] = {0.0, 0.0, 0.0, 0.5, 1.0};
  for (std::size_t s = 0; s <= 4; ++s) {
    EXPECT_NEAR(history["bottom.reaction_y"][s], -40.0 * area * history["load"][s], 1e-6) << s;
    EXPECT_NEAR(history["bottom.reaction_x"][s], -25.0 * area * late[s], 1e-6) << s;
  }
}

// V-TIME-3. A force per volume that comes late, and a weight that comes and goes, on a body of 512 um^3
// with 1000 kg/m^3 in the gel and in the ball (1 kg/m^3 um^3 m/s^2 is 1e-6 pN).
TEST_F(LoadCurves, VolumeForcesFollowTheirCurves) {
  std::string text =
      deck("", hold +
                   "  External Forces:\n"
                   "    push: {'Body Force [pN/um^3]': [2, 0, 0], Load Curve: late}\n"
                   "    weight: {'Acceleration [m/s^2]': [0, -1e4, 0], Load Curve: "
                   "there and back}\n"
                   "  Loading: {'Duration [s]': 4, Steps: 4}\n");
  text.erase(text.find("    top: "),
             text.find('\n', text.find("    top: ")) + 1 - text.find("    top: "));
  for (std::size_t at = text.find("Poisson"); at != std::string::npos;
       at = text.find("Poisson", at + 40))
    text.insert(at, "'Density [kg/m^3]': 1000, ");
  const double volume = 512.0, late[] = {0.0, 0.0, 0.0, 0.5, 1.0},
               back[] = {0.0, 0.5, 1.0, 0.5, 0.0};
  for (const int ranks : {1, 2}) {
    const History history = run(text, ranks);
    for (std::size_t s = 0; s <= 4; ++s) {
      EXPECT_NEAR(history["bottom.reaction_x"][s], -2.0 * volume * late[s], 1e-6) << s;
      EXPECT_NEAR(history["bottom.reaction_y"][s], 1e-6 * 1000.0 * 1e4 * volume * back[s], 1e-6)
          << s;
    }
  }
}

}  // namespace
}  // namespace stroma::test
