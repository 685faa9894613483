// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A run whose steps fail says what helps there, and what it says helps; `check` says it before for
/// a contrast of moduli that single precision does not resolve, and for what a deck says without effect.

#include <gtest/gtest.h>

#include <fstream>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

const fs::path cases = clone_folder() / "tests/data/cases";
const std::string contrast = " --set 'Materials|ball|Shear Modulus [Pa]=5e11'";  // 1e9

Outcome run_case(const std::string& deck, const std::string& settings, int ranks = 1,
                 const std::string& command = "run ") {
  const TemporaryFolder folder;
  fs::copy((cases / deck).parent_path(), folder.path(), fs::copy_options::recursive);
  return run_stroma(folder.path(), command + fs::path(deck).filename().string() + settings, ranks);
}

const std::string follower =
    "  External Forces:\n    weight:\n      Body Force [pN/um^3]: [0, 0.1, 0]\n"
    "      Load Curve: slow\n";

/// What a command says of a deck with a load curve, after `sections`, in which something may follow
/// it.
Outcome with_a_curve(const std::string& sections, const std::string& command,
                     const std::string& settings = "") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "deck.yaml")
      << std::ifstream(cases / "false_convergence/base.yaml").rdbuf() << sections
      << "  Load Curves:\n    slow:\n      Times [s]: [0, 1]\n      Values: [0, 1]\n";
  return run_stroma(folder.path(), command + "deck.yaml" + settings);
}

/// Expects a run to fail in its first step and to name `advice`, and to go through once it is
/// taken.
void expect_helped(const std::string& deck, const std::string& settings, const std::string& before,
                   const std::string& advice, const std::string& after) {
  for (const int ranks : {1, 2}) {
    const Outcome failed =
        run_case(deck, settings + before + " --set 'Loading|Smallest Step=0.5'", ranks);
    EXPECT_EQ(failed.status, 1) << failed.standard_output << failed.standard_error;
    EXPECT_NE(failed.standard_error.find(advice), std::string::npos) << failed.standard_error;
    const Outcome helped = run_case(deck, settings + after, ranks);
    EXPECT_EQ(helped.status, 0) << helped.standard_error;
  }
}

// V-ADVICE.
TEST(Advice, ContrastIsHelpedByDoublePrecision) {
  expect_helped("false_convergence/base.yaml", contrast, "",
                "- the stiffest material is 1e+09 times stiffer",
                " --set 'Solver|Preconditioner=Multigrid'");
}

TEST(Advice, BarelyFilledElementsAreHelpedByStabilization) {
  expect_helped("sponge/deck.yaml", "", " --set 'Grid|Stabilization=0'",
                "- 288 elements are filled by less than half: Grid|Stabilization = 1e-4",
                " --set 'Grid|Stabilization=1e-4'");
}

TEST(Advice, LockingIsHelpedByTheMean) {
  expect_helped("false_convergence/base.yaml",
                " --set 'Materials|gel|Poisson Ratio=0.4999' "
                "--set 'Boundary Conditions|top|Strain=0.2'",
                " --set 'Grid|Dilatation=Pointwise'",
                "- Grid|Dilatation = Pointwise lets these shape functions lock",
                " --set 'Grid|Dilatation=Element Mean'");
}

TEST(Advice, ContrastIsNotedWhereItMatters) {
  const std::string note = "note: the stiffest material is ";
  const auto is_noted = [&](const std::string& settings, const std::string& command) {
    const Outcome outcome = run_case("false_convergence/base.yaml", settings, 1, command);
    return outcome.standard_output.find(note) != std::string::npos;
  };
  EXPECT_TRUE(is_noted(contrast, "check "));
  EXPECT_TRUE(is_noted(contrast, "run "));
  EXPECT_FALSE(is_noted(contrast + " --set 'Solver|Preconditioner=Multigrid'", "check "));
  EXPECT_FALSE(is_noted(contrast + " --set 'Grid|Shape Functions=GIMP'", "check "));
  EXPECT_FALSE(is_noted("", "check "));
}

