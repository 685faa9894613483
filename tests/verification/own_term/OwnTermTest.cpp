// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A term of an application's own in the balance of momentum: a bar on an elastic bedding against
/// the exact solution of its difference equation. Claim V-TERM-1, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "Bedding.hpp"
#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"

namespace stroma {
namespace {

using mechanics::Face;

// A bar of Poisson ratio 0 along y, pulled at its upper end and tied to the ground by its bedding
// alone. The nodes of a lumped bedding obey E/h^2 (u_(i-1) - 2 u_i + u_(i+1)) = k u_i, so that
// u_i = u_N cosh(i t) / cosh(N t) with cosh t = 1 + k h^2 / (2 E); the strain is too small for
// anything that is not linear.
void pull_bedded_bar(const solver::SolverParameters& parameters, double tolerance) {
  const double mu = 500.0, E = 2.0 * mu, k = 3.0, strain = 1e-9;
  test::Specimen specimen;
  specimen.elements = {2, 12, 2};
  specimen.laws = {{mu, 2.0 * mu / 3.0}};
  specimen.conditions = {{"end", test::stretch(Face::y_upper, "xyz", strain)}};
  const auto world = base::Communicator::world();
  mechanics::Problem problem = specimen.problem();
  problem.terms.push_back(
      [k](const mechanics::Body& body) { return std::make_unique<example::Bedding>(body, k); });
  mechanics::MovingBody body(world, specimen.partition(world), specimen.particles(world), problem);
  EXPECT_TRUE(body.balance().supports().rigid_holds().empty());

  const grid::Grid grid = specimen.grid();
  const double h = grid.spacing[1], area = grid.length(0) * grid.length(2);
  const auto N = static_cast<double>(grid.elements[1]);
  const double t = std::acosh(1.0 + k * h * h / (2.0 * E)), pulled = strain * grid.length(1);
  const auto exact = [&](double i) { return pulled * std::cosh(i * t) / std::cosh(N * t); };
  test::take_steps(body, 1, parameters, [&](double, const grid::Vector& u) {
    test::for_each_unknown(
        body.balance().halo(), u, [&](const grid::Index3& node, int c, double value) {
          const double expected = c == 1 ? exact(static_cast<double>(node[1])) : 0.0;
          EXPECT_NEAR(value, expected, tolerance * pulled);
        });
    const double force = E * area / h * (pulled - exact(N - 1.0)) + 0.5 * k * area * h * pulled;
    EXPECT_NEAR(test::reactions(body, u)[0][1], force, tolerance * force);
  });
}

TEST(OwnTerm, BarOnABeddingDirect) { pull_bedded_bar(test::to_rounding(), 1e-8); }

TEST(OwnTerm, BarOnABeddingByMultigrid) {
  solver::SolverParameters parameters;
  parameters.newton_tolerance = 1e-10;
  pull_bedded_bar(parameters, 1e-8);
}

}  // namespace
}  // namespace stroma
