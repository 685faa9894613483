// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The grid that is reset lies between the planes of its supports. Claims V-FIT-GRID-1 to 5,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "stroma/base/Error.hpp"
#include "stroma/mechanics/body/FittedGrid.hpp"
#include "support/LoadSteps.hpp"
#include "support/ShapeChoices.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using test::ShapeChoice;
using test::Specimen;

Specimen with_bars() {
  Specimen specimen;
  specimen.elements = {4, 6, 4};
  specimen.label = test::crossing_bars;
  specimen.layout = {particles::Layout::per_element, 1, 2};
  specimen.stabilization = 0.01;
  return specimen;
}

class FittedGridOf : public ::testing::TestWithParam<ShapeChoice> {};
INSTANTIATE_TEST_SUITE_P(Shapes, FittedGridOf, ::testing::ValuesIn(test::shape_choices()),
                         [](const auto& choice) { return choice.param.name; });

// V-FIT-GRID-1. Nodes hold the faces by default; the first step is that without reset.
TEST_P(FittedGridOf, FirstStepIsThatWithoutReset) {
  std::vector<grid::Vector> answers;
  for (const bool reset : {false, true}) {
    Specimen specimen = with_bars();
    GetParam().apply_to(specimen);
    specimen.reset = reset;
    specimen.conditions = test::clamped(0.1);
    mechanics::MovingBody body = specimen.moving_body(world());
    test::take_steps(body, 1, test::to_rounding(),
                     [&](double, const grid::Vector& u) { answers.push_back(u); });
  }
  grid::Vector difference(answers[0], Teuchos::Copy);
  difference.update(-1.0, answers[1], 1.0);
  EXPECT_GT(answers[0].normInf(), 0.5);
  EXPECT_LT(difference.normInf(), 1e-12 * answers[0].normInf());
}

// V-FIT-GRID-2. A uniform body in a chamber whose lid moves: while the number of elements stays,
// particles keep their places in them, and the force is that without reset to rounding, though the
// grid is another one in each step.
TEST_P(FittedGridOf, AConfinedBodyIsThatWithoutReset) {
  for (const double strain : {0.6, -0.19}) {
    double force[2];
    for (const bool reset : {false, true}) {
      Specimen specimen;
      GetParam().apply_to(specimen);
      specimen.elements = {4, 6, 4};
      specimen.layout = {particles::Layout::per_element, 1, 3};
      specimen.reset = reset;
      specimen.conditions = {{"floor", test::hold(Face::y_lower, "y")},
                             {"lid", test::stretch(Face::y_upper, "y", strain)}};
      for (const Face face : {Face::x_lower, Face::x_upper, Face::z_lower, Face::z_upper})
        specimen.conditions.push_back(
            {"wall" + std::to_string(static_cast<int>(face)),
             test::hold(face, mechanics::axis_of(face) == 0 ? "x" : "z")});
      mechanics::MovingBody body = specimen.moving_body(world());
      test::take_steps(body, 5, test::to_rounding(), [&](double load, const grid::Vector& u) {
        force[reset] = test::reactions(body, u)[1][1];
        const grid::Grid& grid = body.balance().halo().partition().grid();
        const int knots_beyond = grid.centered ? 1 : 0;
        EXPECT_EQ(grid.elements[1] - knots_beyond, 6);
        const double before = reset ? load - 0.2 : 0.0;  // the grid is that of the step's start
        EXPECT_NEAR(grid.spacing[1], 2.1 * (1.0 + before * strain), 1e-12);
        EXPECT_NEAR(grid.spacing[0], 2.1, 1e-12);
      });
    }
    EXPECT_GT(force[0] * strain, 0.0);
    EXPECT_NEAR(force[1], force[0], 1e-9 * std::abs(force[0])) << strain;
  }
}

