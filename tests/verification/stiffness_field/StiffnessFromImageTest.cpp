// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Stiffness by the intensity of the image, from the deck to the files, as a user runs it. Claim
/// V-FIELD-3, docs/verification.md.

#include <cmath>

#include "support/ExodusReader.hpp"
#include "support/WriteStack.hpp"

namespace stroma::test {
namespace {

/// Intensity of voxel (i, j, k): a bar of 200, and 40 beside it.
int bar(int i, int /*j*/, int k) { return i >= 3 && i < 9 && k >= 2 && k < 8 ? 200 : 40; }
/// Intensities from 0 to 240.
int ramp(int i, int j, int k) { return 8 * i + 4 * j + 4 * k; }

constexpr std::array<int, 3> size{16, 20, 12};

std::string deck(const std::string& threshold, const std::string& materials) {
  return R"(Stroma:
  Image:
    File: gel.mhd
    Voxel Size [um]: [1.05, 1.05, 1.0]
    Segmentation:
      Method: Threshold
      Threshold: )" +
         threshold + R"(
  Materials:
    gel:
      Label: 0
      Model: Coupled Neo-Hookean
      Shear Modulus [Pa]: 520.8
      Poisson Ratio: 0.4
)" + materials +
         R"(  Grid:
    Element Size [um]: [2.1, 2.1, 2.0]
    Reset: true
  Boundary Conditions:
    bottom:
      Face: y-
      Components: xyz
    top:
      Face: y+
      Components: xyz
      Displacement [um]: [1.3, 2.2, 0.7]
  Loading:
    Steps: 3
  Output:
    Pictures: false
)";
}

std::string field(const std::string& intensities, const std::string& values) {
  return R"(      Fields:
        stiffness:
          Parameter: Shear Modulus [Pa]
          Intensities: )" +
         intensities + "\n          Values: " + values + "\n";
}

const std::string vessel = R"(    vessel:
      Label: 1
      Model: Coupled Neo-Hookean
      Shear Modulus [Pa]: 1041.6
      Poisson Ratio: 0.4
)";

// V-FIELD-3. The same bits: one material with a field of two values, twice one the other, and two
// materials, with reset; on two ranks, too.
TEST(StiffnessFromImage, IsTwoMaterials) {
  const TemporaryFolder folder;
  write_stack<std::uint8_t>(folder, "gel", size, bar);
  for (const int ranks : {1, 2}) {
    const History by_field =
        run_deck(folder, "field", deck("1000", field("[40, 200]", "[520.8, 1041.6]")), ranks);
    const History labels = run_deck(folder, "labels", deck("100", vessel), ranks);
    for (const char* column : {"strain_energy", "bottom.reaction_x", "bottom.reaction_y",
                               "bottom.reaction_z", "newton_iterations", "residual"})
      EXPECT_EQ(by_field[column], labels[column]) << column;
    EXPECT_GT(std::abs(by_field["top.reaction_y"].back()), 1e4);
  }
}

// V-FIELD-3. particles.e shows the modulus that the map gives for the particle's voxel, in all
// steps, wherever the particle has gone: linear between three points, constant beyond them.
TEST(StiffnessFromImage, IsTheMapOfTheVoxelsIntensity) {
  const TemporaryFolder folder;
  write_stack<std::uint8_t>(folder, "gel", size, ramp);
  for (const int ranks : {1, 2}) {
    run_deck(folder, "ramp", deck("1000", field("[30, 80, 200]", "[200, 450, 2000]")), ranks);
    std::int64_t particles = 0;
    for (int rank = 0; rank < ranks; ++rank) {
      const std::string part = "." + std::to_string(ranks) + "." + std::to_string(rank);
      const ExodusReader file(
          (folder.path() / "ramp" / ("particles.e" + (ranks > 1 ? part : ""))).string());
      ASSERT_EQ(file.steps(), 4);
      const auto numbers = file.numbers(EX_ELEM_MAP);
      for (const int step : {1, 4}) {
        const auto mu = file.variable(step, EX_ELEM_BLOCK, "shear_modulus", 1,
                                      static_cast<std::int64_t>(numbers.size()));
        for (std::size_t e = 0; e < numbers.size(); ++e) {
          const auto id = static_cast<int>(numbers[e] - 1);  // one particle a voxel, x fastest
          const double intensity = ramp(id % 16, id / 16 % 20, id / 320);
          const double expected = intensity <= 30    ? 200.0
                                  : intensity <= 80  ? 200.0 + 5.0 * (intensity - 30.0)
                                  : intensity <= 200 ? 450.0 + 1550.0 / 120.0 * (intensity - 80.0)
                                                     : 2000.0;
          EXPECT_NEAR(mu[e], expected, 1e-12 * expected);
        }
      }
      particles += static_cast<std::int64_t>(numbers.size());
    }
    EXPECT_EQ(particles, 16 * 20 * 12);
  }
}

}  // namespace
}  // namespace stroma::test