TEST(Advice, FewerParticlesThanSplinesAreNoted) {
  const auto is_noted = [&](const std::string& settings) {
    const Outcome outcome = run_case("false_convergence/base.yaml", settings, 1, "check ");
    return outcome.standard_output.find("functions across the body along x, but") !=
           std::string::npos;
  };
  const std::string cubic = " --set 'Grid|Shape Functions=Cubic B-Spline'";
  EXPECT_TRUE(is_noted(cubic + " --set 'Grid|Elements={2, 4, 4}' --set 'Particles|Layout=Per "
                               "Element' --set 'Particles|Per Element=2'"));
  EXPECT_FALSE(is_noted(cubic));
  EXPECT_FALSE(is_noted(" --set 'Grid|Elements={2, 4, 4}'"));
}

// V-TIME-6.
TEST(Advice, CurvesThatStepsDoNotMeetAreNoted) {
  const std::string note =
      "note: Load Curves|slow goes on until 2 s, to 1, but the run ends at 1 s";
  const std::string later = " --set 'Load Curves|slow|Times [s]=[0, 2]'";
  for (const char* command : {"check ", "run "}) {
    EXPECT_NE(with_a_curve(follower, command, later).standard_output.find(note), std::string::npos);
    EXPECT_EQ(with_a_curve("", command, later).standard_output.find(note), std::string::npos);
    EXPECT_EQ(with_a_curve(follower, command).standard_output.find("note: Load Curves|slow"),
              std::string::npos);
  }
}

TEST(Advice, ACurveThatBeginsHighIsNamedWhereTheFirstStepFails) {
  const std::string advice = "- Load Curves|slow is 1 from the start, however small";
  const std::string fails = contrast + " --set 'Loading|Smallest Step=0.5'";
  const Outcome high =
      with_a_curve(follower, "run ", fails + " --set 'Load Curves|slow|Values=[1, 1]'");
  EXPECT_EQ(high.status, 1) << high.standard_output;
  EXPECT_NE(high.standard_error.find(advice), std::string::npos) << high.standard_error;
  const Outcome low = with_a_curve(follower, "run ", fails);
  EXPECT_EQ(low.status, 1) << low.standard_output;
  EXPECT_EQ(low.standard_error.find("- Load Curves"), std::string::npos) << low.standard_error;
}

TEST(Advice, MaterialsWithoutAParticleAreNoted) {
  const std::string note = "note: Materials|ball: no particle is of this material (label 1)";
  for (const char* command : {"check ", "run "}) {
    const auto said = [&](const std::string& settings) {
      return run_case("false_convergence/base.yaml", settings, 1, command).standard_output;
    };
    EXPECT_EQ(said("").find(note), std::string::npos);
    const std::string without = said(" --set 'Image|Phantom|Shapes|ball|Label=0'");
    EXPECT_NE(without.find(note), std::string::npos) << without;
    const bool has_stress_of_none = without.find("mean 0, max 0 Pa\n") != std::string::npos;
    EXPECT_FALSE(has_stress_of_none) << without;
  }
}

// A ball of 2 um in radius in elements of 2 um: its chords are 4/3 of the radius on the average.
TEST(Advice, FewElementsAcrossAMaterialAreNoted) {
  const auto said = [&](const std::string& settings, const std::string& command) {
    return run_case("false_convergence/base.yaml", settings, 1, command).standard_output;
  };
  const std::string note = "note: few elements across ball: from wall to wall on the average ";
  for (const char* command : {"check ", "run "}) {
    const std::string coarse = said("", command);
    EXPECT_NE(coarse.find(note), std::string::npos) << coarse;
    EXPECT_EQ(coarse.find("few elements across matrix"), std::string::npos) << coarse;
    const std::string fine = said(" --set 'Grid|Elements=[8, 8, 8]'", command);
    EXPECT_EQ(fine.find(note), std::string::npos) << fine;
  }
}

