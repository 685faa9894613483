// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// `stroma check` and `stroma run` print the bounds of the stiffness where two materials are in the
/// image, alike and on any ranks, and say nothing where there is one. Claim V-BOUNDS,
/// docs/verification.md.

#include <gtest/gtest.h>

#include "support/Program.hpp"

namespace stroma::test {
namespace {

/// Both moduli of the vessels are twice the collagen's.
std::string deck(const std::string& phantom, const std::string& grid) {
  return R"(Stroma:
  Image:
    Phantom:
      Voxel Size [um]: [1.0, 1.0, 1.0]
)" + phantom +
         R"(  Materials:
    vessel: {Label: 1, "Shear Modulus [Pa]": 1041.6, "Bulk Modulus [Pa]": 2083.2}
    collagen: {Label: 0, "Shear Modulus [Pa]": 520.8, "Bulk Modulus [Pa]": 1041.6}
  Grid:
)" + grid +
         R"(  Boundary Conditions:
    bottom: {Face: y-, Components: y}
    top: {Face: y+, Components: y, Strain: 0.02}
  Loading: {Steps: 1}
  Output: {Pictures: false}
)";
}

const std::string slice = deck(
    "      Kind: Vessels\n      Size: [64, 64, 1]\n      Volume Fraction: 0.2\n      Seed: 5\n",
    "    \"Element Size [um]\": [4.0, 4.0, 1.0]\n    Plane Strain: true\n");
const std::string block = deck(
    "      Kind: Vessels\n      Size: [24, 24, 24]\n      Volume Fraction: 0.2\n      Seed: 5\n",
    "    \"Element Size [um]\": [4.0, 4.0, 4.0]\n");
const std::string uniform = deck("      Kind: Uniform\n      Size: [8, 8, 8]\n",
                                 "    \"Element Size [um]\": [4.0, 4.0, 4.0]\n");

/// The lines of the table, from "bounds" to the last modulus; empty if there is none.
std::string table_in(const std::string& text) {
  const std::size_t begin = text.find("\nbounds ");
  if (begin == std::string::npos) return "";
  std::size_t end = begin;
  for (int line = 0; line < 6; ++line) end = text.find('\n', end + 1);
  return text.substr(begin + 1, end - begin);
}

/// The figures in front of " %" in the row of a modulus.
std::vector<double> gains(const std::string& table, const std::string& modulus) {
  const std::size_t begin = table.find(modulus);
  EXPECT_NE(begin, std::string::npos) << table;
  if (begin == std::string::npos) return {};
  std::istringstream row(table.substr(begin, table.find('\n', begin) - begin));
  std::vector<double> result;
  for (std::string word, before; row >> word; before = word)
    if (word == "%") result.push_back(std::stod(before));
  return result;
}

