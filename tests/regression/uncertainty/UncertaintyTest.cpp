// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// `stroma study` with Uncertainty as a user runs it (V-UNCERTAINTY-2): of a uniform block forces
/// and stresses are proportional to its modulus, so that their bands are the draws' own.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/Program.hpp"

namespace stroma::test {
namespace {

const char* const block = R"(Stroma:
  Image:
    Phantom:
      Kind: Uniform
      Size: [4, 6, 5]
      Voxel Size [um]: [1.0, 1.0, 1.0]
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500.0, Poisson Ratio: 0.4}
  Grid:
    Element Size [um]: [2.0, 2.0, 2.5]
  Particles: {Layout: Voxel Centers}
  Boundary Conditions:
    bottom: {Face: y-, Components: y}
    top: {Face: y+, Components: y, Strain: 0.1}
  Loading: {Steps: 2}
  Output: {Pictures: false, Report: false, Particles Every: 0, Grid Every: 0}
)";

std::string study_of(const std::string& inputs, const std::string& more = "") {
  return "Study:\n  Base Deck: base.yaml\n" + more +
         "  Uncertainty:\n    Draws: 8\n    Finer Element Size [um]: [1.0, 1.0, 1.0]\n    Inputs:\n" +
         inputs;
}

const std::string modulus =
    "      modulus: {Path: \"Materials|gel|Shear Modulus [Pa]\", Distribution: Uniform, Range: [400, "
    "600]}\n";
const std::string tolerance =
    "      tolerance: {Path: Solver|Newton Tolerance, Distribution: Uniform, Range: [1e-10, 1e-9]}\n";

double number_behind(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + word.size()));
}

double quantile_of(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  return values[below] + (place - std::floor(place)) *
                             (values[std::min(below + 1, values.size() - 1)] - values[below]);
}

void expect_the_draws_own_bands(int ranks) {
  const TemporaryFolder folder;
  folder.write("base.yaml", block);
  folder.write("study.yaml", study_of(modulus + tolerance));
  const Outcome outcome = run_stroma(folder.path(), "study study.yaml", ranks);
  ASSERT_EQ(outcome.status, 0) << outcome.standard_output << outcome.standard_error;
  const fs::path study = folder.path() / "study";
  EXPECT_NE(
      outcome.standard_output.find("\"modulus\" and \"tolerance\" have a rank correlation of"),
      std::string::npos)
      << outcome.standard_output;

  std::vector<double> moduli, forces;
  std::ifstream draws(study / "draws.csv");
  std::string line, field;
  std::getline(draws, line);
  EXPECT_EQ(line, "member,modulus,tolerance,force");
  while (std::getline(draws, line)) {
    std::stringstream row(line);
    std::getline(row, field, ',');
    std::getline(row, field, ',');
    moduli.push_back(std::stod(field));
    std::getline(row, field, ',');
    std::getline(row, field, ',');
    forces.push_back(std::stod(field));
  }
  ASSERT_EQ(moduli.size(), 8u);
  const History middle(study / "middle" / "history.csv");
  const double force = middle["top.reaction_y"].back() / 500.0;
  const double stress = middle["gel.von_mises_mean"].back() / 500.0;
  for (std::size_t n = 0; n < 8; ++n) EXPECT_NEAR(forces[n] / moduli[n], force, 1e-7 * force);

  const History bands(study / "bands.csv");
  ASSERT_EQ(bands.rows(), 3u);
  EXPECT_NEAR(bands["low"].back(), force * quantile_of(moduli, 0.05), 1e-7 * bands["low"].back());
  EXPECT_NEAR(bands["median"].back(), force * quantile_of(moduli, 0.5),
              1e-7 * bands["median"].back());
  EXPECT_NEAR(bands["high"].back(), force * quantile_of(moduli, 0.95), 1e-7 * bands["high"].back());
  EXPECT_NEAR(bands["finer"].back(), force * 500.0, 1e-7 * bands["finer"].back());
  EXPECT_NE(content_of(study / "correlations.csv").find("modulus,1\n"), std::string::npos)
      << content_of(study / "correlations.csv");

  const std::pair<const char*, double> stacks[] = {{"05", 0.05}, {"50", 0.5}, {"95", 0.95}};
  for (const auto& [name, share] : stacks) {
    const std::string told =
        run_stroma(study, std::string("image von_mises_") + name + ".tif").standard_output;
    EXPECT_NE(told.find("4 x 6 x 5 voxels"), std::string::npos) << told;
    EXPECT_NE(told.find("1 x 1 x 1 um"), std::string::npos) << told;
    const double expected = stress * quantile_of(moduli, share);
    EXPECT_NEAR(number_behind(told, "intensity    min "), expected, 1e-6 * expected) << told;
    EXPECT_NEAR(number_behind(told, "max "), expected, 1e-6 * expected) << told;
  }
  EXPECT_EQ(content_of(study / "force_band.png").rfind("\x89PNG", 0), 0u);

  const Outcome again = run_stroma(folder.path(), "study study.yaml", ranks);
  EXPECT_EQ(again.status, 0) << again.standard_error;
  EXPECT_NE(again.standard_output.find("10 members, 10 of them finished before"), std::string::npos)
      << again.standard_output;
}

