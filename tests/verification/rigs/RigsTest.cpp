// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Rigs against closed forms, independent solutions, and the conditions that they stand for. Claims
/// V-RIG-1 to V-RIG-4, docs/verification.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

constexpr double shear_modulus = 520.8, bulk_modulus = 2430.4;  // Poisson ratio 0.4

/// A block of 8.4 x 8.4 x 8 um, or another phantom, in a rig.
std::string deck(const std::string& rig, const std::string& grid = "Elements: [4, 4, 4]",
                 const std::string& phantom =
                     "Kind: Uniform, Size: [8, 8, 8], 'Voxel Size [um]': "
                     "[1.05, 1.05, 1]") {
  return "Stroma:\n"
         "  Image: {Phantom: {" +
         phantom +
         "}}\n"
         "  Materials:\n"
         "    gel: {Label: 0, 'Shear Modulus [Pa]': 520.8, Poisson Ratio: 0.4}\n"
         "  Grid: {" +
         grid +
         "}\n"
         "  Loading: {Steps: 4}\n"
         "  Solver: {Newton Tolerance: 1e-12}\n"
         "  Output: {Pictures: false, Report: false}\n"
         "  Rig: {" +
         rig + "}\n";
}

class Rigs : public ::testing::Test {
 protected:
  Outcome stroma(const std::string& command, const std::string& text,
                 const std::string& arguments = "", int ranks = 1) {
    std::ofstream(folder_ / "deck.yaml") << text;
    return run_stroma(folder_.path(), command + " deck.yaml" + arguments, ranks);
  }
  History run(const std::string& text, int ranks = 1) {
    const Outcome outcome = stroma("run", text, " --quiet -o out", ranks);
    EXPECT_EQ(outcome.status, 0) << text << outcome.standard_error;
    return History(folder_.path() / "out" / "history.csv");
  }
  TemporaryFolder folder_;
};

/// Nominal stress [Pa] along the first axis of a neo-Hookean body whose stretches along the axes
/// named are given, while the others let it shrink without stress: Kirchhoff stresses
/// tau_i = mu J^(-2/3) (l_i^2 - tr C / 3) + k ln J.
double nominal_stress(std::array<double, 3> stretch, int given) {
  const auto tau = [&](std::size_t i) {
    const double J = stretch[0] * stretch[1] * stretch[2];
    double trace = 0.0;
    for (const double l : stretch) trace += l * l;
    return shear_modulus * std::pow(J, -2.0 / 3.0) * (stretch[i] * stretch[i] - trace / 3.0) +
           bulk_modulus * std::log(J);
  };
  double low = 0.2, high = 5.0;
  for (int n = 0; n < 200 && given < 3; ++n) {
    const double middle = 0.5 * (low + high);
    for (std::size_t i = static_cast<std::size_t>(given); i < 3; ++i) stretch[i] = middle;
    (tau(2) < 0.0 ? low : high) = middle;
  }
  return tau(0) / stretch[0];
}

const std::array<double, 3> edge{8.4, 8.4, 8.0};

/// The body's cross-section across an axis [um^2].
double area(int axis) { return edge[0] * edge[1] * edge[2] / edge[static_cast<std::size_t>(axis)]; }

double force_at(const History& history, const std::string& condition, int axis, std::size_t row) {
  return history[condition + ".reaction_" + "xyz"[axis]][row];
}

