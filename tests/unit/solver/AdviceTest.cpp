/// \file
/// What a run that did not get on is told to try, by what is known of it: a test for each reason.

#include <gtest/gtest.h>

#include "solver/Advice.hpp"

namespace stroma::solver {
namespace {

/// The first piece of advice of `count`; the last of them is always the same.
void expect_first(const Circumstances& known, std::size_t count,
                  const std::vector<std::string>& told) {
  const std::vector<std::string> all = advice(known);
  ASSERT_EQ(all.size(), count);
  for (const std::string& text : told)
    EXPECT_NE(all.front().find(text), std::string::npos) << all.front();
  EXPECT_NE(all.back().find("a smaller load"), std::string::npos) << all.back();
}

TEST(Advice, NothingKnownAsksForSmallerSteps) { expect_first({}, 1, {"Loading|Smallest Step"}); }

TEST(Advice, BarelyFilledElementsAskForStabilization) {
  Circumstances known;
  known.barely_filled = 0.125;
  expect_first(known, 2, {"12 % of the elements", "Grid|Stabilization = "});
  known.stabilization = 1e-4;
  expect_first(known, 2, {"larger Grid|Stabilization"});
}

TEST(Advice, ContrastAsksForAnotherPreconditioner) {
  Circumstances known;
  known.contrast = 1e6;
  expect_first(known, 1, {});
  known.contrast = 2e7;
  expect_first(known, 2, {"2e+07", "Solver|Preconditioner = Multigrid"});
  known.preconditioner = PreconditionerKind::multigrid;
  expect_first(known, 1, {});
}

TEST(Advice, NearlyIncompressibleMaterialsAskForMeanDilatation) {
  Circumstances known;
  known.largest_poisson_ratio = 0.4999;
  expect_first(known, 2, {"0.4999", "Grid|Dilatation = Element Mean"});
  known.has_pointwise_dilatation = false;
  expect_first(known, 1, {});
}

TEST(Advice, FreeMotionsAskForASupport) {
  Circumstances known;
  known.has_free_motion = true;
  expect_first(known, 2, {"a support"});
}

TEST(Advice, PiecesAskForSupports) {
  Circumstances known;
  known.pieces = 3;
  expect_first(known, 2, {"3 pieces"});
}

}  // namespace
}  // namespace stroma::solver
