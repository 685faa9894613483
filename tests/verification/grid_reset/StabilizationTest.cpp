/// \file
/// The fictitious material of barely filled elements: what it cures and what it costs. Claims
/// V-STAB-1 and V-STAB-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "base/Error.hpp"
#include "mechanics/BarelyFilled.hpp"
#include "support/LoadSteps.hpp"
#include "support/ShiftedBody.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using test::Specimen;

base::Communicator world() { return base::Communicator::world(); }

/// A block whose outermost particles have just crossed into another layer of elements, by a share
/// of an element along x, y and z: its corner nodes feel one particle, by the cube of that share.
/// Returns the force at 2 % of stretch [pN].
double pull(double share, double stabilization, int steps) {
  Specimen specimen;
  specimen.reset = true;
  specimen.layout = {particles::Layout::per_element, 1, 2};
  specimen.elements = {8, 6, 8};
  specimen.stabilization = stabilization;
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")},
                         {"top", test::hold(Face::y_upper, "xyz")}};
  specimen.conditions[1].second.displacement = {0.0, 0.02 * 6 * 2.1, 0.0};
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
  EXPECT_THROW(pull(0.01, 0.0, 5), base::StepRejected);
  EXPECT_GT(pull(0.01, 0.01, 5), 0.0);
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

/// A block with a round hole through it, at 0.1 % of stretch: force [pN], and what the run says
/// that stabilisation adds.
std::pair<double, double> pull_holed(std::int64_t elements, double stabilization) {
  Specimen specimen;
  specimen.layout = {particles::Layout::voxel_centers, 1, 2};
  specimen.elements = {elements, elements, elements};
  specimen.spacing = {8.0 / static_cast<double>(elements), 8.0 / static_cast<double>(elements),
                      8.0 / static_cast<double>(elements)};
  const double size = 2.0 * static_cast<double>(elements);
  specimen.label = [size](const grid::Index3& voxel) {
    double square = 0.0;
    for (std::size_t d = 0; d < 2; ++d)
      square += std::pow((static_cast<double>(voxel[d]) + 0.5) / size - 0.5, 2);
    return square < 0.38 * 0.38 ? -1 : 0;
  };
  specimen.stabilization = stabilization;
  specimen.conditions = test::clamped(0.001);
  mechanics::MovingBody body = specimen.moving_body(world());
  solver::SolverParameters parameters;
  parameters.newton_tolerance = 1e-10;
  std::pair<double, double> result;
  test::take_steps(body, 1, parameters, [&](double, const grid::Vector& u) {
    result = {test::reactions(body, u)[1][1], mechanics::stabilization_share(body.balance(), u)};
  });
  return result;
}

// V-STAB-3. Without reset: what the run says that stabilisation adds is what it adds to the force,
// in proportion to its strength, and falls with the elements' size.
TEST(Stabilization, SaysWhatItAdds) {
  double before = 0.0;
  for (const std::int64_t elements : {8, 16}) {
    const double plain = pull_holed(elements, 0.0).first;
    const auto [force, said] = pull_holed(elements, 2e-5);
    const double effect = force / plain - 1.0;
    if (world().is_root()) std::printf("  %.2e of the force, said %.2e\n", effect, said);
    EXPECT_GT(said, 0.0);
    EXPECT_LT(said, 1e-3);
    EXPECT_NEAR(said, effect, 0.05 * effect);
    if (before > 0.0) EXPECT_LT(said, 0.7 * before);
    before = said;
  }
}

}  // namespace
}  // namespace stroma
