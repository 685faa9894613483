// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Decks whose grid does not go with their voxels, or with their material: run as a user does.

#include <gtest/gtest.h>

#include <cmath>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

const fs::path cases = clone_folder() / "tests" / "data" / "cases";

/// What a run of a case says and leaves.
struct Finished {
  Outcome outcome;
  std::vector<double> force;  ///< of the upper grip [pN], step by step
  std::string deck;           ///< as run
};

Finished run_case(const std::string& name, const std::string& overrides = "", int ranks = 1) {
  const TemporaryFolder folder;
  Finished run;
  run.outcome = run_stroma(folder.path(),
                           "run " + quoted(cases / name / "deck.yaml") +
                               " -o out --set 'Output|Pictures=false' " + overrides,
                           ranks);
  EXPECT_EQ(run.outcome.status, 0) << run.outcome.standard_error;
  if (run.outcome.status != 0) return run;
  run.force = History(folder.path() / "out" / "history.csv")["top.reaction_y"];
  run.deck = content_of(folder.path() / "out" / "deck.xml");
  return run;
}

bool says(const Finished& run, const std::string& text) {
  return run.outcome.standard_output.find(text) != std::string::npos;
}

// The law's own force, 33685.19 pN (QuadratureTest has all ratios and shape functions).
TEST(Resolution, AUniformBlockDoesNotDependOnItsElements) {
  const std::string tight =
      "--set 'Solver|Newton Tolerance=1e-11' --set 'Solver|Linear Tolerance=1e-11' ";
  const double whole =
      run_case("voxels_per_element", tight + "--set 'Grid|Elements=[6,6,6]'").force.back();
  EXPECT_NEAR(whole, 33685.19, 0.005);
  for (const char* elements : {"[8,8,8]", "[7,7,7]", "[12,12,12]", "[13,5,24]"})
    for (const int ranks : {1, 2})
      EXPECT_NEAR(
          run_case("voxels_per_element", tight + "--set 'Grid|Elements=" + elements + "'", ranks)
              .force.back(),
          whole, 1e-9 * whole)
          << elements << ", " << ranks << " ranks";
}

// V-QUAD-2. Twins: other shape functions, by the defaults, and a grid that is reset. Elements that are centred at
// nodes cut the particles of a full body, and none of them is barely filled.
TEST(Resolution, HoldsForSplinesAndAGridThatIsReset) {
  const std::string tight =
      "--set 'Solver|Newton Tolerance=1e-11' --set 'Solver|Linear Tolerance=1e-11' ";
  for (const char* shape : {"GIMP", "CPDI", "Quadratic B-Spline", "Cubic B-Spline"})
    for (const char* is_reset : {"false", "true"})
      for (const int ranks : {1, 2}) {
        const Finished run = run_case("voxels_per_element",
                                      tight + "--set 'Grid|Shape Functions=" + shape +
                                          "' --set 'Grid|Reset=" + is_reset + "'",
                                      ranks);
        ASSERT_EQ(run.force.size(), 2u);
        EXPECT_NEAR(run.force.back(), 33685.1870917, 1e-9 * 33685.0) << shape << is_reset;
        EXPECT_FALSE(says(run, "less than half")) << shape << is_reset;
      }
  std::string reset = "--set 'Grid|Reset=true' --set 'Boundary Conditions|top|Imposed By=Penalty'";
  for (const char* condition : {"bottom", "x0", "z0"})
    reset += std::string(" --set 'Boundary Conditions|") + condition + "|Imposed By=Nodes'";
  EXPECT_NEAR(run_case("voxels_per_element", tight + reset).force.back(), 33685.19, 2.0)
      << "springs in series";
}

TEST(Resolution, ElementsFinerThanVoxelsHoldTheBodyTogether) {
  const Finished fine = run_case("elements_finer_than_voxels");
  ASSERT_FALSE(fine.force.empty());
  const double coarse =
      run_case("elements_finer_than_voxels", "--set 'Grid|Elements=[4,6,4]'").force.back();
  EXPECT_NEAR(coarse, 1713.0, 0.5);
  EXPECT_NEAR(fine.force.back(), coarse, 0.01 * coarse);
  EXPECT_TRUE(says(fine, "note: elements are finer than voxels along y"));
}