/// Pushes or pulls the upper face of a block by a way [um].
void elements_follow_the_ends(double way) {
  Specimen specimen = with_bars();
  specimen.shape_functions = shape::ShapeFunctions::gimp;
  specimen.reset = true;
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")},
                         {"top", test::hold(Face::y_upper, "xyz")}};
  specimen.conditions[0].second.displacement = {0.7, -0.4, 0.0};
  specimen.conditions[1].second.displacement = {0.7, way, 0.0};
  specimen.conditions.push_back({"side", test::hold(Face::x_lower, "x")});
  specimen.conditions[2].second.displacement = {0.7, 0.0, 0.0};
  mechanics::MovingBody body = specimen.moving_body(world());
  solver::SolverParameters parameters;
  test::take_steps(body, 8, parameters, [&](double load, const grid::Vector&) {
    const double before = load - 0.125;
    const grid::Grid& grid = body.balance().halo().partition().grid();
    const double lower = -0.4 * before, upper = 12.6 + way * before;
    const double h = grid.spacing[1];
    EXPECT_NEAR(grid.origin[1] + 0.5 * h, lower, 1e-12);
    EXPECT_NEAR(grid.origin[1] + (static_cast<double>(grid.elements[1]) - 0.5) * h, upper, 1e-12);
    if (way < 0.0) {
      EXPECT_LT(h, 1.25 * 2.1);
    }
    EXPECT_GT(h, 2.1 / 1.25);
    // Drawn out, there are as many; 12.6 um / 1.25 are passed between 0.5 and 0.625 of the load.
    EXPECT_EQ(grid.elements[1] - 1, way > 0.0 || before < 0.55 ? 6 : 5) << load;
    EXPECT_EQ(grid.elements[0] - 1, 4);
    EXPECT_NEAR(grid.origin[0] + 0.5 * grid.spacing[0], 0.7 * before, 1e-12);
    // Boxes end at x + sum over e of |F_xe| r_e, with half an edge r of 2.1/4 um.
    const auto& particles = body.balance().body().particles();
    double end = 0.0;
    for (int p = 0; p < particles.count(); ++p) {
      double stretch = 0.0;
      for (int e = 0; e < 3; ++e) stretch += std::abs((e == 0) + particles.base_gradient(p, 0, e));
      end = std::max(end, particles.position(p, 0) + stretch * 0.25 * 2.1);
    }
    EXPECT_NEAR(grid.origin[0] + 4.5 * grid.spacing[0], world().max(end), way > 0.0 ? 1e-3 : 2e-3);
  });
}

// V-FIT-GRID-3. Elements are divided anew when their size departs by a quarter; both planes have
// nodes in each step, and so have a plane and the free end opposite to it, where the boxes of the
// outermost particles end.
TEST(FittedGrid, ElementsFollowTheEnds) {
  for (const double way : {5.2, -5.0}) elements_follow_the_ends(way);
}

/// What ten steps to a strain have done to a clamped body.
struct Strained {
  double force;               ///< of the upper face [pN]
  double work;                ///< of the supports, by Simpson's rule over the steps [aJ]
  double energy;              ///< of strain [aJ]
  double lowest_J;            ///< of all particles at the end [-]
  long long most_iterations;  ///< linear ones, in a step
};

Strained in_ten_steps(const Specimen& specimen, double strain) {
  mechanics::MovingBody body = specimen.moving_body(world());
  solver::NewtonSolver newton({}, body.balance());
  const double third = strain * specimen.grid().length(1) * 0.1 / 3.0;
  Strained result{};
  for (int step = 1; step <= 10; ++step) {
    solver::begin_step(body, newton);
    grid::Vector trial(body.balance().owned_map());
    const auto solved = solver::solve_step(body, newton, 0.1 * step, trial);
    result.most_iterations = std::max(result.most_iterations, solved.linear_iterations);
    body.accept(0.1 * step, trial);
    const auto reactions = test::reactions(body, body.displacement());
    result.force = reactions[1][1];
    EXPECT_NEAR(reactions[0][1], -result.force, 1e-8 * std::abs(result.force));
    result.work += third * (step == 10 ? 1.0 : step % 2 == 1 ? 4.0 : 2.0) * result.force;
  }
  const auto& particles = body.balance().body().particles();
  const auto fields = body.balance().body().particle_fields(body.displacement());
  result.lowest_J = 1e300;
  for (int p = 0; p < particles.count(); ++p) {
    result.energy += particles.volume(p) * fields.energy(p);
    result.lowest_J = std::min(result.lowest_J, fields.jacobian(p));
  }
  result.energy = world().sum(result.energy);
  result.lowest_J = world().min(result.lowest_J);
  return result;
}

