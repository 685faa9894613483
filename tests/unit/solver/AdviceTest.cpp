// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What a run whose steps fail is told to try, and what is known of it.

#include <gtest/gtest.h>

#include "stroma/solver/Advice.hpp"
#include "support/Specimen.hpp"

namespace stroma::solver {
namespace {

/// Expects `told` in the first of `count` pieces of advice; the last is always the same.
void expect_first(const Circumstances& known, std::size_t count, const std::string& told) {
  const std::vector<std::string> all = advice(known);
  ASSERT_EQ(all.size(), count);
  EXPECT_NE(all.front().find(told), std::string::npos) << all.front();
  EXPECT_NE(all.back().find("a smaller load"), std::string::npos) << all.back();
}

TEST(Advice, NothingKnownAsksForSmallerSteps) { expect_first({}, 1, "Loading|Smallest Step"); }

TEST(Advice, BarelyFilledElementsAskForStabilization) {
  Circumstances known;
  known.barely_filled = 12;
  expect_first(known, 2, "12 elements are filled by less than half: Grid|Stabilization = 1e-4");
  known.stabilization = 2e-5;
  expect_first(known, 2, "a larger Grid|Stabilization (now 2e-05)");
}

// V-ADVICE.
TEST(Advice, ContrastAsksForDoublePrecision) {
  Circumstances known;
  known.contrast = 2e7;
  expect_first(known, 2, "2e+07 times stiffer than the softest, and errors of rounding grow");
  known.is_single_precision = true;
  expect_first(known, 2, "2e+07 times stiffer");
  expect_first(known, 2, "Solver|Preconditioner = Multigrid");
  known.contrast = 1e6;
  EXPECT_EQ(contrast_note(known), "");
  expect_first(known, 2, "an edge or a corner: Solver|Preconditioner = Multigrid");
}

TEST(Advice, IncompressibilityAsksForASmallerPoissonRatio) {
  Circumstances known;
  known.incompressibility = 5e6;
  expect_first(known, 2,
               "a bulk modulus is 5e+06 times the shear modulus (Poisson's ratio 0.4999999)");
  known.incompressibility = 9e4;
  expect_first(known, 1, "");
}

TEST(Advice, LockingAsksForItsCure) {
  Circumstances known;
  known.locking = "Element Mean cures it";
  expect_first(known, 2, known.locking);
}

TEST(Advice, FreeMotionsAskForSupports) {
  Circumstances known;
  known.pieces = 3;
  expect_first(known, 1, "");
  known.has_free_motion = true;
  expect_first(known, 2, "a support for each of the body's 3 pieces");
  known.pieces = 1;
  expect_first(known, 2, "a support against it");
}

TEST(Advice, IsGivenByWhatTheBodyIs) {
  const auto world = base::Communicator::world();
  test::Specimen specimen;
  specimen.voxels_per_element = {2, 2, 2};
  specimen.layout = {particles::Layout::voxel_centers, 1, 2};
  // The second row of elements along x holds one particle of eight; a stiff one lies elsewhere.
  specimen.label = [](const grid::Index3& v) {
    if (v[0] == 2 || v[0] == 3) return v[0] == 2 && v[1] % 2 == 0 && v[2] % 2 == 0 ? 0 : -1;
    return v == grid::Index3{0, 0, 0} ? 1 : 0;
  };
  specimen.laws = {{500.0, 2000.0}, {1.5e10, 6e10}, {1e30, 1e30}};  // nothing is of the third
  specimen.conditions = {{"bottom", test::hold(mechanics::Face::y_lower, "y")},
                         {"top", test::stretch(mechanics::Face::y_upper, "y", 0.1)}};
  specimen.stabilization = 1e-4;
  const auto balance = specimen.balance(world);
  SolverParameters solver;
  mechanics::GridParameters grid;
  grid.dilatation = mechanics::DilatationChoice::pointwise;
  const Circumstances known = circumstances(solver, grid, {0.49}, *balance);
  EXPECT_DOUBLE_EQ(known.contrast, 3e7);
  EXPECT_TRUE(known.is_single_precision);
  EXPECT_EQ(known.barely_filled, 16);
  EXPECT_EQ(known.stabilization, 1e-4);
  EXPECT_NE(known.locking.find("0.49"), std::string::npos) << known.locking;
  EXPECT_EQ(known.pieces, 1);
  EXPECT_TRUE(known.has_free_motion);

  solver.preconditioner = PreconditionerKind::multigrid;
  EXPECT_FALSE(circumstances(solver, {}, {0.4}, *balance).is_single_precision);
  EXPECT_EQ(circumstances(solver, {}, {0.4}, *balance).locking, "");
}

}  // namespace
}  // namespace stroma::solver
