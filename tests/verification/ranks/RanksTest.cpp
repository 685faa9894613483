// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A vascularised block on 1, 2 and 4 ranks: the same iterations, the same forces. Claim V-RANKS,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/VesselBlock.hpp"

namespace stroma::test {
namespace {

const std::string deck = vessel_block("32, 40, 24") + clamped_stretch() + R"(  Loading:
    Steps: 4
  Solver:
    Newton Tolerance: 1.0e-8
    Linear Tolerance: 1.0e-6
  Output:
    Particles Every: 0
    Grid Every: 0
)";

/// The same deck on 1, 2 and 4 ranks: figures agree to 1e-10, and so do the iterations, but for
/// what rounding does to the last of them.
void expect_the_same(const std::string& settings) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("block.yaml", deck);
  std::vector<History> histories;
  for (const int ranks : {1, 2, 4}) {
    const std::string out = "out" + std::to_string(ranks);
    const Outcome outcome = run_stroma(
        folder.path(), "run " + quoted(path) + " -o " + out + " --quiet " + settings, ranks);
    ASSERT_EQ(outcome.status, 0) << ranks << " ranks: " << outcome.standard_error;
    histories.emplace_back(folder.path() / out / "history.csv");
    ASSERT_EQ(histories.back().rows(), 5u);
  }
  const History& one = histories[0];
  for (std::size_t h = 1; h < histories.size(); ++h) {
    const History& several = histories[h];
    ASSERT_EQ(several.names(), one.names());
    double worst = 0.0;
    for (std::size_t s = 1; s < 5; ++s) {
      EXPECT_EQ(several["newton_iterations"][s], one["newton_iterations"][s]) << "step " << s;
      EXPECT_NEAR(several["linear_iterations"][s], one["linear_iterations"][s], 1) << "step " << s;
      const double force = std::abs(one["top.reaction_y"][s]);
      EXPECT_GT(force, 0.0);
      for (const char* face : {"top", "bottom"})
        for (const char* axis : {"x", "y", "z"}) {
          const std::string name = std::string(face) + ".reaction_" + axis;
          worst = std::max(worst, std::abs(several[name][s] - one[name][s]) / force);
        }
      for (const char* name : {"strain_energy", "collagen.volume", "vessel.volume",
                               "collagen.von_mises_mean", "vessel.von_mises_max"})
        worst = std::max(worst, std::abs(several[name][s] / one[name][s] - 1.0));
    }
    EXPECT_LT(worst, 1e-10);
    std::printf("  %d ranks: within %.1e of one rank\n", h == 1 ? 2 : 4, worst);
  }
}

TEST(Ranks, DoNotChangeTheAnswer) { expect_the_same(""); }

// Conjugate gradients amplify rounding, which differs with the order of sums: of the 400 iterations
// of a step (three solves), one more or less is rounding. Not with adaptive forcing, whose next
// tolerance depends on what such a solve happens to leave.
TEST(Ranks, DoNotChangeTheAnswerOfJacobi) {
  expect_the_same("--set 'Solver|Preconditioner=Jacobi' --set 'Solver|Forcing=Constant'");
}

TEST(Ranks, DoNotChangeTheAnswerWithReset) {
  expect_the_same("--set 'Grid|Reset=true' --set 'Solver|Linear Tolerance=1e-8'");
}

// Claim V-SOLVERS: whatever solves the linear systems, and however well, the converged step is one.
TEST(Solvers, DoNotChangeTheAnswer) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("block.yaml", deck);
  std::vector<History> histories;
  for (const char* settings :
       {"Solver|Preconditioner=Jacobi' --set 'Solver|Forcing=Constant",
        "Solver|Preconditioner=Geometric Multigrid", "Solver|Preconditioner=Multigrid"}) {
    const Outcome outcome = run_stroma(
        folder.path(), "run " + quoted(path) + " -o out --quiet --set '" + settings + "'");
    ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
    histories.emplace_back(folder.path() / "out" / "history.csv");
  }
  for (std::size_t h = 1; h < histories.size(); ++h)
    for (std::size_t s = 1; s < 5; ++s)
      for (const char* name : {"top.reaction_y", "bottom.reaction_y", "strain_energy"})
        EXPECT_NEAR(histories[h][name][s], histories[0][name][s],
                    1e-7 * std::abs(histories[0][name][s]))
            << name << ", step " << s;
}

}  // namespace
}  // namespace stroma::test