// V-FIT-GRID-4. A clamped block by 30 % and -30 % in ten steps, with smooth functions: the force is
// that of hats without reset within 1 %, a step takes no more linear iterations than there, and the
// energy departs from the work of the supports by what resets lose.
TEST(FittedGrid, AClampedBlockUnderLargeStrain) {
  for (const double strain : {0.3, -0.3}) {
    Specimen specimen;
    specimen.elements = {8, 12, 8};
    specimen.spacing = {4.0, 4.0, 4.0};
    specimen.laws = {{520.8, 2430.4}};
    specimen.layout = {particles::Layout::per_element, 1, 2};
    specimen.conditions = test::clamped(strain);
    const Strained without = in_ten_steps(specimen, strain);
    specimen.shape_functions = shape::ShapeFunctions::gimp;
    specimen.reset = true;
    specimen.stabilization = 0.01;
    const Strained with = in_ten_steps(specimen, strain);
    if (world().is_root())
      for (const Strained& one : {without, with})
        std::printf(
            "  %+.0f %%: %.0f pN (%+.2f %%), at most %lld iterations a step, energy %+.1e\n",
            100.0 * strain, one.force, 100.0 * (one.force / without.force - 1.0),
            one.most_iterations, one.energy / one.work - 1.0);
    EXPECT_NEAR(with.force, without.force, 0.01 * std::abs(without.force));
    EXPECT_LE(with.most_iterations, 25);
    EXPECT_NEAR(without.energy, without.work, 5e-6 * without.energy);
    EXPECT_NEAR(with.energy, with.work, 3e-3 * with.energy);
  }
}

// V-FIT-GRID-6. Two materials to twice their length, and to 40 % of it.
TEST(FittedGrid, TwoMaterialsUnderVeryLargeStrain) {
  for (const double strain : {1.0, -0.6}) {
    Specimen specimen = with_bars();
    specimen.shape_functions = shape::ShapeFunctions::gimp;
    specimen.reset = true;
    specimen.conditions = test::clamped(strain);
    const Strained found = in_ten_steps(specimen, strain);
    if (world().is_root())
      std::printf("  %+.0f %%: at most %lld iterations a step, J = %.2f at least\n", 100.0 * strain,
                  found.most_iterations, found.lowest_J);
    EXPECT_GT(found.force * strain, 0.0);
    EXPECT_GT(found.lowest_J, 0.0);
  }
}

// V-FIT-GRID-7. The smoother of cubic splines damps their shortest waves too.
TEST(FittedGrid, CubicSplinesTakeFewIterations) {
  Specimen specimen;
  specimen.elements = {4, 6, 4};
  specimen.spacing = {4.0, 4.0, 4.0};
  specimen.layout = {particles::Layout::per_element, 1, 4};
  specimen.shape_functions = shape::ShapeFunctions::cubic_b_spline;
  specimen.reset = true;
  specimen.stabilization = 0.01;
  specimen.conditions = test::clamped(-0.06);
  mechanics::MovingBody body = specimen.moving_body(world());
  long long most = 0, last = 0;
  solver::NewtonSolver newton({}, body.balance(), [&](int n, double, long long so_far) {
    if (n > 0) most = std::max(most, so_far - last);
    last = so_far;
  });
  for (const double load : {0.5, 1.0}) {
    solver::begin_step(body, newton);
    grid::Vector trial(body.balance().owned_map());
    solver::solve_step(body, newton, load, trial);
    body.accept(load, trial);
  }
  if (world().is_root()) std::printf("  %lld iterations in a solve at most\n", most);
  EXPECT_LE(most, 25);
}

// V-FIT-GRID-5. Faces that meet end the run with a message.
TEST(FittedGrid, FacesThatMeetAreRefused) {
  Specimen specimen = with_bars();
  specimen.reset = true;
  specimen.conditions = test::clamped(-0.2);
  const auto particles = specimen.particles(world());
  mechanics::Problem problem = specimen.problem();
  problem.conditions[1].second.strain = -1.5;
  EXPECT_THROW(mechanics::fitted_grid(world(), problem, 1.0, problem.body, particles),
               base::RunError);
}

// A particle that got lost does not fill the memory with elements, on any rank.
TEST(FittedGrid, LostParticlesAreRefused) {
  Specimen specimen = with_bars();
  specimen.reset = true;
  const auto particles = specimen.particles(world());
  const mechanics::Problem problem = specimen.problem();
  EXPECT_NO_THROW(mechanics::fitted_grid(world(), problem, 0.0, problem.body, particles));
  if (world().is_root()) particles.position(0, 2) = 1e12;
  EXPECT_THROW(mechanics::fitted_grid(world(), problem, 0.0, problem.body, particles),
               base::RunError);
}

}  // namespace
}  // namespace stroma
