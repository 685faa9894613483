// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What laws remember: a law that is softened by what it has borne, in simple shear against its
/// analytic stress, on a grid that is reset or not. Claims V-HIST-1 to V-HIST-3,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "DamagedLaw.hpp"
#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/material/OneOf.hpp"
#include "stroma/mechanics/kernels/StressKernelsOf.hpp"
#include "stroma/shape/BSpline.hpp"
#include "stroma/shape/Linear.hpp"
#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using example::DamagedLaw;
using mechanics::Face;

const DamagedLaw law{{520.8, 2430.4}, 0.6, 30.0};

template <class Law>
mechanics::Laws own_laws(const std::vector<Law>& laws) {
  mechanics::Laws result;
  for (const Law& one : laws) result.moduli.push_back(one.small_strain());
  result.kernels = [laws](shape::ShapeFunctions functions,
                          bool) -> std::shared_ptr<const mechanics::StressKernels> {
    if (functions == shape::ShapeFunctions::linear)
      return std::make_shared<mechanics::StressKernelsOf<shape::Linear, Law>>(laws);
    return std::make_shared<mechanics::StressKernelsOf<shape::BSpline<2, 3>, Law>>(laws);
  };
  return result;
}

/// Grips all around move as u_x = g Y: homogeneous where the material is.
test::Specimen sheared(double g, bool reset) {
  test::Specimen specimen;
  specimen.reset = reset;
  specimen.other_laws = own_laws(std::vector<DamagedLaw>{law, law});
  mechanics::BoundaryCondition condition = test::hold(Face::all, "xyz");
  condition.imposed_by = reset ? mechanics::ImposedBy::grip : mechanics::ImposedBy::nodes;
  condition.displacement_gradient = std::array<double, 9>{0, g, 0, 0, 0, 0, 0, 0, 0};
  specimen.conditions = {{"around", condition}};
  return specimen;
}

/// Energy of shape of the undamaged solid in simple shear by g.
double borne(double g) { return 0.5 * 520.8 * g * g; }

/// Solves for a load and accepts it.
void step(mechanics::MovingBody& body, solver::NewtonSolver& newton, double load) {
  solver::begin_step(body, newton);
  grid::Vector trial(body.balance().owned_map());
  solver::solve_step(body, newton, load, trial);
  body.accept(load, trial);
}

void expect_shear_stress(const mechanics::MovingBody& body, double expected) {
  const auto fields = body.balance().body().particle_fields(body.displacement());
  for (int p = 0; p < body.balance().body().particles().count(); ++p)
    EXPECT_NEAR(fields.stress(p, 3), expected, 1e-10 * expected);
}

void expect_history(const mechanics::MovingBody& body, double expected) {
  const auto& particles = body.balance().body().particles();
  ASSERT_EQ(particles.history.extent(0), static_cast<std::size_t>(particles.count()));
  for (int p = 0; p < particles.count(); ++p)
    EXPECT_NEAR(particles.history(p, 0), expected, 1e-10 * borne(1.0));
}

// V-HIST-1. Up to g and back to half of it: tau_xy = g(m) mu gamma, with m the largest energy borne,
// also where particles have gone to other elements and ranks.
TEST(History, IsFeltOnTheWayBack) {
  const double g = 0.6;
  for (const bool reset : {false, true}) {
    const test::Specimen specimen = sheared(g, reset);
    mechanics::MovingBody body = specimen.moving_body(world());
    solver::NewtonSolver newton(test::to_rounding(), body.balance());
    for (const double load : {0.25, 0.5, 0.75, 1.0}) {
      step(body, newton, load);
      expect_shear_stress(body, law.left(borne(g * load)) * 520.8 * g * load);
    }
    for (const double load : {0.8, 0.5}) {
      step(body, newton, load);
      expect_shear_stress(body, law.left(borne(g)) * 520.8 * g * load);
    }
  }
}

// V-HIST-2. It is what the last step but one has left while an accepted displacement is looked at,
// and changes when the next step begins; a step that is solved and not accepted leaves no trace.
TEST(History, ChangesWithAcceptedStepsOnly) {
  const double g = 0.6;
  for (const bool reset : {false, true}) {
    const test::Specimen specimen = sheared(g, reset);
    mechanics::MovingBody body = specimen.moving_body(world());
    solver::NewtonSolver newton(test::to_rounding(), body.balance());
    expect_history(body, 0.0);
    step(body, newton, 0.5);
    expect_history(body, 0.0);

    solver::begin_step(body, newton);
    expect_history(body, borne(0.5 * g));
    std::map<std::int64_t, double> before;
    const auto remember = [&](const auto& visit) {
      const auto& particles = body.balance().body().particles();
      for (int p = 0; p < particles.count(); ++p) visit(particles.id(p), particles.history(p, 0));
    };
    remember([&](std::int64_t id, double value) { before[id] = value; });
    grid::Vector trial(body.balance().owned_map());
    solver::solve_step(body, newton, 1.0, trial);
    body.reject();
    solver::begin_step(body, newton);
    remember([&](std::int64_t id, double value) { EXPECT_EQ(before.at(id), value); });

    step(body, newton, 0.75);
    expect_shear_stress(body, law.left(borne(0.75 * g)) * 520.8 * 0.75 * g);
  }
}

// V-HIST-3. The hats under wider functions keep particles in other elements: what these remember
// follows.
TEST(History, IsThatOfTheHatsUnderWiderFunctions) {
  test::Specimen specimen = sheared(0.3, false);
  specimen.shape_functions = shape::ShapeFunctions::quadratic_b_spline;
  specimen.label = test::crossing_bars;
  specimen.other_laws = own_laws(std::vector<DamagedLaw>{law, {{1041.6, 4860.8}, 0.6, 30.0}});
  mechanics::MovingBody body = specimen.moving_body(world());
  const auto hats =
      body.balance().with_hats(grid::lattice_under(body.balance().halo().partition()));
  solver::NewtonSolver newton(test::to_rounding(), body.balance());
  step(body, newton, 1.0);
  solver::begin_step(body, newton);
  hats->body().take_history(body.balance().body());
  double sums[2][3] = {};
  double largest = 0.0;
  const mechanics::MomentumBalance* both[2] = {&body.balance(), hats.get()};
  for (int b = 0; b < 2; ++b) {
    const auto& particles = both[b]->body().particles();
    for (int p = 0; p < particles.count(); ++p) {
      const double history = particles.history(p, 0);
      const auto id = static_cast<double>(particles.id(p));
      sums[b][0] += history;
      sums[b][1] += history * id;
      sums[b][2] += history * history;
      largest = std::max(largest, history);
    }
    world().sum_all(sums[b], 3);
  }
  EXPECT_GT(world().max(largest), 0.5 * borne(0.3));
  for (int n = 0; n < 3; ++n) EXPECT_NEAR(sums[0][n], sums[1][n], 1e-12 * sums[0][n]);
}

}  // namespace
}  // namespace stroma
