// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Newton's method: its order, its answers, and its refusals. Claims V-NEW-1 to V-NEW-4 and
/// V-TERM-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/mechanics/MovingBody.hpp"
#include "stroma/solver/LoadStep.hpp"
#include "stroma/solver/NewtonSolver.hpp"
#include "support/CountingTerm.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma::solver {
namespace {

using mechanics::Face;
using test::Specimen;

SolverParameters direct() {
  SolverParameters parameters;
  parameters.preconditioner = PreconditionerKind::direct;
  parameters.newton_tolerance = 1e-12;
  parameters.linear_tolerance = 1e-12;
  return parameters;
}

Specimen two_materials(double strain) {
  Specimen specimen;
  specimen.label = test::crossing_bars;
  specimen.conditions = test::clamped(strain);
  return specimen;
}

// One step of 40 %, so that there are iterations to look at. The order is log(r2/r1) / log(r1/r0)
// of successive residuals; the last that counts is the first below 1e-9, since rounding bounds the
// rest.
TEST(NewtonSolver, ConvergesQuadratically) {
  const auto balance = two_materials(0.4).balance(world());
  NewtonSolver newton(direct(), *balance);
  grid::Vector u(balance->owned_map()), change(balance->owned_map());
  balance->set_load(1.0);
  balance->supports().impose(1.0, change);
  newton.predict(u, change);
  const NewtonResult result = newton.solve(u);
  EXPECT_LE(result.residual, 1e-12);
  const std::vector<double>& r = newton.residual_history();
  ASSERT_EQ(static_cast<int>(r.size()), result.iterations + 1);
  std::size_t last = 0;
  while (last + 1 < r.size() && r[last] > 1e-7) ++last;
  ASSERT_GE(last, 2u);
  const double order = std::log(r[last] / r[last - 1]) / std::log(r[last - 1] / r[last - 2]);
  EXPECT_GT(order, 1.8);
  RecordProperty("order", std::to_string(order));
}

// V-NEW-5.
// Solving Newton steps no better than they are worth: the same answer, as many Newton iterations,
// fewer linear ones.
TEST(NewtonSolver, AdaptiveForcingSavesLinearIterationsOnly) {
  const auto balance = two_materials(0.1).balance(world());
  const auto solve = [&](Forcing forcing, grid::Vector& u) {
    SolverParameters parameters;
    parameters.preconditioner = PreconditionerKind::jacobi;
    parameters.forcing = forcing;
    NewtonSolver newton(parameters, *balance);
    grid::Vector change(balance->owned_map());
    balance->set_load(1.0);
    balance->supports().impose(1.0, change);
    newton.predict(u, change);
    return newton.solve(u);
  };
  grid::Vector adaptive(balance->owned_map()), constant(balance->owned_map());
  const NewtonResult lean = solve(Forcing::adaptive, adaptive);
  const NewtonResult full = solve(Forcing::constant, constant);
  EXPECT_LE(lean.residual, 1e-8);
  EXPECT_EQ(lean.iterations, full.iterations);
  EXPECT_LT(lean.linear_iterations, full.linear_iterations);
  adaptive.update(-1.0, constant, 1.0);
  EXPECT_LT(adaptive.normInf(), 1e-8 * constant.normInf());
}

// V-NEW-2.
// The patch test, solved: uniform material, linear displacement on all faces, from a start that is
// wrong everywhere inside.
TEST(NewtonSolver, FindsTheHomogeneousState) {
  const std::array<double, 9> G{0.05, 0.20, -0.04, -0.10, 0.08, 0.06, 0.03, -0.07, -0.05};
  for (const auto layout : {particles::Layout::gauss, particles::Layout::voxel_centers}) {
    Specimen specimen;
    specimen.layout.layout = layout;
    specimen.conditions = {{"boundary", test::hold(Face::all, "xyz")}};
    specimen.conditions[0].second.displacement_gradient = G;
    const auto balance = specimen.balance(world());
    NewtonSolver newton(direct(), *balance);
    grid::Vector u(balance->owned_map());
    test::fill(balance->halo(), u, [&](const grid::Index3& node, int c) {
      return test::linear_field(specimen.grid(), G, node, c) + 0.1 * test::scatter(node, c);
    });
    balance->set_load(1.0);
    balance->supports().impose(1.0, u);
    newton.solve(u);
    test::for_each_unknown(balance->halo(), u, [&](const grid::Index3& node, int c, double value) {
      EXPECT_NEAR(value, test::linear_field(specimen.grid(), G, node, c), 1e-11);
    });
  }
}

// V-NEW-3.
// Rollers: what is held against rigid motion carries no force, and the supports' forces balance.
TEST(NewtonSolver, RigidHoldsCarryNothingAndReactionsBalance) {
  Specimen specimen = two_materials(0.1);
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "y")},
                         {"top", test::stretch(Face::y_upper, "y", 0.1)}};
  const auto balance = specimen.balance(world());
  ASSERT_EQ(balance->supports().rigid_holds().size(), 3u);
  NewtonSolver newton(direct(), *balance);
  grid::Vector u(balance->owned_map()), change(balance->owned_map());
  balance->set_load(1.0);
  balance->supports().impose(1.0, change);
  newton.predict(u, change);
  newton.solve(u);
  const auto reactions = balance->reactions(u);
  const grid::Vector& f = *balance->forces(u).unbalanced;
  const double force = reactions[1][1];
  EXPECT_GT(force, 1000.0);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(reactions[0][c] + reactions[1][c], 0.0, 1e-10 * force);
  const auto& partition = balance->halo().partition();
  for (const auto& hold : balance->supports().rigid_holds())
    test::for_each_unknown(balance->halo(), f, [&](const grid::Index3& node, int c, double value) {
      const bool is_held = partition.node_number(node) == hold.node && c == hold.component;
      EXPECT_NEAR(is_held ? value : 0.0, 0.0, 1e-10 * force);
    });
}

