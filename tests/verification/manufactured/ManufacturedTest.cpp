// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A displacement that was chosen, and the body force that makes it the solution: how fast the
/// method approaches it. Claims V-MAN-1 to V-MAN-4, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/LoadSteps.hpp"
#include "support/ShapeChoices.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using mechanics::ImposedBy;
using test::Specimen;
using Vector3 = std::array<double, 3>;

const double pi = std::acos(-1.0);
const Vector3 amplitude{0.05 * std::sin(2.0 * pi / 3.0), 0.05 * std::sin(4.0 * pi / 3.0), 0.0};
const material::NeoHookean law{520.8, 2430.4};

/// u_i = A_i sin(pi X_i) on the unit square. (That of issue 5 in space has A_1 = 0: it is this
/// one.)
double displacement(int i, double X) {
  return amplitude[static_cast<std::size_t>(i)] * std::sin(pi * X);
}

/// Force per reference volume. F is diagonal, a_i = 1 + du_i/dX_i, and so is the first
/// Piola-Kirchhoff stress, P_i = tau_i / a_i, of which X_i changes a_i alone:
///
///     B_i = -dP_i/dX_i = -a_i' { K (1 - ln J) / a_i^2 + mu J^(-2/3) (-1/3 + 5 tr b / (9 a_i^2)) }.
Vector3 body_force(const Vector3& X) {
  Vector3 a, change;
  double J = 1.0, trace = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = 1.0 + amplitude[i] * pi * std::cos(pi * X[i]);
    change[i] = -amplitude[i] * pi * pi * std::sin(pi * X[i]);
    J *= a[i];
    trace += a[i] * a[i];
  }
  Vector3 force;
  for (std::size_t i = 0; i < 3; ++i)
    force[i] = -change[i] * (law.bulk_modulus * (1.0 - std::log(J)) / (a[i] * a[i]) +
                             law.shear_modulus * std::pow(J, -2.0 / 3.0) *
                                 (-1.0 / 3.0 + 5.0 * trace / (9.0 * a[i] * a[i])));
  return force;
}

struct Found {
  double error;    ///< of the displacement at the particles, root mean square by volume [um]
  double crossed;  ///< share of the particles that have changed their element
};

/// \param n  elements a side
Found solve(const test::ShapeChoice& choice, bool reset, std::int64_t n,
            double stabilization = 0.0) {
  Specimen specimen;
  choice.apply_to(specimen);
  specimen.reset = reset;
  specimen.stabilization = stabilization;
  specimen.plane_strain = true;
  specimen.elements = {n, n, 1};
  const double h = 1.0 / static_cast<double>(n);
  specimen.spacing = {h, h, 1.0};
  specimen.layout = {particles::Layout::per_element, 1, 2};
  specimen.laws = {law};
  specimen.body_force = body_force;
  specimen.conditions = {{"x-", test::hold(Face::x_lower, "x")},
                         {"x+", test::hold(Face::x_upper, "x")},
                         {"y-", test::hold(Face::y_lower, "y")},
                         {"y+", test::hold(Face::y_upper, "y")}};
  for (auto& named : specimen.conditions) named.second.imposed_by = ImposedBy::nodes;
  solver::SolverParameters parameters = test::to_rounding();
  parameters.newton_tolerance = 1e-10;
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::self());
  double squares = 0.0, volume = 0.0, crossed = 0.0;
  test::take_steps(body, reset ? 5 : 1, parameters, [&](double load, const grid::Vector& u) {
    if (load < 1.0) return;
    const auto& particles = body.balance().body().particles();
    const auto fields = body.balance().body().particle_fields(u);
    for (int p = 0; p < particles.count(); ++p) {
      bool has_crossed = false;
      for (int d = 0; d < 2; ++d) {
        const double X = particles.undeformed_position(p, d);
        const double error = fields.displacement(p, d) - displacement(d, X);
        squares += particles.volume(p) * error * error;
        const double x = X + fields.displacement(p, d);
        has_crossed = has_crossed || std::floor(x / h) != std::floor(X / h);
      }
      volume += particles.volume(p);
      if (has_crossed) crossed += particles.volume(p);
    }
  });
  const Found found{std::sqrt(squares / volume), crossed / volume};
  std::printf("  %-18s %-8s %2d elements: %.2e um, %.0f %% have crossed\n", choice.name.c_str(),
              reset ? "reset" : "no reset", static_cast<int>(n), found.error,
              100.0 * found.crossed);
  return found;
}

/// Mean order of convergence from 8 to 24 elements a side.
double order(const test::ShapeChoice& choice, bool reset) {
  const Found coarse = solve(choice, reset, 8), fine = solve(choice, reset, 24);
  EXPECT_GT(fine.crossed, 0.8);  // were they to cross
  return std::log(coarse.error / fine.error) / std::log(3.0);
}

class Manufactured : public ::testing::TestWithParam<test::ShapeChoice> {};

// V-MAN-1. Without reset.
TEST_P(Manufactured, ConvergesWithoutReset) { EXPECT_GT(order(GetParam(), false), 1.95); }

class ManufacturedReset : public ::testing::TestWithParam<test::ShapeChoice> {};

// V-MAN-2. With reset, in five steps, in which most particles change their element.
TEST_P(ManufacturedReset, ConvergesWhenParticlesCross) { EXPECT_GT(order(GetParam(), true), 1.8); }

// V-MAN-3. Crossing hats do not converge at all, and domains that stay as seeded to first order.
TEST(ManufacturedReset, HatsAndUndeformedDomains) {
  for (const auto& choice : test::shape_choices()) {
    if (choice.shape_functions == shape::ShapeFunctions::linear) {
      EXPECT_LT(order(choice, true), 0.0);
    } else if (choice.particle_domain == mechanics::ParticleDomain::undeformed) {
      EXPECT_NEAR(order(choice, true), 1.4, 0.3) << choice.name;
    }
  }
}

// V-MAN-4. The default stabilisation changes the displacement by less than 1e-4 of the largest.
TEST(ManufacturedReset, StabilizationDoesNotMatter) {
  for (const auto& choice : test::smooth_choices()) {
    const double difference =
        solve(choice, true, 16, 0.01).error - solve(choice, true, 16, 0.0).error;
    EXPECT_LT(std::abs(difference), 1e-4 * 0.0433) << choice.name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Manufactured, ::testing::ValuesIn(test::shape_choices()),
                         [](const auto& tested) { return tested.param.name; });
INSTANTIATE_TEST_SUITE_P(Smooth, ManufacturedReset, ::testing::ValuesIn(test::smooth_choices()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace stroma