// Bars whose walls lie on nodes: elements about them are half full, until the bars thin.
TEST(Advice, ElementsThatBecomeBarelyFilledAreNoted) {
  const TemporaryFolder folder;
  folder.write("bars.yaml", R"(Stroma:
  Image:
    Phantom:
      Kind: Shapes
      Size: [12, 8, 4]
      Voxel Size [um]: [1, 1, 1]
      Shapes:
        gap: {Kind: Box, Label: -1, "Center [um]": [6, 4, 2], "Size [um]": [4, 8, 4]}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.3}
  Grid:
    Element Size [um]: [2, 2, 2]
    Shape Functions: GIMP
    Reset: true
  Rig: {Kind: Roller Extension, Face: y+, Strain: 0.1}
  Loading:
    Steps: 2
)");
  const std::string note = "note: from load 0.5 on, 30 elements are filled by less than half";
  const Outcome pulled = run_stroma(folder.path(), "run bars.yaml -o pulled");
  EXPECT_EQ(pulled.status, 0) << pulled.standard_error;
  EXPECT_NE(pulled.standard_output.find(note), std::string::npos) << pulled.standard_output;
  const Outcome pushed =
      run_stroma(folder.path(), "run bars.yaml -o pushed --set 'Rig|Strain=-0.1'");
  EXPECT_EQ(pushed.status, 0) << pushed.standard_error;
  EXPECT_EQ(pushed.standard_output.find("filled by less than half"), std::string::npos)
      << pushed.standard_output;
}

TEST(Advice, LoadsThatAreOftenNotMeantAreNoted) {
  const auto is_noted = [&](const std::string& settings, const std::string& what,
                            const std::string& command = "check ") {
    const Outcome outcome = run_case("false_convergence/base.yaml", settings, 1, command);
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    return outcome.standard_output.find("note: " + what) != std::string::npos;
  };
  const std::string strain = " --set 'Boundary Conditions|top|Strain=";
  const std::string per_cent = "Boundary Conditions|top: Strain = 5 is 500 % of the body's length";
  EXPECT_TRUE(is_noted(strain + "5'", per_cent));
  EXPECT_FALSE(is_noted(strain + "0.5'", per_cent));
  const std::string grip = "Boundary Conditions|top: a Grip holds a layer";
  EXPECT_TRUE(is_noted(" --set 'Boundary Conditions|top|Imposed By=Grip'", grip));
  EXPECT_FALSE(is_noted("", grip));
  const std::string both =
      "Boundary Conditions|top: the opposite face has Strain, too: 0.15 in all";
  EXPECT_TRUE(is_noted(" --set 'Boundary Conditions|bottom|Strain=0.05'", both));
  EXPECT_FALSE(is_noted(" --set 'Boundary Conditions|bottom|Displacement [um]=[0, 1, 0]'", both));
  const auto moved_by = [&](const std::string& motion, const std::string& what) {
    const TemporaryFolder folder;
    std::string text = content_of(clone_folder() / "tests/data/cases/false_convergence/base.yaml");
    const std::string strained = "      Strain: 0.10\n";
    text.replace(text.find(strained), strained.size(), "      " + motion + "\n");
    folder.write("far.yaml", text);
    const Outcome outcome = run_stroma(folder.path(), "check far.yaml");
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    return outcome.standard_output.find("note: Boundary Conditions|top: " + what) !=
           std::string::npos;
  };
  const std::string sheared =
      "20 in its Displacement Gradient (the Strain of Simple Shear) is 2000 %";
  EXPECT_TRUE(moved_by("Displacement Gradient: [0, 20, 0, 0, 0, 0, 0, 0, 0]", sheared));
  EXPECT_FALSE(moved_by("Displacement Gradient: [0, 0.2, 0, 0, 0, 0, 0, 0, 0]", "0.2 in its"));
  const std::string far = "its displacement, 24 um, is ";
  EXPECT_TRUE(moved_by("'Displacement [um]': [0, 24, 0]", far));
  EXPECT_FALSE(moved_by("'Displacement [um]': [0, 2.4, 0]", "its displacement"));
  const auto pulled_along = [&](const std::string& components, const std::string& traction) {
    const TemporaryFolder folder;
    std::string text = content_of(clone_folder() / "tests/data/cases/false_convergence/base.yaml");
    const std::string all = "      Components: xyz\n      Strain: 0.10\n";
    text.replace(text.find(all), all.size(), "      Components: " + components + "\n");
    text += "  External Forces: {pull: {Face: y+, 'Traction [Pa]': " + traction + "}}\n";
    folder.write("pull.yaml", text);
    const Outcome outcome = run_stroma(folder.path(), "check pull.yaml");
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    return outcome.standard_output.find(
               "note: External Forces|pull: Boundary Conditions|top holds its face along y") !=
           std::string::npos;
  };
  EXPECT_TRUE(pulled_along("xyz", "[0, 9, 0]"));
  EXPECT_TRUE(pulled_along("y", "[0, 9, 0]"));
  EXPECT_FALSE(pulled_along("xyz", "[0, 0, 9]"));
  EXPECT_FALSE(pulled_along("xz", "[0, 9, 0]"));
  const std::string slice = " --set 'Image|Phantom|Size=[8, 8, 1]' --set 'Grid|Elements=[4, 4, 1]'";
  const std::string flat = " --set 'Grid|Plane Strain=true'";
  const std::string sheet = "the image is a single slice, and Grid|Plane Strain is false";
  EXPECT_TRUE(is_noted(slice, sheet));
  EXPECT_FALSE(is_noted(slice + flat, sheet));
  EXPECT_FALSE(is_noted("", sheet));
  const std::string rest = "nothing strains the body: its energy is at most";
  EXPECT_TRUE(is_noted(strain + "0'", rest, "run "));
  EXPECT_FALSE(is_noted(strain + "1e-6'", rest, "run "));
}

