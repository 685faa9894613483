// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The relaxing body of case T1 on a grid that is reset. Claim V-VISC-4, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "ReferenceCase.hpp"

namespace stroma::test {
namespace {

// V-VISC-4. GIMP; nodes hold both faces.
TEST(RelaxationWithReset, HasTheForceOfThatWithout) {
  const ReferenceCase reference("T1_viscoelastic_ramp_hold");
  const TemporaryFolder folder;
  const fs::path deck = reference.write_deck(folder);
  const auto force = [&](const std::string& name, const std::string& reset, int ranks) {
    const Outcome outcome = run_stroma(
        folder.path(),
        "run " + quoted(deck) + " -o " + name +
            " --quiet --set 'Solver|Preconditioner=Direct' --set 'Grid|Shape Functions=GIMP'"
            " --set 'Grid|Reset=" +
            reset + "'",
        ranks);
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    return History(folder.path() / name / "history.csv")["top.reaction_y"];
  };
  const std::vector<double> without = force("without", "false", 1), with = force("with", "true", 1),
                            on_two = force("two", "true", 2);
  const auto& steps = reference.results().at("steps");
  ASSERT_EQ(without.size(), steps.size() + 1);
  ASSERT_EQ(with.size(), without.size());
  ASSERT_EQ(on_two.size(), without.size());
  double departure = 0.0, of_reference = 0.0, of_ranks = 0.0;
  for (std::size_t s = 1; s < without.size(); ++s) {
    const double independent = steps[s - 1].at("F_y1").at(1).get<double>();
    departure = std::max(departure, std::abs(with[s] / without[s] - 1.0));
    of_reference = std::max(of_reference, std::abs(with[s] / independent - 1.0));
    of_ranks = std::max(of_ranks, std::abs(on_two[s] / with[s] - 1.0));
  }
  EXPECT_LT(departure, 0.004);
  EXPECT_LT(of_reference, 0.004);
  EXPECT_LT(of_ranks, 1e-8);
  std::printf("  within %.3f %% of that without, %.3f %% of the reference; on two ranks %.1e\n",
              100.0 * departure, 100.0 * of_reference, of_ranks);
}

}  // namespace
}  // namespace stroma::test
