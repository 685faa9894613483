// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A law of an application's own, in a body without and with Stroma's laws: simple shear against
/// its analytic stress, and Newton's order. Claim V-OWN-LAW, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "GentLaw.hpp"
#include "stroma/material/OneOf.hpp"
#include "stroma/mechanics/kernels/StressKernelsOf.hpp"
#include "stroma/shape/Linear.hpp"
#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"

namespace stroma {
namespace {

using example::GentLaw;
using mechanics::Face;

/// Any law, for linear shape functions: what docs/extending.md shows.
template <class Law>
mechanics::Laws own_laws(const std::vector<Law>& laws) {
  mechanics::Laws result;
  for (const Law& law : laws) result.moduli.push_back(law.small_strain());
  result.kernels = [laws](shape::ShapeFunctions, bool) {
    return std::make_shared<mechanics::StressKernelsOf<shape::Linear, Law>>(laws);
  };
  return result;
}

/// All faces move as u_x = g Y: homogeneous where the material is.
mechanics::NamedConditions sheared(double g) {
  mechanics::NamedConditions conditions;
  for (const auto& [name, face] : {std::pair{"top", Face::y_upper},
                                   {"bottom", Face::y_lower},
                                   {"left", Face::x_lower},
                                   {"right", Face::x_upper},
                                   {"back", Face::z_lower},
                                   {"front", Face::z_upper}}) {
    mechanics::BoundaryCondition condition = test::hold(face, "xyz");
    condition.displacement_gradient = std::array<double, 9>{0, g, 0, 0, 0, 0, 0, 0, 0};
    conditions.emplace_back(name, condition);
  }
  return conditions;
}

// Ibar1 - 3 = g^2 in simple shear, so that tau_xy = mu g Jm / (Jm - g^2): close to the limit, three
// times that of the neo-Hookean solid.
TEST(OwnLaw, SimpleShearHasTheAnalyticStress) {
  const double g = 0.8, mu = 520.8, limit = 0.96;
  test::Specimen specimen;
  specimen.other_laws = own_laws(std::vector<GentLaw>{{mu, limit, 2430.4}, {mu, limit, 2430.4}});
  specimen.conditions = sheared(g);
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::world());
  const double expected = mu * g * limit / (limit - g * g);
  EXPECT_GT(expected, 2.9 * mu * g);
  test::take_steps(body, 8, test::to_rounding(), [&](double load, const grid::Vector& u) {
    if (load < 1.0) return;
    const auto fields = body.balance().body().particle_fields(u);
    for (int p = 0; p < body.balance().body().particles().count(); ++p)
      EXPECT_NEAR(fields.stress(p, 3), expected, 1e-11 * expected);
  });
}

// A vessel of Gent's solid in a neo-Hookean gel, as one of several laws: the force is the
// derivative of the energy along the path of loading, and Newton converges quadratically.
TEST(OwnLaw, MixesWithStromasLaws) {
  using Either = material::OneOf<material::NeoHookean, GentLaw>;
  test::Specimen specimen;
  specimen.label = test::crossing_bars;
  specimen.other_laws = own_laws(
      std::vector<Either>{material::NeoHookean{520.8, 2430.4}, GentLaw{1041.6, 0.5, 4860.8}});
  specimen.conditions = test::clamped(0.2);
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::world());
  solver::NewtonSolver newton(test::to_rounding(), body.balance());
  solver::begin_step(body, newton);
  grid::Vector u(body.balance().owned_map());
  solver::solve_step(body, newton, 1.0, u);
  const std::vector<double>& residual = newton.residual_history();
  ASSERT_GE(residual.size(), 4u);
  for (std::size_t n = 1; n + 1 < residual.size(); ++n)
    if (residual[n] < 1e-2 && residual[n + 1] > 1e-12) {
      EXPECT_LT(residual[n + 1], 50.0 * residual[n] * residual[n]);
    }
}

}  // namespace
}  // namespace stroma