// Rotating specimen and supports as a whole (a homogeneous rotation on all faces) costs nothing.
TEST(NewtonSolver, ARigidRotationIsFreeOfStress) {
  Specimen specimen;
  specimen.label = test::crossing_bars;
  specimen.conditions = {{"boundary", test::hold(Face::all, "xyz")}};
  const double c = std::cos(0.6), s = std::sin(0.6);
  specimen.conditions[0].second.displacement_gradient = {{c - 1, -s, 0, s, c - 1, 0, 0, 0, 0}};
  const auto balance = specimen.balance(world());
  grid::Vector u(balance->owned_map()), f(balance->owned_map());
  test::fill(balance->halo(), u, [&](const grid::Index3& node, int component) {
    return test::linear_field(specimen.grid(), *specimen.conditions[0].second.displacement_gradient,
                              node, component);
  });
  EXPECT_EQ(balance->internal_force(u, f), 0);
  EXPECT_LT(f.normInf(), 1e-12 * 2430.4 * 4.41);
}

TEST(NewtonSolver, AParticleTurnedInsideOutRejectsTheStepOnAllRanks) {
  const auto balance = two_materials(0.1).balance(world());
  NewtonSolver newton(direct(), *balance);
  grid::Vector u(balance->owned_map());
  test::fill(balance->halo(), u, [](const grid::Index3& node, int c) {
    return node == grid::Index3{2, 2, 2} && c == 1 ? -6.0 : 0.0;
  });
  EXPECT_THROW(newton.solve(u), base::StepRejected);
}

TEST(NewtonSolver, TooFewIterationsRejectTheStep) {
  const auto balance = two_materials(0.4).balance(world());
  SolverParameters parameters = direct();
  parameters.newton_iterations = 1;
  NewtonSolver newton(parameters, *balance);
  grid::Vector u(balance->owned_map()), change(balance->owned_map());
  balance->set_load(1.0);
  balance->supports().impose(1.0, change);
  newton.predict(u, change);
  EXPECT_THROW(newton.solve(u), base::StepRejected);
  // The same solver goes on with a smaller step.
  u.putScalar(0.0);
  change.putScalar(0.0);
  balance->set_load(1e-4);
  balance->supports().impose(1e-4, change);
  newton.predict(u, change);
  EXPECT_NO_THROW(newton.solve(u));
}

TEST(NewtonSolver, AnImpossibleLoadIsRejectedOnAllRanks) {
  const auto balance = two_materials(-0.97).balance(world());
  NewtonSolver newton(direct(), *balance);
  grid::Vector u(balance->owned_map());
  balance->set_load(1.0);
  balance->supports().impose(1.0, u);  // crushes the uppermost layer of elements
  EXPECT_THROW(newton.solve(u), base::StepRejected);
}

// What a step costs: one evaluation of the forces more than it has Newton iterations. The first
// prediction starts from the forces that the unloaded body's reactions were taken from.
TEST(NewtonSolver, EvaluatesForcesOnceMoreThanItIterates) {
  test::Specimen specimen;
  specimen.conditions = test::clamped(0.1);
  int evaluations = 0;
  mechanics::Problem problem = specimen.problem();
  problem.terms = {
      [&](const mechanics::Body&) { return std::make_unique<test::CountingTerm>(evaluations); }};
  const auto world = base::Communicator::world();
  mechanics::MovingBody body(world, specimen.partition(world), specimen.particles(world), problem);
  NewtonSolver newton(SolverParameters{}, body.balance());
  body.balance().reactions(body.displacement());
  int expected = 1;
  EXPECT_EQ(evaluations, expected);
  for (int step = 1; step <= 4; ++step) {
    begin_step(body, newton);
    grid::Vector trial(body.balance().owned_map());
    const int iterations = solve_step(body, newton, 0.25 * step, trial).iterations;
    body.accept(0.25 * step, trial);
    body.balance().reactions(trial);
    expected += iterations + 1;
    EXPECT_EQ(evaluations, expected) << "step " << step << ", " << iterations << " iterations";
  }
}

}  // namespace
}  // namespace stroma::solver
