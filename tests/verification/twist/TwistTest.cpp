// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Faces that turn. Claims V-TWIST-1 and V-TWIST-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "stroma/base/Error.hpp"
#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using mechanics::ImposedBy;
using Vector3 = std::array<double, 3>;

mechanics::BoundaryCondition turn(Face face, double degrees, const Vector3& axis,
                                  const Vector3& center) {
  mechanics::BoundaryCondition condition = test::hold(face, "xyz");
  condition.rotation = degrees;
  condition.axis = axis;
  condition.center = center;
  return condition;
}

double energy(const mechanics::MovingBody& body, const grid::Vector& u) {
  const auto fields = body.balance().body().particle_fields(u);
  const auto& particles = body.balance().body().particles();
  double sum = 0.0;
  for (int p = 0; p < particles.count(); ++p) sum += particles.volume(p) * fields.energy(p);
  return world().sum(sum);
}

/// Rodrigues' rotation, by its matrix: what test and program must agree on.
Vector3 rotated(const Vector3& X, const Vector3& axis, const Vector3& center, double degrees) {
  const double size = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  const double a[3] = {axis[0] / size, axis[1] / size, axis[2] / size};
  const double angle = degrees * std::acos(-1.0) / 180.0, c = std::cos(angle), s = std::sin(angle);
  const double R[3][3] = {{c + a[0] * a[0] * (1 - c), a[0] * a[1] * (1 - c) - a[2] * s,
                           a[0] * a[2] * (1 - c) + a[1] * s},
                          {a[1] * a[0] * (1 - c) + a[2] * s, c + a[1] * a[1] * (1 - c),
                           a[1] * a[2] * (1 - c) - a[0] * s},
                          {a[2] * a[0] * (1 - c) - a[1] * s, a[2] * a[1] * (1 - c) + a[0] * s,
                           c + a[2] * a[2] * (1 - c)}};
  Vector3 x = center;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) x[i] += R[i][j] * (X[j] - center[j]);
  return x;
}

struct Case {
  ImposedBy imposed_by;
  bool reset;
  double tolerance;  ///< of displacements, in edges of the body
};

class RigidTurn : public testing::TestWithParam<Case> {};

// Both ends turn alike, by three quarters of a right angle about an axis that lies askew: the body
// turns with them, every particle on its circle, and no stress comes of it.
TEST_P(RigidTurn, OfBothEndsStrainsNothing) {
  const double degrees = 67.5;
  const Vector3 axis{1.0, 2.0, -0.5}, center{3.0, -2.0, 5.0};
  test::Specimen specimen;
  specimen.label = test::crossing_bars;
  specimen.layout = {particles::Layout::voxel_centers, 1, 2};
  specimen.reset = GetParam().reset;
  if (specimen.reset) specimen.shape_functions = shape::ShapeFunctions::gimp;
  if (specimen.reset) specimen.stabilization = 0.01;
  specimen.conditions = {{"bottom", turn(Face::y_lower, degrees, axis, center)},
                         {"top", turn(Face::y_upper, degrees, axis, center)}};
  for (auto& named : specimen.conditions) named.second.imposed_by = GetParam().imposed_by;
  mechanics::MovingBody body = specimen.moving_body(world());
  const double edge = specimen.grid().length(1);
  const double tolerance = GetParam().tolerance;
  test::take_steps(body, 6, test::to_rounding(), [&](double load, const grid::Vector& u) {
    const auto moved = body.balance().body().moved_particles(u);
    const auto fields = body.balance().body().particle_fields(u);
    for (int p = 0; p < moved.count(); ++p) {
      Vector3 X;
      for (int d = 0; d < 3; ++d)
        X[static_cast<std::size_t>(d)] = moved.position(p, d) - fields.displacement(p, d);
      const Vector3 x = rotated(X, axis, center, load * degrees);
      for (int d = 0; d < 3; ++d)
        EXPECT_NEAR(moved.position(p, d), x[static_cast<std::size_t>(d)], tolerance * edge);
      for (int c = 0; c < 6; ++c) EXPECT_NEAR(fields.stress(p, c), 0.0, 1e-8 * 1041.6);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(ByEachWay, RigidTurn,
                         testing::Values(Case{ImposedBy::nodes, false, 1e-10},
                                         Case{ImposedBy::penalty, false, 1e-10},
                                         Case{ImposedBy::grip, true, 1e-10},
                                         Case{ImposedBy::penalty, true, 1e-10}));

// Turning the top by an angle and turning the bottom by the opposite one are one twist, seen from
// two sides: the same energy and, in the turned frame, the same forces.
TEST(Twist, IsTheSameFromBothEnds) {
  const double degrees = 40.0;
  const Vector3 axis{0.0, 1.0, 0.0};
  test::Specimen specimen;
  const Vector3 center{4.2, 0.0, 4.0};
  const auto twist = [&](double bottom, double top) {
    specimen.conditions = {{"bottom", turn(Face::y_lower, bottom, axis, center)},
                           {"top", turn(Face::y_upper, top, axis, center)}};
    mechanics::MovingBody body = specimen.moving_body(world());
    double result = 0.0;
    test::take_steps(body, 4, test::to_rounding(),
                     [&](double, const grid::Vector& u) { result = energy(body, u); });
    return result;
  };
  const double one = twist(0.0, degrees);
  EXPECT_GT(one, 0.0);
  EXPECT_NEAR(twist(-degrees, 0.0), one, 1e-10 * one);
  EXPECT_NEAR(twist(-0.5 * degrees, 0.5 * degrees), one, 1e-10 * one);
}

// A full turn is no motion at full load, but it is one on the way: a face cannot both make it and
// be held.
TEST(Twist, AFullTurnIsNoRest) {
  test::Specimen specimen;
  const Vector3 center{4.2, 0.0, 4.0};
  specimen.conditions = {{"turned", turn(Face::y_upper, 360.0, {0.0, 1.0, 0.0}, center)},
                         {"held", test::hold(Face::x_upper, "x")},
                         {"bottom", test::hold(Face::y_lower, "xyz")}};
  EXPECT_THROW(specimen.balance(world()), base::InputError);
}

}  // namespace
}  // namespace stroma
