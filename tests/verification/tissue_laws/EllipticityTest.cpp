// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A run whose material loses ellipticity, and goes on, says so. Claim V-ELL-3, docs/verification.md.

#include <gtest/gtest.h>

#include "support/Program.hpp"

namespace stroma::test {
namespace {

/// The log of a block of a coupled neo-Hookean solid that is stretched all around, by 10 % a step.
std::string log_of(int steps) {
  const std::string g = std::to_string(0.1 * steps);
  const TemporaryFolder folder;
  folder.write(
      "deck.yaml",
      "Stroma:\n"
      "  Image: {Phantom: {Kind: Uniform, Size: [4, 4, 4], 'Voxel Size [um]': [1, 1, 1]}}\n"
      "  Materials:\n"
      "    gel: {Label: 0, Model: Coupled Neo-Hookean, 'Shear Modulus [Pa]': 100,\n"
      "      'Lame Modulus [Pa]': 1000}\n"
      "  Grid: {Elements: [2, 2, 2]}\n"
      "  Solver: {Preconditioner: Direct}\n"
      "  Output: {Pictures: false, Particles Every: 0, Grid Every: 0}\n"
      "  Boundary Conditions:\n"
      "    wall: {Face: all, Components: xyz,\n"
      "      Displacement Gradient: [" +
          g + ", 0, 0, 0, " + g + ", 0, 0, 0, " + g +
          "]}\n"
          "  Loading: {Steps: " +
          std::to_string(steps) + "}\n");
  const Outcome outcome = run_stroma(folder.path(), "run deck.yaml --quiet -o out");
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
  return content_of(folder.path() / "out" / "log.txt");
}

// V-ELL-3. A wave's least modulus is lambda + mu + mu s^2 - 3 lambda ln s, with s the stretch: 109 Pa
// at 1.5, -54.01 Pa at 1.6.
TEST(Ellipticity, IsToldWhereItIsLost) {
  EXPECT_EQ(log_of(5).find("lost ellipticity"), std::string::npos);
  const std::string log = log_of(6);
  for (const char* words : {"at load 1 the body has lost ellipticity: 64 particles, ",
                            "material \"gel\", at (", "has a modulus of -54.01 Pa"})
    EXPECT_NE(log.find(words), std::string::npos) << log;
}

}  // namespace
}  // namespace stroma::test
