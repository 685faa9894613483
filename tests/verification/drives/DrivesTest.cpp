// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Blocks that contract and grow, through the program. Claims V-ACTIVE-2 and V-GROWTH-2,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "stroma/material/AnyLaw.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

constexpr double edge = 8.0;  // of the block [um]
const material::NeoHookean gel{520.8, 2430.4};

const std::string rollers =
    "    left: {Face: x-, Components: x, Imposed By: Nodes}\n"
    "    bottom: {Face: y-, Components: y, Imposed By: Nodes}\n"
    "    back: {Face: z-, Components: z, Imposed By: Nodes}\n";
const std::string held =
    "    bottom: {Face: y-, Components: y}\n"
    "    top: {Face: y+, Components: y}\n"
    "    left: {Face: x-, Components: x}\n"
    "    right: {Face: x+, Components: x}\n"
    "    back: {Face: z-, Components: z}\n"
    "    front: {Face: z+, Components: z}\n";

/// A block of gel, of which the material has these lists besides.
std::string deck(const std::string& drives, const std::string& conditions,
                 const std::string& grid = "") {
  return "Stroma:\n"
         "  Image:\n"
         "    Phantom:\n"
         "      Kind: Uniform\n"
         "      Size: [8, 8, 8]\n"
         "      Voxel Size [um]: [1, 1, 1]\n"
         "  Materials:\n"
         "    gel:\n"
         "      Label: 0\n"
         "      Shear Modulus [Pa]: 520.8\n"
         "      Bulk Modulus [Pa]: 2430.4\n" +
         drives +
         "  Grid:\n"
         "    Elements: [4, 4, 4]\n" +
         grid +
         "  Solver: {Newton Tolerance: 1e-11}\n"
         "  Output: {Pictures: false}\n"
         "  Boundary Conditions:\n" +
         conditions;
}

History run(const std::string& text, int ranks = 1) {
  const TemporaryFolder folder;
  std::ofstream(folder / "deck.yaml") << text;
  const Outcome outcome = run_stroma(folder.path(), "run deck.yaml --quiet -o out", ranks);
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
  return History(folder.path() / "out" / "history.csv");
}

/// The stretches along y and across it at which a law that contracts along y is free of stress, by
/// turns of bisection.
std::array<double, 2> free_stretches(const material::AnyLaw& law) {
  std::array<double, 2> stretch{1.0, 1.0};
  const auto stress = [&](std::size_t which, double value) {
    std::array<double, 2> at = stretch;
    at[which] = value;
    tensor::Tensor3 H;
    H(0, 0) = H(2, 2) = at[1] - 1.0;
    H(1, 1) = at[0] - 1.0;
    const tensor::Tensor3 tau = material::kirchhoff_stress(law, H);
    return which == 0 ? tau(1, 1) : tau(0, 0);
  };
  for (int turn = 0; turn < 200; ++turn)
    for (const std::size_t which : {0u, 1u}) {
      double low = 0.3, high = 3.0;
      for (int n = 0; n < 60; ++n) {
        const double middle = 0.5 * (low + high);
        (stress(which, middle) > 0.0 ? high : low) = middle;
      }
      stretch[which] = 0.5 * (low + high);
    }
  return stretch;
}

// V-ACTIVE-2.
TEST(ActiveStress, OfAFreeBlockContractsItAsTheLawSays) {
  const char* kinds[] = {"Isotropic", "Fiber", "Transverse"};
  for (int kind = 0; kind < 3; ++kind) {
    SCOPED_TRACE(kinds[kind]);
    const std::string direction = kind == 0 ? "" : ", Direction: [0, 2, 0]";
    for (const int ranks : {1, 2}) {
      const History history = run(deck(std::string("      Active Stress: {Kind: ") + kinds[kind] +
                                           ", 'T0 [Pa]': 300" + direction + "}\n",
                                       rollers) +
                                      "  Loading: {Steps: 4}\n",
                                  ranks);
      material::AnyLaw law = gel;
      law.set_active_stress(
          {300.0, static_cast<material::ActiveStress::Kind>(kind), {0.0, 1.0, 0.0}});
      for (std::size_t s = 0; s < history.rows(); ++s) {
        law.drive({history["load"][s], 0.0});
        const auto [along, across] = free_stretches(law);
        const double volume = edge * edge * edge;
        EXPECT_NEAR(history["gel.volume"][s], along * across * across * volume, 1e-8 * volume);
        EXPECT_NEAR(history["bottom.reaction_y"][s], 0.0, 1e-6);
      }
    }
  }
}

TEST(ActiveStress, OfAHeldBlockPullsItsSupports) {
  const History history =
      run(deck("      Active Stress: {'T0 [Pa]': 300, Load Curve: late}\n", held) +
          "  Load Curves:\n"
          "    late: {'Times [s]': [5, 10], Values: [0, 1]}\n"
          "  Loading: {'Duration [s]': 10, Steps: 4}\n");
  const double pull[] = {0.0, 0.0, 0.0, 0.5, 1.0};
  for (std::size_t s = 0; s < 5; ++s) {
    EXPECT_NEAR(history["top.reaction_y"][s], 300.0 * pull[s] * edge * edge, 1e-6) << s;
    EXPECT_NEAR(history["left.reaction_x"][s], -300.0 * pull[s] * edge * edge, 1e-6) << s;
  }
}

// V-GROWTH-2. To twice the volume, free of stress, in each kind; with reset, no particle is turned
// inside out, and what is left is rounding and the method's error of steps.
TEST(Growth, OfAFreeBlockIsFreeOfStress) {
  for (const char* kind : {"Volume", "Fiber, Direction: [0, 1, 0]", "Area, Direction: [0, 0, 3]"})
    for (const char* grid :
         {"", "    Reset: true\n", "    Reset: true\n    Shape Functions: GIMP\n"}) {
      SCOPED_TRACE(std::string(kind) + grid);
      const History history =
          run(deck(std::string("      Growth: {Ratio: 2, Kind: ") + kind + "}\n", rollers, grid) +
              "  Loading: {Steps: 8}\n");
      const double volume = edge * edge * edge;
      const bool is_exact = std::string(grid).empty();
      for (std::size_t s = 0; s < history.rows(); ++s) {
        EXPECT_NEAR(history["gel.volume"][s], (1.0 + history["load"][s]) * volume,
                    (is_exact ? 1e-9 : 2e-3) * volume);
        EXPECT_LT(history["gel.von_mises_max"][s], (is_exact ? 1e-6 : 0.02) * 520.8);
      }
    }
}

// A held block that grows presses on its supports as its law says.
TEST(Growth, OfAHeldBlockPresses) {
  const History history =
      run(deck("      Growth: {Ratio: 1.5}\n", held) + "  Loading: {Steps: 2}\n");
  for (const std::size_t s : {1u, 2u}) {
    const double g = 1.0 + 0.25 * static_cast<double>(s);
    const double pressure = g * 2430.4 * std::log(g);
    EXPECT_NEAR(history["bottom.reaction_y"][s], pressure * edge * edge, 1e-8 * pressure * 64.0);
  }
}

}  // namespace
}  // namespace stroma::test
