// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Bodies that nothing holds against their loads are refused by `check` and `run` before anything
/// is computed; pieces that carry no load change nothing.

#include <gtest/gtest.h>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

const fs::path cases = clone_folder() / "tests/data/cases";

/// The case's folder, copied to where results may be written.
void copy_case(const std::string& name, const TemporaryFolder& folder) {
  fs::copy(cases / name, folder.path(), fs::copy_options::recursive);
}

void expect_refused(const std::string& name, const std::string& deck, const std::string& settings,
                    const std::vector<std::string>& told) {
  const TemporaryFolder folder;
  copy_case(name, folder);
  for (const int ranks : {1, 2})
    for (const std::string command : {"check ", "run "}) {
      const Outcome outcome = run_stroma(folder.path(), command + deck + settings, ranks);
      EXPECT_EQ(outcome.status, 2) << command << deck << settings << " on " << ranks;
      for (const std::string& text : told)
        EXPECT_NE(outcome.standard_error.find(text), std::string::npos)
            << command << deck << settings << " on " << ranks << "\nnot told: " << text << "\n"
            << outcome.standard_error;
      EXPECT_FALSE(fs::exists(folder / fs::path(deck).stem().string()));
    }
}

TEST(Statics, ALoadAlongAFreeMotionIsRefused) {
  expect_refused("load_on_free_motion", "roller.yaml", "", {"External Forces", "along x: 512 pN"});
  expect_refused("load_on_free_motion", "trac.yaml", "", {"External Forces", "along x: 640 pN"});
  expect_refused("load_on_free_motion", "trac.yaml",
                 " --set 'Grid|Reset=true' --set 'External Forces|t|Traction [Pa]=[0, 0, 10]'",
                 {"along z: 640 pN"});
}

TEST(Statics, ALoadedIslandIsRefused) {
  expect_refused("island", "island.yaml", "",
                 {"External Forces", "along y: 0.08 pN", "8 elements with 8 particles",
                  "around (6, 6, 6) um"});
}

TEST(Statics, ABodyInTwoPiecesBetweenItsGripsIsRefused) {
  expect_refused("gap", "deck.yaml", "",
                 {"Boundary Conditions|top", "strains nothing", "the other piece"});
  expect_refused("gap", "deck.yaml", " --set 'Boundary Conditions|top|Imposed By=Penalty'",
                 {"Boundary Conditions|top", "strains nothing"});
}

/// A block that slides along x, pulled by one curve and pushed by another.
std::string pulled_and_pushed(const std::string& push, const std::string& pushing) {
  return R"(Stroma:
  Image:
    Phantom: {Kind: Uniform, Size: [4, 4, 4], "Voxel Size [um]": [1, 1, 1]}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.3}
  Grid: {Elements: [2, 2, 2]}
  Boundary Conditions:
    bottom: {Face: y-, Components: y}
  Loading: {"Duration [s]": 1, Steps: 4}
  Load Curves:
    whole: {"Times [s]": [0, 0.5, 1], Values: [0, 1, 0]}
    half: {"Times [s]": [0, 0.5, 1], Values: [0, 0.5, 0]}
    other: {"Times [s]": [0, 0.25, 1], Values: [0, 0.5, 0]}
  External Forces:
    pull: {Face: x+, "Traction [Pa]": [5, 0, 0], Load Curve: whole}
    push: {Face: x-, "Traction [Pa]": )" +
         push + ", Load Curve: " + pushing + "}\n";
}

// V-SUP-3. Loads that balance each other at some load factors only, as at the end, where both are 0.
TEST(Statics, LoadsMustBalanceAtEveryLoad) {
  const TemporaryFolder folder;
  for (const int ranks : {1, 2})
    for (const std::string command : {"check ", "run "}) {
      const auto outcome_of = [&](const std::string& push, const std::string& pushing) {
        folder.write("deck.yaml", pulled_and_pushed(push, pushing));
        return run_stroma(folder.path(), command + "deck.yaml", ranks);
      };
      const Outcome balanced = outcome_of("[-10, 0, 0]", "half");
      EXPECT_EQ(balanced.status, 0) << balanced.standard_error;
      for (const auto& [push, pushing] :
           {std::pair("[-10, 0, 0]", "other"), {"[-5, 0, 0]", "half"}}) {
        const Outcome loose = outcome_of(push, pushing);
        EXPECT_EQ(loose.status, 2) << push << pushing << loose.standard_output;
        EXPECT_NE(loose.standard_error.find("at some load they have a resultant along x,"),
                  std::string::npos)
            << loose.standard_error;
      }
    }
}

// A body whose halves lie in one layer of elements, or in the reach of splines, is told: what its
// voxels part, the grid glues.
TEST(Statics, BodiesThatTheGridJoinsAreNoted) {
  const std::string note =
      "note: the image's filled voxels make 2 bodies that share no face of a voxel, and the grid joins "
      "them to 1";
  const TemporaryFolder folder;
  copy_case("gap", folder);
  for (const int ranks : {1, 2})
    for (const std::string command : {"check ", "run "})
      for (const std::string grid :
           {" --set 'Grid|Elements=[3, 4, 3]' --set 'Grid|Shape Functions=Quadratic B-Spline'",
            " --set 'Grid|Shape Functions=Cubic B-Spline'"}) {
        const Outcome outcome = run_stroma(folder.path(), command + "deck.yaml" + grid, ranks);
        EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
        EXPECT_NE(outcome.standard_output.find(note), std::string::npos)
            << command << grid << outcome.standard_output;
      }
  for (const std::string name : {"sponge/deck.yaml", "voxels_per_element/deck.yaml"}) {
    const Outcome one = run_stroma(folder.path(), "check " + quoted(cases / name));
    EXPECT_EQ(one.standard_output.find("make 2 bodies"), std::string::npos) << one.standard_output;
  }
}

