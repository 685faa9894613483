// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Every preconditioner leads to the same displacement; factors are exact. Claim V-LIN-1,
/// docs/verification.md.

#include <gtest/gtest.h>

#include "stroma/solver/NewtonSolver.hpp"
#include "stroma/solver/Preconditioner.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma::solver {
namespace {

using test::Specimen;

struct Outcome {
  grid::Vector u;
  NewtonResult result;
};

Outcome solve(mechanics::MomentumBalance& balance, PreconditionerKind kind) {
  SolverParameters parameters;
  parameters.preconditioner = kind;
  parameters.newton_tolerance = 1e-11;
  parameters.linear_tolerance = 1e-8;
  parameters.forcing = Forcing::constant;
  NewtonSolver newton(parameters, balance);
  Outcome outcome{grid::Vector(balance.owned_map()), {}};
  grid::Vector change(balance.owned_map());
  balance.set_load(1.0);
  balance.supports().impose(1.0, change);
  newton.predict(outcome.u, change);
  outcome.result = newton.solve(outcome.u);
  return outcome;
}

void expect_same_answers(const Specimen& specimen) {
  const auto balance = specimen.balance(world());
  const Outcome direct = solve(*balance, PreconditionerKind::direct);
  const double size = direct.u.normInf();
  ASSERT_GT(size, 0.0);
  for (const auto kind : {PreconditionerKind::geometric_multigrid, PreconditionerKind::jacobi,
                          PreconditionerKind::chebyshev, PreconditionerKind::multigrid}) {
    Outcome other = solve(*balance, kind);
    EXPECT_EQ(other.result.iterations, direct.result.iterations);
    other.u.update(-1.0, direct.u, 1.0);
    EXPECT_LT(other.u.normInf(), 1e-9 * size) << "preconditioner " << static_cast<int>(kind);
  }
}

TEST(Preconditioner, AllLeadToTheSameDisplacement) {
  Specimen specimen;
  specimen.elements = {6, 6, 6};
  specimen.label = test::crossing_bars;
  specimen.conditions = test::clamped(0.1);
  expect_same_answers(specimen);
}

// Empty space, rollers and held rigid motions: rows of the matrix that hold only a diagonal.
TEST(Preconditioner, AllCopeWithNodesOutsideTheBody) {
  Specimen specimen;
  specimen.elements = {5, 5, 5};
  specimen.label = [](const grid::Index3& voxel) {
    return voxel[0] >= 6 && voxel[2] >= 6 ? -1 : 0;
  };
  specimen.conditions = {{"bottom", test::hold(mechanics::Face::y_lower, "y")},
                         {"top", test::stretch(mechanics::Face::y_upper, "y", 0.1)}};
  expect_same_answers(specimen);
}

TEST(Preconditioner, AllCopeWithPlaneStrain) {
  Specimen specimen;
  specimen.elements = {8, 8, 1};
  specimen.label = test::crossing_bars;
  specimen.plane_strain = true;
  specimen.conditions = test::clamped(0.1);
  expect_same_answers(specimen);
}

// New factors solve at once; those of an earlier matrix still precondition, and are renewed when
// they no longer do.
TEST(Preconditioner, FactorsAreExactAndOutliveSmallChanges) {
  Specimen specimen;
  specimen.label = test::crossing_bars;
  specimen.conditions = test::clamped(0.1);
  const auto balance = specimen.balance(world());
  SolverParameters parameters;
  parameters.preconditioner = PreconditionerKind::direct;
  LinearSolver linear(parameters, *balance);
  grid::Vector u(balance->owned_map()), b(balance->owned_map()), x(balance->owned_map());
  test::fill(balance->halo(), b,
             [](const grid::Index3& node, int c) { return test::scatter(node, c); });
  balance->supports().clear(b);
  for (const double size : {0.0, 0.05, 0.3}) {
    test::fill(balance->halo(), u,
               [&](const grid::Index3& node, int c) { return size * test::scatter(node, c, 1); });
    balance->assemble_tangent(u);
    linear.set_tangent(balance->tangent());
    const LinearResult result = linear.solve(b, x, 1e-10);
    ASSERT_TRUE(result.converged) << "displacements of " << size << " um";
    EXPECT_LE(result.iterations, size == 0.0 ? 2 : 200);
    grid::Vector residual(b, Teuchos::Copy);
    balance->tangent_matrix()->apply(x, residual, Teuchos::NO_TRANS, -1.0, 1.0);
    EXPECT_LT(residual.norm2(), 1e-9 * b.norm2());
  }
}

}  // namespace
}  // namespace stroma::solver