// V-RIG-1. Between plates without friction a uniform body is in a uniaxial state, whichever way it
// lies and on any number of ranks; a displacement is a strain times the length.
TEST_F(Rigs, BetweenPlatesTheStateIsUniaxial) {
  struct Case {
    const char* kind;
    int axis, ranks;
    bool upper;
    double strain;
  };
  for (const Case& c : {Case{"Unconfined Compression", 1, 1, true, -0.3},
                        Case{"Unconfined Compression", 2, 2, false, -0.3},
                        Case{"Roller Extension", 0, 4, true, 0.4}}) {
    SCOPED_TRACE(c.kind);
    const std::string rig =
        std::string("Kind: ") + c.kind + ", Face: " + "xyz"[c.axis] + (c.upper ? "+" : "-");
    const History by_strain = run(deck(rig + ", Strain: " + std::to_string(c.strain)), c.ranks);
    const double length = edge[static_cast<std::size_t>(c.axis)];
    const History by_length =
        run(deck(rig + ", 'Displacement [um]': " + std::to_string(c.strain * length)), c.ranks);
    for (std::size_t s = 1; s <= 4; ++s) {
      const double stretch = 1.0 + c.strain * 0.25 * static_cast<double>(s);
      const double force =
          (c.upper ? 1.0 : -1.0) * nominal_stress({stretch, 1, 1}, 1) * area(c.axis);
      for (const History* history : {&by_strain, &by_length}) {
        EXPECT_NEAR(force_at(*history, "moved", c.axis, s), force, 1e-9 * std::abs(force));
        EXPECT_NEAR(force_at(*history, "held", c.axis, s), -force, 1e-9 * std::abs(force));
        EXPECT_NEAR((*history)["gel.von_mises_max"][s], (*history)["gel.von_mises_mean"][s],
                    1e-9 * (*history)["gel.von_mises_mean"][s]);
      }
    }
  }
}

// With reset: a lattice that is strained as the body is loses nothing.
TEST_F(Rigs, UnconfinedCompressionWithReset) {
  const double force = nominal_stress({0.8, 1, 1}, 1) * area(1);
  for (const auto& [how, tolerance] :
       {std::pair<std::string, double>{"Nodes", 1e-9}, {"Penalty", 1e-4}}) {
    const History history =
        run(deck("Kind: Unconfined Compression, Face: y+, Strain: -0.2, Imposed By: " + how,
                 "Elements: [4, 4, 4], Reset: true, Shape Functions: GIMP"));
    const double found = force_at(history, "moved", 1, 4);
    std::printf("  %s: off by %.1e\n", how.c_str(), found / force - 1.0);
    EXPECT_NEAR(found, force, tolerance * std::abs(force)) << how;
  }
}

// Its first iterates press on the free sides of the body, which then gives way to a rotation about
// its axis: the preconditioner has to stay definite.
TEST_F(Rigs, APressedBodyKeepsItsMultigrid) {
  const std::string block = "Kind: Uniform, Size: [32, 32, 32], 'Voxel Size [um]': [1.05, 1.05, 1]";
  const History history = run(
      deck("Kind: Unconfined Compression, Face: z-, Strain: -0.3", "Elements: [16, 16, 16]", block),
      2);
  for (std::size_t s = 1; s <= 4; ++s) {
    EXPECT_LE(history["linear_iterations"][s], 40) << "step " << s;
    EXPECT_EQ(history["load"][s], 0.25 * static_cast<double>(s));
  }
  EXPECT_NEAR(force_at(history, "moved", 2, 4), 16.0 * -nominal_stress({0.7, 1, 1}, 1) * area(2),
              1e-9 * 16.0 * area(2) * std::abs(nominal_stress({0.7, 1, 1}, 1)));
}

// V-RIG-1. Two stretches at once, the third direction free.
TEST_F(Rigs, BiaxialStretch) {
  const History history = run(deck("Kind: Biaxial, Axes: xz, Strains: [0.1, 0.25]"), 2);
  const double x = nominal_stress({1.1, 1.25, 1}, 2) * area(0),
               z = nominal_stress({1.25, 1.1, 1}, 2) * area(2);
  EXPECT_NEAR(force_at(history, "moved_x", 0, 4), x, 1e-9 * x);
  EXPECT_NEAR(force_at(history, "held_x", 0, 4), -x, 1e-9 * x);
  EXPECT_NEAR(force_at(history, "moved_z", 2, 4), z, 1e-9 * z);
}

/// Energy and force on the upper face across y of an independent solution at full load.
std::pair<double, double> reference(const std::string& name, std::size_t axis) {
  const auto file = nlohmann::json::parse(
      content_of(clone_folder() / "tests" / "data" / "reference" / (name + ".json")));
  const auto& last = file["results"]["steps"].back();
  return {last["energy"].get<double>(), last["F_y1"][axis].get<double>()};
}

