// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Bodies that nothing holds, on a grid that is reset. Claim V-DYN-FLIGHT, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/LoadSteps.hpp"
#include "support/ShapeChoices.hpp"

namespace stroma {
namespace {

using Vector = std::array<double, 3>;

/// Momentum [pN s], then angular momentum about the origin [pN um s], of the particles.
std::array<double, 6> momenta(const mechanics::MovingBody& body, const grid::Vector& u) {
  const mechanics::Body& now = body.balance().body();
  const auto moved = now.moved_particles(u);
  const std::vector<double>& density = now.problem().density;
  std::array<double, 6> sums{};
  for (int p = 0; p < moved.count(); ++p) {
    const double mass = 1e-12 * density[moved.material(p)] * moved.volume(p);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      sums[static_cast<std::size_t>(i)] += mass * moved.velocity(p, i);
      sums[static_cast<std::size_t>(3 + i)] += mass * (moved.position(p, j) * moved.velocity(p, k) -
                                                       moved.position(p, k) * moved.velocity(p, j));
    }
  }
  now.communicator().sum_all(sums.data(), sums.size());
  return sums;
}

/// A block of two materials that flies through 20 elements while it turns by 90 degrees, in 40 steps;
/// or as far as fewer of these steps take it.
test::Specimen flying(bool lumped, bool spins, int steps = 40) {
  test::Specimen specimen;
  specimen.elements = {4, 4, 4};
  specimen.label = test::crossing_bars;
  specimen.reset = true;
  specimen.stabilization = 0.01;
  specimen.density = {1000.0, 1100.0};
  specimen.duration = 2.5e-6 * steps;
  const double speed = 20 * 2.1 / 1e-4;
  const double spin = spins ? 0.5 * std::acos(-1.0) / 1e-4 : 0.0;
  mechanics::Dynamics dynamics;
  dynamics.lumped = lumped;
  dynamics.scheme = mechanics::TimeScheme::generalised_alpha(1.0);
  dynamics.initial_velocity = [speed, spin](const Vector& X) {
    return Vector{speed - spin * (X[1] - 4.2), 0.3 * speed + spin * (X[0] - 4.2), -0.1 * speed};
  };
  specimen.dynamics = dynamics;
  return specimen;
}

/// The largest departures of momentum and of angular momentum, over their sizes.
std::array<double, 2> departures(const test::Specimen& specimen, int steps = 40) {
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::world());
  const std::array<double, 6> at_start = momenta(body, body.displacement());
  std::array<double, 2> worst{}, sizes{};
  for (std::size_t n = 0; n < 6; ++n) sizes[n / 3] = std::hypot(sizes[n / 3], at_start[n]);
  solver::SolverParameters exact = test::to_rounding();
  exact.preconditioner = solver::PreconditionerKind::jacobi;
  exact.newton_tolerance = 1e-11;
  test::take_steps(body, steps, exact, [&](double, const grid::Vector& u) {
    const std::array<double, 6> now = momenta(body, u);
    for (std::size_t n = 0; n < 6; ++n)
      worst[n / 3] = std::max(worst[n / 3], std::abs(now[n] - at_start[n]) / sizes[n / 3]);
  });
  return worst;
}

constexpr shape::ShapeFunctions spinning_shapes[] = {
    shape::ShapeFunctions::linear, shape::ShapeFunctions::gimp, shape::ShapeFunctions::cpdi,
    shape::ShapeFunctions::quadratic_b_spline};

class FreeFlight : public ::testing::TestWithParam<test::ShapeChoice> {};

// With lumped masses: momentum, and, of a body that does not spin, angular momentum.
TEST_P(FreeFlight, KeepsMomentumWithLumpedMasses) {
  test::Specimen specimen = flying(true, false);
  GetParam().apply_to(specimen);
  const auto worst = departures(specimen);
  EXPECT_LT(worst[0], 1e-10);
  EXPECT_LT(worst[1], 1e-10);
}

// The consistent mass and the midpoint rule keep both also while it spins.
TEST(FreeFlightOfTheConsistentMass, KeepsAngularMomentum) {
  for (const auto shape : spinning_shapes) {
    const bool takes_long = shape == shape::ShapeFunctions::quadratic_b_spline;
    const int steps = takes_long ? 8 : 40;
    test::Specimen specimen = flying(false, true, steps);
    specimen.shape_functions = shape;
    const auto worst = departures(specimen, steps);
    EXPECT_LT(worst[0], 1e-10);
    EXPECT_LT(worst[1], 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, FreeFlight, ::testing::ValuesIn(test::shape_choices()),
                         [](const auto& choice) { return choice.param.name; });

// Lumped masses keep the momentum of a body that spins, and its angular momentum but for what the
// grid's own moment of inertia changes by with its strain: without the velocities' gradients 1 %.
TEST(FreeFlightOfLumpedMasses, KeepsNearlyAllAngularMomentum) {
  for (const auto shape : spinning_shapes) {
    test::Specimen specimen = flying(true, true);
    specimen.shape_functions = shape;
    const auto worst = departures(specimen);
    EXPECT_LT(worst[0], 1e-10);
    EXPECT_LT(worst[1], 2e-4);
    std::printf("  %.3g of the angular momentum\n", worst[1]);
  }
}

}  // namespace
}  // namespace stroma