TEST(Uncertainty, OfAUniformBlockIsThatOfItsModulus) { expect_the_draws_own_bands(1); }
TEST(Uncertainty, IsTheSameOnTwoRanks) { expect_the_draws_own_bands(2); }

std::string of_strain(const std::string& distribution) {
  return "      strain: {Path: \"Boundary Conditions|top|Strain\", " + distribution + "}\n";
}

/// Draws that pull and draws that push: their forces differ in sign, whether or not the middle moves.
TEST(Uncertainty, PullingAndPushingDifferInSign) {
  for (const char* distribution : {"Range: [-0.05, 0.05]", "Range: [-0.05, 0.04]"}) {
    const TemporaryFolder folder;
    folder.write("base.yaml", block);
    folder.write("study.yaml", study_of(of_strain(distribution)));
    const Outcome outcome = run_stroma(folder.path(), "study study.yaml");
    ASSERT_EQ(outcome.status, 0) << outcome.standard_output << outcome.standard_error;
    const fs::path study = folder.path() / "study";
    std::ifstream draws(study / "draws.csv");
    std::string line, member;
    int pulled = 0;
    std::getline(draws, line);
    while (std::getline(draws, line)) {
      std::stringstream row(line);
      std::getline(row, member, ',');
      double strain = 0.0, force = 0.0;
      char comma = 0;
      row >> strain >> comma >> force;
      EXPECT_GT(strain * force, 0.0) << line;
      pulled += strain > 0.0 ? 1 : 0;
    }
    EXPECT_TRUE(pulled > 0 && pulled < 8);
    EXPECT_NE(content_of(study / "correlations.csv").find("strain,1\n"), std::string::npos)
        << content_of(study / "correlations.csv");
    const History bands(study / "bands.csv");
    EXPECT_LT(bands["low"].back(), bands["middle"].back());
    EXPECT_LT(bands["middle"].back(), bands["high"].back());
    EXPECT_EQ(content_of(study / "force_band.png").rfind("\x89PNG", 0), 0u);
  }
}

/// A body that a traction loads: there is no force to tell of, but there are stresses.
TEST(Uncertainty, WithoutASupportThatMovesHasBandsOfStress) {
  const TemporaryFolder folder;
  const std::string moved = "    top: {Face: y+, Components: y, Strain: 0.1}\n";
  std::string pulled = block;
  pulled.replace(pulled.find(moved), moved.size(),
                 "  External Forces:\n    pull: {Face: y+, \"Traction [Pa]\": [0, 50, 0]}\n");
  folder.write("base.yaml", pulled);
  folder.write("study.yaml", study_of(modulus));
  const Outcome outcome = run_stroma(folder.path(), "study study.yaml");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_output << outcome.standard_error;
  EXPECT_NE(outcome.standard_output.find("no bands of force, only of stress"), std::string::npos)
      << outcome.standard_output;
  EXPECT_EQ(outcome.standard_output.find("too few"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder.path() / "study/von_mises_50.tif"));
  EXPECT_FALSE(fs::exists(folder.path() / "study/bands.csv"));
}

TEST(BadUncertainties, RunNothing) {
  const TemporaryFolder folder;
  folder.write("base.yaml", block);
  const std::string path = "      m: {Path: \"Materials|gel|Shear Modulus [Pa]\", ";
  const struct {
    std::string deck, message;
  } cases[] = {
      {study_of(modulus, "  Vary: {\"Loading|Steps\": [1, 2]}\n"), "draws stand alone"},
      {study_of(path + "Range: [600, 400]}\n"), "two numbers that ascend"},
      {study_of(path + "Distribution: Uniform}\n"), "missing; Distribution is Uniform"},
      {study_of(path + "Distribution: Normal, Mean: 500}\n"), "Standard Deviation"},
      {study_of(path + "Distribution: Normal, Mean: 500, Standard Deviation: 0}\n"), "> 0"},
      {study_of(path + "Distribution: Gamma}\n"), "Log-normal"},
      {study_of(path +
                "Distribution: Log-normal, Median: 500, Relative Deviation: 0.1, Mean: 2}\n"),
       "belongs to another Distribution"},
      {study_of(path + "Range: [-600, -400]}\n"), "a number > 0"},
      {study_of("      m: {Path: Materials|gel|Stiffness, Range: [1, 2]}\n"), "Stiffness"},
      {study_of(modulus + path + "Range: [1, 2]}\n"), "the same parameter"},
      {"Study:\n  Base Deck: base.yaml\n  Uncertainty: {Draws: 3}\n", "Draws"},
  };
  for (const auto& one : cases) {
    folder.write("study.yaml", one.deck);
    const Outcome outcome = run_stroma(folder.path(), "study study.yaml");
    EXPECT_EQ(outcome.status, 2) << one.deck << outcome.standard_error;
    EXPECT_NE(outcome.standard_error.find(one.message), std::string::npos)
        << one.deck << outcome.standard_error;
    EXPECT_FALSE(fs::exists(folder.path() / "study")) << one.deck;
  }
}

}  // namespace
}  // namespace stroma::test
