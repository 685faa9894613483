// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The fictitious material of barely filled elements: what it cures and what it costs. Claims
/// V-STAB-1 and V-STAB-2, docs/verification.md.

#include <gtest/gtest.h>

#include "stroma/base/Error.hpp"
#include "support/LoadSteps.hpp"
#include "support/ShiftedBody.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using test::Specimen;

/// A block whose outermost particles have just crossed into another layer of elements, by a share
/// of an element along x, y and z: its corner nodes feel one particle, by the cube of that share.
/// (Grips at two of its sides keep the lattice from being fitted to them.)
/// Returns the force [pN].
double pull(double share, double stabilization, int steps, double strain = 0.02) {
  Specimen specimen;
  specimen.reset = true;
  specimen.layout = {particles::Layout::per_element, 1, 2};
  specimen.elements = {8, 6, 8};
  specimen.stabilization = stabilization;
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")},
                         {"top", test::hold(Face::y_upper, "xyz")},
                         {"side", test::hold(Face::x_upper, "x")},
                         {"back", test::hold(Face::z_upper, "z")}};
  specimen.conditions[1].second.displacement = {0.0, strain * 6 * 2.1, 0.0};
  for (auto& named : specimen.conditions) named.second.imposed_by = mechanics::ImposedBy::grip;
  std::array<double, 3> shift;
  for (std::size_t d = 0; d < 3; ++d) shift[d] = (0.25 + share) * specimen.spacing[d];
  mechanics::MovingBody body = test::shifted_body(world(), specimen, shift);
  solver::SolverParameters parameters;
  parameters.preconditioner = solver::PreconditionerKind::jacobi;
  parameters.linear_tolerance = 1e-8;
  parameters.newton_tolerance = 1e-10;
  double force = 0.0;
  test::take_steps(body, steps, parameters,
                   [&](double, const grid::Vector& u) { force = test::reactions(body, u)[1][1]; });
  return force;
}

// V-STAB-1. A particle alone in a corner, under the compression that crossing an element leaves
// behind, makes the tangent indefinite, however small the step. The fictitious material holds its
// nodes.
TEST(Stabilization, HoldsNodesThatTheBodyBarelyTouches) {
  EXPECT_THROW(pull(0.01, 0.0, 10, -0.3), base::StepRejected);
  EXPECT_LT(pull(0.01, 0.01, 10, -0.3), 0.0);
}

// V-STAB-2. Its effect on a force that can be had without it is in proportion to its strength, and
// at the default strength below 2e-4 of the force, for a body of 8 x 6 x 8 elements all of whose
// sides are barely filled; it falls with the number of elements and of steps.
TEST(Stabilization, HasASmallEffectInProportion) {
  const double plain = pull(0.3, 0.0, 5);
  const double effect = pull(0.3, 0.01, 5) / plain - 1.0;
  const double tenth = pull(0.3, 0.001, 5) / plain - 1.0;
  if (world().is_root()) std::printf("  effect on the force: %.2e\n", effect);
  EXPECT_GT(effect, 0.0);
  EXPECT_LT(effect, 2e-4);
  EXPECT_NEAR(10.0 * tenth, effect, 0.05 * effect);
}

}  // namespace
}  // namespace stroma