/// A block of 8 um that is held by its lower y face, without the outermost layer of voxels at the upper
/// one along x from 0 to `gap` [um].
std::string block_with_gap(int gap) {
  return R"(Stroma:
  Image:
    Phantom:
      Kind: Shapes
      Size: [8, 8, 8]
      "Voxel Size [um]": [1, 1, 1]
      Shapes:
        gap: {Kind: Box, Label: -1, "Center [um]": [)" +
         std::to_string(0.5 * gap) + R"(, 7.5, 4], "Size [um]": [)" + std::to_string(gap) +
         R"(, 1, 10]}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.3}
  Grid: {Elements: [4, 4, 4]}
  Boundary Conditions:
    bottom: {Face: y-, Components: xyz}
)";
}

// V-REACH. A layer of empty voxels at the upper y face, thinner than an element: what is held or
// pulled there is told from what the body reaches.
TEST(Statics, AFaceThatTheBodyDoesNotReachIsRefused) {
  const std::string deck = block_with_gap(8);
  const std::vector<std::string> unreached{
      "    top: {Face: y+, Components: xyz, Strain: 0.1}\n",
      "    top: {Face: y+, Components: xyz, Strain: 0.1, Imposed By: Penalty}\n",
      "  External Forces:\n    top: {Face: y+, \"Traction [Pa]\": [10, 20, 5]}\n"};
  for (const std::string& top : unreached)
    for (const int ranks : {1, 2}) {
      const TemporaryFolder folder;
      folder.write("deck.yaml", deck + top);
      const Outcome outcome = run_stroma(folder.path(), "run deck.yaml", ranks);
      EXPECT_EQ(outcome.status, 2) << top;
      EXPECT_NE(outcome.standard_error.find("|top|Face: there is no particle at this face"),
                std::string::npos)
          << outcome.standard_error;
      folder.write("deck.yaml", deck + "    skin: {Face: all, Components: z}\n");
      EXPECT_NE(run_stroma(folder.path(), "run deck.yaml", ranks)
                    .standard_error.find("|skin|Face: there is no particle at y+"),
                std::string::npos);
      folder.write("deck.yaml",
                   deck +
                       "    side: {Face: x-, Components: x}\n"
                       "    top: {Face: y+, Components: xyz, Strain: 0.1, Imposed By: Grip}\n");
      EXPECT_EQ(run_stroma(folder.path(), "check deck.yaml", ranks).status, 0);
    }
}

// V-REACH. With the margin over a quarter of the face only, the traction acts on the rest, and the
// run says so: the other face holds 10 Pa on 48 of 64 um^2.
TEST(Statics, ATractionActsOnWhatTheFaceHasOfTheBody) {
  const TemporaryFolder folder;
  folder.write("deck.yaml", block_with_gap(2) + R"(  External Forces:
    top: {Face: y+, "Traction [Pa]": [0, 10, 0]}
  Loading: {Steps: 1}
  Solver: {Newton Tolerance: 1.0e-10}
)");
  for (const int ranks : {1, 2}) {
    const std::string out = "out" + std::to_string(ranks);
    const Outcome outcome = run_stroma(folder.path(), "run deck.yaml -o " + out, ranks);
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    EXPECT_NE(outcome.standard_output.find("External Forces|top: the body fills 75 % of its face"),
              std::string::npos)
        << outcome.standard_output;
    EXPECT_NEAR(History(folder / out / "history.csv")["bottom.reaction_y"].back(), -480.0, 1e-5);
  }
}

/// The island's deck without the weight; label -1 for the island: without the island.
double force_with_label(int label, int ranks, std::string& output) {
  const TemporaryFolder folder;
  std::string deck = content_of(cases / "island/island.yaml");
  deck.erase(deck.find("  External Forces"));
  const std::string key = "Label: 1\n          Center";
  deck.replace(deck.find(key), 8, "Label: " + std::to_string(label));
  folder.write("island.yaml", deck);
  const Outcome outcome = run_stroma(folder.path(), "run island.yaml", ranks);
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
  output = outcome.standard_output;
  return outcome.status == 0 ? History(folder / "island/history.csv")["top.reaction_y"].back() : 0;
}

TEST(Statics, AnIdleIslandIsLeftOutAndNoted) {
  std::string output;
  const double without = force_with_label(-1, 1, output);
  EXPECT_EQ(output.find("pieces"), std::string::npos) << output;
  for (const int ranks : {1, 2}) {
    EXPECT_NEAR(force_with_label(1, ranks, output), without, 1e-9 * without);
    EXPECT_NE(output.find("note: 1 fragment of the body, 8 voxels"), std::string::npos) << output;
  }
}

}  // namespace
}  // namespace stroma::test