// V-RIG-2. The reference solutions' digits.
TEST_F(Rigs, MeetsIndependentSolutions) {
  struct Case {
    std::string rig, name;
    int axis;
  };
  for (const Case& c :
       {Case{"Kind: Confined Compression, Face: y+, Strain: -0.2", "E_confined_compression", 1},
        Case{"Kind: 'Simple Shear', Face: y+, Direction: x, Strain: 0.2, Sides: Sheared",
             "E_simple_shear", 0},
        Case{"Kind: Clamped Extension, Face: y+, Strain: 0.1", "A_uniform4_voxel", 1}}) {
    SCOPED_TRACE(c.name);
    const auto [energy, force] = reference(c.name, static_cast<std::size_t>(c.axis));
    const History history = run(deck(c.rig));
    EXPECT_NEAR(force_at(history, "moved", c.axis, 4), force, 1e-9 * std::abs(force));
    EXPECT_NEAR(history["strain_energy"][4], energy, 1e-9 * energy);
  }
}

// V-RIG-2. Plates that do not let the body slide: the force's moment is balanced, and the sides
// make the body softer than when they are held to a homogeneous shear.
TEST_F(Rigs, SidesThatAreFreeMakeAShearSofter) {
  const std::string rig = "Kind: Simple Shear, Face: z+, Direction: y, Strain: 0.1";
  const History free = run(deck(rig)), sheared = run(deck(rig + ", Sides: Sheared"));
  const double homogeneous = shear_modulus * 0.1 * area(2);
  EXPECT_NEAR(force_at(sheared, "moved", 1, 4), homogeneous, 1e-9 * homogeneous);
  EXPECT_LT(force_at(free, "moved", 1, 4), 0.9 * homogeneous);
  EXPECT_GT(force_at(free, "moved", 1, 4), 0.4 * homogeneous);
}

/// Torque of a cylinder, over mu J angle / length with J = pi R^4 / 2.
double torque_over_saint_venants(const History& history, double radius, double length,
                                 double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180.0;
  const double polar = 0.5 * std::acos(-1.0) * std::pow(radius, 4);
  return history["moved.torque"].back() / (angle * shear_modulus * polar / length);
}

// V-RIG-3. A cylinder that is turned by a small angle, against Saint-Venant's torque; its surface is
// made of voxels, of which 16, 32 and 64 go on the diameter.
TEST_F(Rigs, TorsionOfACylinderConvergesToSaintVenants) {
  const double degrees = 0.1;
  double last = 1.0;
  for (const int voxels : {16, 32, 64}) {
    const std::string n = std::to_string(voxels), e = std::to_string(voxels / 2),
                      h = std::to_string(16.0 / voxels);
    const std::string phantom =
        "Kind: Shapes, Size: [" + n + ", " + n + ", " + e + "], 'Voxel Size [um]': [" + h + ", " +
        h + ", " + h +
        "], Shapes: {all: {Kind: Box, Label: -1, 'Center [um]': [8, 8, 4], 'Size [um]': "
        "[16, 16, 8]}, rod: {Kind: Cylinder, Label: 0, 'Center [um]': [8, 8, 4], 'Radius [um]': 8, "
        "Axis: [0, 0, 1]}}";
    std::string text =
        deck("Kind: Torsion, Face: z+, 'Angle [deg]': 0.1",
             "Elements: [" + e + ", " + e + ", " + std::to_string(voxels / 4) + "]", phantom);
    text.replace(text.find("Steps: 4"), 8, "Steps: 1");
    const double error = std::abs(torque_over_saint_venants(run(text), 8.0, 8.0, degrees) - 1.0);
    EXPECT_LT(error, 0.8 * last);
    last = error;
  }
  EXPECT_LT(last, 0.005);
}