TEST(Advice, WhatHasNoEffectIsNoted) {
  const auto is_noted = [&](const std::string& settings, const std::string& what) {
    const Outcome outcome = run_case("false_convergence/base.yaml", settings, 1, "check ");
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    return outcome.standard_output.find("note: " + what + " has no effect") != std::string::npos;
  };
  const std::string per_element = " --set 'Particles|Per Element=3'";
  EXPECT_TRUE(is_noted(per_element, "Particles|Per Element"));
  EXPECT_FALSE(
      is_noted(per_element + " --set 'Particles|Layout=Per Element'", "Particles|Per Element"));
  EXPECT_TRUE(is_noted(" --set 'Particles|Per Voxel=2' --set 'Particles|Layout=Gauss'",
                       "Particles|Per Voxel"));
  const std::string undeformed = " --set 'Grid|Particle Domain=Undeformed' --set 'Grid|Reset=true'";
  EXPECT_TRUE(is_noted(undeformed, "Grid|Particle Domain"));
  EXPECT_FALSE(is_noted(undeformed + " --set 'Grid|Shape Functions=GIMP'", "Grid|Particle Domain"));
  const std::string note = "note: Load Curves|slow has no effect";
  EXPECT_NE(with_a_curve("", "check ").standard_output.find(note), std::string::npos);
  const std::string followed = with_a_curve(follower, "check ").standard_output;
  EXPECT_EQ(followed.find(note), std::string::npos);
  EXPECT_NE(followed.find("ready to run"), std::string::npos) << followed;
  const TemporaryFolder folder;
  folder.write("flat.yaml", R"(Stroma:
  Image:
    Phantom:
      Kind: Shapes
      Size: [8, 8, 1]
      "Voxel Size [um]": [1, 1, 1]
      Shapes: {ball: {Kind: Ball, Label: 0, "Center [um]": [4, 4, 0.5], "Radius [um]": 1}}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.3}
  Grid: {Elements: [4, 4, 1], Plane Strain: true}
  Boundary Conditions:
    bottom: {Face: y-, Components: xy}
  External Forces:
    weight: {"Body Force [pN/um^3]": [0, 1, 2]}
)");
  const std::string flat = run_stroma(folder.path(), "check flat.yaml").standard_output;
  EXPECT_NE(flat.find("note: External Forces|weight|Body Force [pN/um^3] along z has no effect"),
            std::string::npos)
      << flat;
}

}  // namespace
}  // namespace stroma::test
