// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A column under its own weight, whose particles cross many elements. Claims V-COL-1 to V-COL-4,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "support/LoadSteps.hpp"
#include "support/ShapeChoices.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using mechanics::ImposedBy;
using test::Specimen;

constexpr double L = 32.0;  // [um]
const material::NeoHookean law{520.8, 2430.4};
const double M = law.bulk_modulus + 4.0 / 3.0 * law.shear_modulus;

/// What is wrong with a column at full load.
struct Errors {
  double stress;  ///< root mean square over the particles, by that of the exact stress
  double top;     ///< of the displacement of the upper end, by L
};

/// A column of 4 x n elements that stands on its bottom and cannot move sideways. Confined, its
/// Cauchy stress along y is the nominal one, -q (1 - Y/L), whatever the law. (With cubic B-splines,
/// fewer than three elements across have more functions than particles.)
Errors errors(const test::ShapeChoice& choice, bool reset, std::int64_t n, double q_over_M,
              double exact_top) {
  Specimen specimen;
  choice.apply_to(specimen);
  specimen.plane_strain = true;
  specimen.reset = reset;
  specimen.stabilization = reset ? 0.01 : 0.0;
  specimen.elements = {4, n, 1};
  const double h = L / static_cast<double>(n);
  specimen.spacing = {h, h, h};
  specimen.layout = {particles::Layout::per_element, 1, 2};
  specimen.laws = {law};
  const double q = q_over_M * M;
  mechanics::ExternalForce weight;
  weight.body_force = std::array<double, 3>{0.0, -q / L, 0.0};
  specimen.forces = {{"weight", weight}};
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "y")},
                         {"left", test::hold(Face::x_lower, "x")},
                         {"right", test::hold(Face::x_upper, "x")}};
  for (auto& named : specimen.conditions) named.second.imposed_by = ImposedBy::nodes;
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::self());
  double squares = 0.0, scale = 0.0, top = 0.0, highest = 0.0;
  test::take_steps(body, 10, test::to_rounding(), [&](double load, const grid::Vector& u) {
    if (load < 1.0) return;
    const auto& particles = body.balance().body().particles();
    const auto fields = body.balance().body().particle_fields(u);
    for (int p = 0; p < particles.count(); ++p) {
      const double Y = particles.undeformed_position(p, 1);
      const double exact = -q * (1.0 - Y / L);
      const double error = fields.stress(p, 1) - exact;
      squares += error * error;
      scale += exact * exact;
      if (Y < highest) continue;
      highest = Y;
      top = fields.displacement(p, 1) + (fields.jacobian(p) - 1.0) * (L - Y);
    }
  });
  return {std::sqrt(squares / scale), std::abs(top / L - exact_top)};
}

constexpr double top_at_half = -0.1746535845;  // u/L of the upper end for q = M/2

/// Mean order of convergence of the stress from 8 to 64 elements; prints what it has found.
double order_of_stress(const test::ShapeChoice& choice, bool reset, Errors& finest) {
  double coarsest = 0.0;
  for (const std::int64_t n : {8, 16, 32, 64}) {
    finest = errors(choice, reset, n, 0.5, top_at_half);
    if (n == 8) coarsest = finest.stress;
    std::printf("  %-18s %-8s %2d elements: stress %.2e, upper end %.2e\n", choice.name.c_str(),
                reset ? "reset" : "no reset", static_cast<int>(n), finest.stress, finest.top);
  }
  return std::log2(coarsest / finest.stress) / 3.0;
}

// V-COL-1. Hats: of first order in the stress without reset. With reset, a particle that enters the
// next element takes its force across at once, and the stress stays wrong however fine the grid.
TEST(Column, HatsDoNotConvergeWhenParticlesCross) {
  const test::ShapeChoice hats = test::shape_choices().front();
  Errors finest{};
  EXPECT_GT(order_of_stress(hats, false, finest), 0.95);
  EXPECT_LT(order_of_stress(hats, true, finest), 0.1);
  EXPECT_GT(finest.stress, 0.2);
}

class SmoothColumn : public ::testing::TestWithParam<test::ShapeChoice> {};

// V-COL-2. The smooth functions, whose domains stay side by side.
TEST_P(SmoothColumn, ConvergesWhenParticlesCross) {
  Errors finest{};
  EXPECT_GT(order_of_stress(GetParam(), true, finest), 1.1);
  EXPECT_LT(finest.stress, 2.5e-3);
  EXPECT_LT(finest.top, 4e-6);
}

// V-COL-3. The upper end sinks by these figures, from integrating the stretch along the column.
TEST_P(SmoothColumn, SinksAsItShould) {
  for (const auto& [ratio, exact] :
       {std::pair{0.1, -0.0457586370}, {0.2, -0.0846429375}, {0.5, top_at_half}}) {
    const double error = errors(GetParam(), true, 32, ratio, exact).top;
    std::printf("  q/M = %.1f: %.1e L\n", ratio, error);
    EXPECT_LT(error, 2e-5) << ratio;
  }
}

INSTANTIATE_TEST_SUITE_P(Smooth, SmoothColumn, ::testing::ValuesIn(test::smooth_choices()),
                         [](const auto& tested) { return tested.param.name; });

// V-COL-4. Domains that stay as seeded part or overlap where the body is stretched or compressed:
// better than hats by an order of magnitude, but no more than that.
TEST(Column, UndeformedDomainsDoNotConverge) {
  for (const auto& choice : test::shape_choices()) {
    if (choice.particle_domain != mechanics::ParticleDomain::undeformed) continue;
    Errors finest{};
    EXPECT_LT(order_of_stress(choice, true, finest), 0.5) << choice.name;
    EXPECT_LT(finest.stress, 0.05) << choice.name;
  }
}

}  // namespace
}  // namespace stroma
