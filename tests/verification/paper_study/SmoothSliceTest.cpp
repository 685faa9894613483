// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The paper's slice on a grid that is reset, with shape functions that cure the artefact of
/// crossing, on members of input_decks/08_smooth_shapes, on the paper's own slice. Claims V-STUDY-4
/// and V-STUDY-5, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/Places.hpp"
#include "support/VesselBlock.hpp"

namespace stroma::test {
namespace {

const fs::path deck = clone_folder() / "input_decks" / "08_smooth_shapes" / "deck.xml";

/// A folder for the runs.
class SmoothSlice : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { folder_ = new TemporaryFolder; }
  static void TearDownTestSuite() { delete folder_; }

  /// Five steps to full load with elements of 8 pixels, 64 particles each.
  static History run(const std::string& shape_functions, bool reset, bool collagen_only,
                     bool grips = false) {
    std::string arguments = "run " + quoted(deck) + " -o out --quiet" +
                            " --set 'Output|Pictures=false' --set 'Loading|Steps=5'";
    arguments += " --set 'Grid|Shape Functions=" + shape_functions + "'";
    arguments += std::string(" --set 'Grid|Reset=") + (reset ? "true'" : "false'");
    if (grips)
      arguments +=
          " --set 'Boundary Conditions|bottom|Imposed By=Grip'"
          " --set 'Boundary Conditions|top|Imposed By=Grip'";
    if (collagen_only)
      arguments +=
          " --set 'Materials|vessel|Shear Modulus [Pa]=520.8'"
          " --set 'Materials|vessel|Bulk Modulus [Pa]=1041.6'";
    const Outcome outcome = run_stroma(folder_->path(), arguments, 2);
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    return History(*folder_ / "out" / "history.csv");
  }

 private:
  static TemporaryFolder* folder_;
};

TemporaryFolder* SmoothSlice::folder_ = nullptr;

/// Root mean square departure of the force on the top, relative to that at full load.
double departure(const History& with, const History& without) {
  const auto f = with["top.reaction_y"], g = without["top.reaction_y"];
  EXPECT_EQ(with["load"], without["load"]);
  double sum = 0.0;
  for (std::size_t s = 1; s < f.size(); ++s) sum += std::pow(f[s] - g[s], 2);
  return std::sqrt(sum / static_cast<double>(f.size() - 1)) / std::abs(g.back());
}

// V-STUDY-4. Between rollers on which the grid is laid, the force with reset is within 0.2 % of that
// without in every step.
TEST_F(SmoothSlice, ResettingHardlyChangesTheForce) {
  for (const std::string shape : {"GIMP", "Quadratic B-Spline"}) {
    const History with = run(shape, true, false), without = run(shape, false, false);
    const auto f = with["top.reaction_y"], g = without["top.reaction_y"];
    double largest = 0.0;
    for (std::size_t s = 1; s < f.size(); ++s)
      largest = std::max(largest, std::abs(f[s] - g[s]) / std::abs(g.back()));
    std::printf("  %-18s departure: rms %.4f, largest %.4f\n", shape.c_str(),
                departure(with, without), largest);
    EXPECT_LT(departure(with, without), 0.001);
    EXPECT_LT(largest, 0.002);
  }
}

// V-STUDY-5. Collagen alone is strained alike everywhere. On a lattice that stays where it is, as
// grips have it, stripes of stress stand with hats where particles have crossed; on one that ends
// where the body does there are none, whatever the functions.
TEST_F(SmoothSlice, HasNoStripes) {
  const auto unevenness = [](const std::string& shape, bool grips) {
    const History history = run(shape, true, true, grips);
    const double uneven =
        history["collagen.von_mises_max"].back() / history["collagen.von_mises_mean"].back() - 1.0;
    std::printf("  %-18s %-6s largest von Mises stress %.1e above the mean\n", shape.c_str(),
                grips ? "grips" : "nodes", uneven);
    return uneven;
  };
  EXPECT_GT(unevenness("Linear", true), 0.05);
  for (const std::string shape : {"Linear", "GIMP", "Quadratic B-Spline"})
    EXPECT_LT(unevenness(shape, false), 1e-5);
}

}  // namespace
}  // namespace stroma::test