TEST(BoundsPrinted, ByCheckAndRunAlike) {
  const TemporaryFolder folder;
  folder.write("slice.yaml", slice);
  const Outcome check = run_stroma(folder.path(), "check slice.yaml");
  const Outcome run = run_stroma(folder.path(), "run slice.yaml -o out");
  ASSERT_EQ(check.status, 0) << check.standard_error;
  ASSERT_EQ(run.status, 0) << run.standard_error;
  const std::string table = table_in(check.standard_output);
  for (const char* word : {"in plane strain", "gain over collagen", "Reuss", "Hashin-Shtrikman",
                           "Voigt", "shear mu", "plane bulk k", "between rollers E'"})
    EXPECT_NE(table.find(word), std::string::npos) << word << " in\n" << check.standard_output;
  EXPECT_EQ(table_in(run.standard_output), table);
  EXPECT_EQ(table_in(content_of(folder / "out/log.txt")), table);
  EXPECT_EQ(table_in(run_stroma(folder.path(), "check slice.yaml", 2).standard_output), table);
  EXPECT_EQ(table_in(run_stroma(folder.path(), "run slice.yaml -o two", 2).standard_output), table);

  // Both moduli doubled at a fraction f: Reuss gains 1 / (1 - f/2) - 1, Voigt f.
  const std::size_t at = check.standard_output.find("label 1: ");
  ASSERT_NE(at, std::string::npos);
  const double f = std::stod(check.standard_output.substr(at + 9));
  EXPECT_NEAR(f, 0.2, 0.01);
  for (const char* modulus : {"shear mu", "plane bulk k", "between rollers E'"}) {
    const auto gain = gains(table, modulus);
    ASSERT_EQ(gain.size(), 4u) << table;
    EXPECT_NEAR(gain[0], 100.0 * (1.0 / (1.0 - 0.5 * f) - 1.0), 0.006);
    EXPECT_NEAR(gain[3], 100.0 * f, 0.006);
    EXPECT_GT(gain[1], gain[0]);
    EXPECT_GT(gain[2], gain[1]);
    EXPECT_LT(gain[2], gain[3]);
  }

  // The measured gain of the force lies between Reuss and Voigt; 2 % strain changes little of it.
  const Outcome alone =
      run_stroma(folder.path(),
                 "run slice.yaml -o alone --set='Materials|vessel|Shear Modulus [Pa]=520.8' "
                 "--set='Materials|vessel|Bulk Modulus [Pa]=1041.6'");
  ASSERT_EQ(alone.status, 0) << alone.standard_error;
  const History with(folder / "out/history.csv"), without(folder / "alone/history.csv");
  const double measured =
      100.0 * (with["top.reaction_y"].back() / without["top.reaction_y"].back() - 1.0);
  EXPECT_GT(measured, gains(table, "between rollers E'")[0]);
  EXPECT_LT(measured, gains(table, "between rollers E'")[3]);
  for (const double gain : gains(table_in(alone.standard_output), "shear mu"))
    EXPECT_EQ(gain, 0.0);  // two materials, but alike
}

TEST(BoundsPrinted, InSpaceForABlock) {
  const TemporaryFolder folder;
  folder.write("block.yaml", block);
  const Outcome check = run_stroma(folder.path(), "check block.yaml");
  ASSERT_EQ(check.status, 0) << check.standard_error;
  const std::string table = table_in(check.standard_output);
  EXPECT_NE(table.find("in space"), std::string::npos) << check.standard_output;
  EXPECT_EQ(gains(table, "Young's E").size(), 4u);
}

TEST(BoundsPrinted, OnlyWhereTwoMaterialsAreInTheImage) {
  const TemporaryFolder folder;
  folder.write("uniform.yaml", uniform);
  for (const char* command : {"check uniform.yaml", "run uniform.yaml"}) {
    const Outcome outcome = run_stroma(folder.path(), command);
    ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
    EXPECT_EQ(outcome.standard_output.find("Voigt"), std::string::npos) << outcome.standard_output;
  }
}

// A pressure is no solid: the table is that of a lumen which is empty.
TEST(BoundsPrinted, OfTheSolidAroundAPressure) {
  const TemporaryFolder folder;
  const auto table = [&](const std::string& lumen, const std::string& material) {
    std::string text = deck(
        "      Kind: Shapes\n      Size: [16, 16, 16]\n      Shapes:\n"
        "        wall: {Kind: Cylinder, Label: 1, \"Center [um]\": [8, 8, 8], Axis: [0, 0, 1], "
        "\"Radius [um]\": 6}\n"
        "        lumen: {Kind: Cylinder, Label: " +
            lumen + ", \"Center [um]\": [8, 8, 8], Axis: [0, 0, 1], \"Radius [um]\": 3}\n",
        "    \"Element Size [um]\": [2.0, 2.0, 2.0]\n");
    text.insert(text.find("  Grid:"), material);
    folder.write("lumen.yaml", text);
    const Outcome check = run_stroma(folder.path(), "check lumen.yaml");
    EXPECT_EQ(check.status, 0) << check.standard_error;
    return table_in(check.standard_output);
  };
  const std::string pressed =
      table("2",
            "    lumen: {Label: 2, Model: Pressure, \"Pressure [Pa]\": 100, "
            "\"Shear Modulus [Pa]\": 0.1}\n");
  const std::string empty = table("-1", "");
  EXPECT_NE(pressed.find("of the solid; pressures and empty space not counted"), std::string::npos)
      << pressed;
  const std::string modulus = "shear mu";
  ASSERT_NE(empty.find(modulus), std::string::npos) << empty;
  EXPECT_EQ(pressed.substr(pressed.find(modulus)), empty.substr(empty.find(modulus)));
}

}  // namespace
}  // namespace stroma::test
