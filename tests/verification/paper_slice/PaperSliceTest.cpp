// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The paper's own slice (512 x 512 pixels, plane strain, rollers, 10 %) against the independent
/// solution of tests/data/reference/slice25.md, to 1e-6. Claim V-SLICE, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

struct SliceCase {
  const char* name;
  int pixels;                                                 ///< side of an element
  double collagen_mu, collagen_bulk, vessel_mu, vessel_bulk;  ///< [Pa]
  double force;                                               ///< on the top at 10 % [pN]
};

// Moduli A: nu = 0.4; B: K = 2 mu. Vessels have twice both, but for the last two.
constexpr double mu = 520.8, bulk_a = 2430.4, bulk_b = 1041.6;
const SliceCase cases[] = {
    {"B_8_pixels", 8, mu, bulk_b, 2 * mu, 2 * bulk_b, 79437.33},
    {"B_4_pixels", 4, mu, bulk_b, 2 * mu, 2 * bulk_b, 79045.12},
    {"A_8_pixels", 8, mu, bulk_a, 2 * mu, 2 * bulk_a, 94462.30},
    {"A_4_pixels", 4, mu, bulk_a, 2 * mu, 2 * bulk_a, 93987.63},
    {"B_collagen_only", 8, mu, bulk_b, mu, bulk_b, 69420.12},
    {"A_collagen_only", 8, mu, bulk_a, mu, bulk_a, 82222.40},
    {"A_vessels_1.5_times", 4, mu, bulk_a, 1.5 * mu, 1.5 * bulk_a, 88912.30},
    {"A_vessels_mu_only", 4, mu, bulk_a, 2 * mu, bulk_a, 92132.98},
};

fs::path slice() { return clone_folder() / "tests" / "data" / "images" / "slice25_vessels.tif"; }

std::string deck_of(const SliceCase& c) {
  std::ostringstream text;
  text.precision(17);
  const auto material = [&](const char* name, int label, double shear, double bulk) {
    text << "  " << name << ":\n    Label: " << label << "\n    Shear Modulus [Pa]: " << shear
         << "\n    Bulk Modulus [Pa]: " << bulk << "\n";
  };
  text << "Stroma:\n Image:\n  File: " << slice().string()
       << "\n  Segmentation:\n    Method: Threshold\n    Threshold: 128.0\n Materials:\n";
  material("collagen", 0, c.collagen_mu, c.collagen_bulk);
  material("vessel", 1, c.vessel_mu, c.vessel_bulk);
  text << " Particles:\n  Layout: Voxel Centers\n Grid:\n  Elements: [" << 512 / c.pixels << ", "
       << 512 / c.pixels << ", 1]\n  Plane Strain: true\n"
       << " Boundary Conditions:\n"
          "  bottom:\n    Face: y-\n    Components: y\n"
          "  top:\n    Face: y+\n    Components: y\n    Strain: 0.1\n"
          " Loading:\n  Steps: 2\n"
          " Solver:\n  Newton Tolerance: 1.0e-8\n"
          " Output:\n  Particles Every: 0\n  Grid Every: 0\n";
  return text.str();
}

class PaperSlice : public ::testing::TestWithParam<SliceCase> {};

TEST_P(PaperSlice, HasTheReferencesForce) {
  const TemporaryFolder folder;
  const fs::path deck = folder.write("slice.yaml", deck_of(GetParam()));
  const Outcome outcome = run_stroma(folder.path(), "run " + quoted(deck) + " -o out --quiet", 2);
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  const History history(folder.path() / "out" / "history.csv");
  const double force = history["top.reaction_y"].back();
  EXPECT_NEAR(force, GetParam().force, 1e-6 * GetParam().force);
  EXPECT_NEAR(history["bottom.reaction_y"].back(), -force, 1e-8 * force);
  std::printf("  force %.2f pN, reference %.2f: off by %.1e\n", force, GetParam().force,
              force / GetParam().force - 1.0);
}

INSTANTIATE_TEST_SUITE_P(Data, PaperSlice, ::testing::ValuesIn(cases), [](const auto& slice_case) {
  std::string name = slice_case.param.name;
  for (char& c : name) c = c == '.' ? '_' : c;
  return name;
});

}  // namespace
}  // namespace stroma::test
