// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The residual that a run tells is the one there is; where rounding is as large as the forces no
/// step is taken, and sizes that cannot be computed with are refused.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

const fs::path deck = clone_folder() / "tests/data/cases/false_convergence/base.yaml";

Outcome run_with(const TemporaryFolder& folder, const std::string& settings, int ranks = 1,
                 const std::string& command = "run") {
  fs::copy_file(deck, folder / "base.yaml", fs::copy_options::overwrite_existing);
  return run_stroma(folder.path(), command + " base.yaml" + settings, ranks);
}

std::string stiff_ball(const std::string& modulus) {
  return " --set 'Materials|ball|Shear Modulus [Pa]=" + modulus +
         "' --set 'Solver|Preconditioner=Direct'";
}

TEST(Rounding, AsLargeAsTheForcesIsNoSolution) {
  const TemporaryFolder folder;
  const Outcome outcome = run_with(folder, stiff_ball("5e17"));
  EXPECT_EQ(outcome.status, 1);
  // Which of the two is met first hangs on the last bits of the factors.
  const bool is_told = outcome.standard_error.find("rounding alone leaves") != std::string::npos ||
                       outcome.standard_error.find("Newton did not converge") != std::string::npos;
  EXPECT_TRUE(is_told) << outcome.standard_error;
  EXPECT_EQ(History(folder / "base/history.csv").rows(), 1u) << "the unloaded body alone";
}

TEST(Rounding, SmallAgainstTheForcesIsToldAndNoted) {
  const TemporaryFolder folder;
  const Outcome outcome = run_with(folder, stiff_ball("1e12"));
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  const double residual = History(folder / "base/history.csv")["residual"].back();
  EXPECT_GT(residual, 1e-8);
  EXPECT_LT(residual, 1e-4);
  EXPECT_NE(outcome.standard_output.find("note: rounding limits the residual"), std::string::npos)
      << outcome.standard_output;
  EXPECT_EQ(outcome.standard_output.find("residual 0.00e+00"), std::string::npos)
      << outcome.standard_output;
}

// The largest residual is told, not the first one that rounding limits.
TEST(Rounding, IsToldAgainWhereItGrows) {
  const TemporaryFolder folder;
  const Outcome outcome = run_with(folder, stiff_ball("5e13") + " --set 'Loading|Steps=8'");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  const std::string note = "note: rounding limits the residual to ";
  double told = 0.0;
  for (std::size_t at = 0; (at = outcome.standard_output.find(note, at)) != std::string::npos;) {
    at += note.size();
    told = std::max(told, std::stod(outcome.standard_output.substr(at, 8)));
  }
  const std::vector<double> residuals = History(folder / "base/history.csv")["residual"];
  EXPECT_LT(*std::max_element(residuals.begin() + 1, residuals.end()), 2.1 * told);
}

// At the largest ratio of moduli that is admitted, the force is that of Poisson's ratio 0.4999 to 3e-4, or
// steps are rejected, and the advice names the ratio; which of the two hangs on the last bits.
TEST(Rounding, OfPressuresIsNotTakenForStress) {
  const auto with_ratio = [&](const TemporaryFolder& folder, const std::string& ratio) {
    return run_with(folder, " --set 'Materials|gel|Poisson Ratio=" + ratio +
                                "' --set 'Materials|ball|Poisson Ratio=" + ratio +
                                "' --set 'Solver|Preconditioner=Direct'");
  };
  const TemporaryFolder folder;
  ASSERT_EQ(with_ratio(folder, "0.4999").status, 0);
  const double force = History(folder / "base/history.csv")["top.reaction_y"].back();
  const Outcome outcome = with_ratio(folder, "0.49999999995");
  if (outcome.status == 0)
    EXPECT_NEAR(History(folder / "base/history.csv")["top.reaction_y"].back(), force, 1e-3 * force);
  else
    EXPECT_NE(outcome.standard_error.find("a bulk modulus is 1e+10 times the shear modulus"),
              std::string::npos)
        << outcome.standard_error;
}

// Twin: the load cases of a stiffness are solved to rounding, which the contrast makes as large as
// what the gel does. What was solved stays.
TEST(Rounding, AsLargeAsTheForcesOfAStiffnessIsNoResult) {
  const TemporaryFolder folder;
  std::string text = content_of(clone_folder() / "tests/data/cases/false_convergence/base.yaml");
  text.resize(text.find("  Boundary Conditions:"));
  folder.write("stiffness.yaml", text + "  Rig: {Kind: Stiffness, Boundary: [Mixed]}\n");
  const auto run = [&](const std::string& modulus) {
    return run_stroma(folder.path(), "run stiffness.yaml -o of_" + modulus +
                                         " --set 'Solver|Preconditioner=Direct' --set "
                                         "'Materials|ball|Shear Modulus [Pa]=" +
                                         modulus + "'");
  };
  EXPECT_EQ(run("5e9").status, 0);
  const Outcome outcome = run("5e17");
  EXPECT_EQ(outcome.status, 1) << outcome.standard_error;
  EXPECT_NE(
      outcome.standard_error.find("Rig|Boundary = Mixed: rounding alone leaves residuals of "),
      std::string::npos)
      << outcome.standard_error;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "of_5e17" / "stiffness.csv"));
}

TEST(Rounding, SizesWhoseSquaresOverflowAreRefused) {
  const std::pair<std::string, std::string> settings[] = {
      {"Materials|ball|Shear Modulus [Pa]=1e200", "Materials"},
      {"Materials|gel|Shear Modulus [Pa]=1e-200", "Materials"},
      {"Materials|gel|Shear Modulus [Pa]=1e-40", "single precision"},
      {"Materials|ball|Shear Modulus [Pa]=1e40", "single precision"},
      {"Boundary Conditions|top|Strain=1e-40", "single precision"},
      {"Boundary Conditions|top|Strain=1e-200", "Boundary Conditions|top"},
      {"Boundary Conditions|top|Strain=-1e180", "Boundary Conditions|top"},
      {"External Forces|f|Body Force [pN/um^3]=[0, 0, 1e-190]", "External Forces|f"},
      {"External Forces|f|Body Force [pN/um^3]=[0, 0, 1e190]", "External Forces|f"},
      {"Boundary Conditions|top|Strain=1e8", "the displacement over the body's longest edge"},
      {"Materials|gel|Poisson Ratio=0.49999999999999", "the bulk modulus over the shear modulus"},
      {"Materials|gel|Active Stress|T0 [Pa]=1e300", "Active Stress|T0 [Pa]"},
      {"Materials|gel|Growth|Ratio=1e200", "Growth|Ratio"}};
  for (const auto& [setting, section] : settings)
    for (const std::string command : {"check", "run"}) {
      const TemporaryFolder folder;
      const Outcome outcome = run_with(folder, " --set '" + setting + "'", 1, command);
      EXPECT_EQ(outcome.status, 2) << command << " " << setting << "\n" << outcome.standard_error;
      EXPECT_NE(outcome.standard_error.find(section), std::string::npos)
          << command << " " << setting << "\n"
          << outcome.standard_error;
    }
}

}  // namespace
}  // namespace stroma::test