// V-RIG-3. A bar that is far from round, turned far about an axis that is not its middle, with a
// force on it: the work of the torque is the energy, by Simpson's rule over twelve steps, at nodes, by grips
// and by springs, on 1 and 2 ranks; and the support's moment is that of the shape, not of the way it is held.
TEST_F(Rigs, TheTorqueDoesTheWork) {
  double at_nodes = 0.0;
  for (const char* way : {"Nodes", "Grip", "Penalty"}) {
    SCOPED_TRACE(way);
    for (const int ranks : {1, 2}) {
      std::string text = deck(
          "Kind: Torsion, Face: x+, 'Angle [deg]': 60, 'Center [um]': [0, 3, 6], "
          "Imposed By: " +
          std::string(way));
      text.replace(text.find("Steps: 4"), 8, "Steps: 12");
      const History history = run(text, ranks);
      const auto& torque = history["moved.torque"];
      double sum = torque.front() + torque.back();
      for (std::size_t s = 1; s < 12; ++s) sum += (s % 2 == 1 ? 4.0 : 2.0) * torque[s];
      const double work = sum / 36.0 * std::acos(-1.0) / 3.0;
      const double stored = history["strain_energy"].back();
      EXPECT_NEAR(work, stored, (std::string(way) == "Penalty" ? 2e-3 : 1e-5) * stored);
      if (std::string(way) == "Nodes") at_nodes = torque.back();
      if (std::string(way) == "Penalty") {
        EXPECT_NEAR(torque.back(), at_nodes, 2e-3 * at_nodes);
      }
    }
  }
  EXPECT_EQ(run_stroma(folder_.path(), "verify out").status, 0);
}

// V-RIG-4. `stroma check` and the log tell the conditions; deck.xml has them instead of the rig, and
// gives the same run.
TEST_F(Rigs, TellWhatTheyStandFor) {
  const std::string text = deck(
      "Kind: Torsion, Face: y+, 'Angle [deg]': 20, 'Center [um]': [4, 0, 4], Imposed By: Penalty");
  const Outcome check = stroma("check", text);
  EXPECT_EQ(check.status, 0) << check.standard_error;
  const History by_rig = run(text);
  for (const std::string& told : {check.standard_output, content_of(folder_ / "out/log.txt")}) {
    EXPECT_NE(told.find("Torsion, that is, Boundary Conditions:"), std::string::npos) << told;
    EXPECT_NE(told.find("held: Face = \"y-\", Components = \"xyz\""), std::string::npos) << told;
    EXPECT_NE(told.find("Rotation [deg] = 20, "), std::string::npos) << told;
  }
  const std::string as_run = content_of(folder_ / "out/deck.xml");
  EXPECT_EQ(as_run.find("name=\"Rig\""), std::string::npos);
  const Outcome again = run_stroma(folder_.path(), "run out/deck.xml --quiet -o again");
  ASSERT_EQ(again.status, 0) << again.standard_error;
  const History by_conditions(folder_.path() / "again" / "history.csv");
  EXPECT_EQ(by_rig.names(), by_conditions.names());
  EXPECT_EQ(by_rig["strain_energy"], by_conditions["strain_energy"]);
  EXPECT_EQ(by_rig["held.reaction_y"], by_conditions["held.reaction_y"]);
  // A run of the rig goes on from the results of its conditions: the body is the same.
  EXPECT_EQ(run_stroma(folder_.path(), "verify out").status, 0);
}

// A mistake that shows only once the image is read names the rig.
TEST_F(Rigs, AreNamedInErrorsOfTheirConditions) {
  const Outcome outcome = stroma(
      "run", deck("Kind: Clamped Extension, Face: y+, Strain: 0.1", "Elements: [4, 4, 4]",
                  "Kind: Shapes, Size: [8, 8, 8], 'Voxel Size [um]': [1, 1, 1], Shapes: {top: "
                  "{Kind: Box, Label: -1, 'Center [um]': [4, 7, 4], 'Size [um]': [8, 2, 8]}}"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.standard_error.find("line 9, Rig: its Boundary Conditions|moved|Face: there is "
                                        "no particle"),
            std::string::npos)
      << outcome.standard_error;
}

// A rig follows a load curve: there and back.
TEST_F(Rigs, FollowALoadCurve) {
  const History history =
      run(deck("Kind: Simple Shear, Face: y+, Direction: z, Strain: 0.3, Load Curve: swing") +
          "  Load Curves: {swing: {'Times [s]': [0, 0.5, 1], Values: [0, 1, 0]}}\n");
  EXPECT_GT(history["strain_energy"][2], 0.0);
  EXPECT_NEAR(history["strain_energy"][4], 0.0, 1e-12 * history["strain_energy"][2]);
  EXPECT_NEAR(history["strain_energy"][3], history["strain_energy"][1],
              1e-9 * history["strain_energy"][2]);
}

}  // namespace
}  // namespace stroma::test