// Twin: a voxel an element, which used to be integrated at one point; its force is that of the
// mesh, as with more voxels.
TEST(Resolution, OneVoxelAnElementIsIntegratedInFull) {
  const double one =
      run_case("elements_finer_than_voxels", "--set 'Grid|Elements=[8,12,8]'").force.back();
  const double four = run_case("elements_finer_than_voxels",
                               "--set 'Grid|Elements=[8,12,8]' --set 'Particles|Per Voxel=4'")
                          .force.back();
  EXPECT_NEAR(one, four, 2e-3 * four);
}

TEST(Resolution, ExplicitLayoutsSayWhatTheyLack) {
  const Finished gauss = run_case("voxels_per_element", "--set 'Particles|Layout=Gauss'");
  EXPECT_TRUE(
      says(gauss, "Particles|Layout = Gauss does not resolve the voxels along x and y and z"));
  const Outcome check = run_stroma(
      cases, "check " + quoted(cases / "voxels_per_element" / "deck.yaml") +
                 " --set 'Particles|Layout=Per Element' --set 'Particles|Per Element=1'");
  EXPECT_NE(check.standard_output.find("under-integrates"), std::string::npos);
}

// V-LOCK-8.
TEST(Locking, AutomaticTakesTheMeanWhereItIsNeeded) {
  const Finished automatic = run_case("locking");
  ASSERT_EQ(automatic.force.size(), 3u);
  EXPECT_NEAR(automatic.force.back(), 7766.0, 0.5);
  EXPECT_TRUE(says(automatic, "dilatation Element Mean (Automatic"));
  EXPECT_NE(automatic.deck.find("\"Automatic\""), std::string::npos) << automatic.deck;
  const Finished mean = run_case("locking", "--set 'Grid|Dilatation=Element Mean'");
  EXPECT_EQ(mean.force, automatic.force);
}

// Twins: a modulus instead of the ratio; CPDI; and what was asked for stays, with a note.
TEST(Locking, IsNotedWhereItIsAskedFor) {
  const fs::path deck = cases / "locking" / "deck.yaml";
  const auto check = [&](const std::string& overrides) {
    return run_stroma(cases, "check " + quoted(deck) + " " + overrides).standard_output;
  };
  const std::string pointwise = check("--set 'Grid|Dilatation=Pointwise'");
  EXPECT_NE(pointwise.find("note: Grid|Dilatation = Pointwise lets these shape functions lock"),
            std::string::npos);
  EXPECT_NE(pointwise.find("\"Element Mean\""), std::string::npos);
  const std::string projected = check("--set 'Grid|Deformation Gradient=Projected Displacement'");
  EXPECT_NE(projected.find("dilatation  Pointwise (Automatic"), std::string::npos) << projected;
  EXPECT_NE(projected.find("Projected Displacement admits no other"), std::string::npos);
  const std::string cpdi = check("--set 'Grid|Shape Functions=CPDI'");
  EXPECT_NE(cpdi.find("dilatation  Element Mean"), std::string::npos);
  EXPECT_NE(cpdi.find("takes a part of their locking from Shape Functions = CPDI"),
            std::string::npos);
  EXPECT_EQ(check("").find("takes a part of their locking"), std::string::npos);
  const std::string splines = check("--set 'Grid|Shape Functions=Quadratic B-Spline'");
  EXPECT_NE(splines.find("dilatation  Pointwise"), std::string::npos);
  EXPECT_EQ(splines.find("shape functions lock"), std::string::npos);
  const std::string border = check(
      "--set 'Materials|matrix|Poisson Ratio=0.45' --set 'Materials|vessel|Poisson Ratio=0.45'");
  EXPECT_NE(border.find("dilatation  Pointwise (Automatic, for Poisson ratios up to 0.45)"),
            std::string::npos)
      << border;
  EXPECT_NE(border.find("lock at a Poisson ratio of 0.45"), std::string::npos);
}

}  // namespace
}  // namespace stroma::test
