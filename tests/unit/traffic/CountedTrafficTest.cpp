// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What the arithmetic says against what MPI is really given to send.

#include <gtest/gtest.h>

#include "stroma/multigrid/GeometricMultigrid.hpp"
#include "stroma/solver/IterationTraffic.hpp"
#include "stroma/solver/LinearSolver.hpp"
#include "support/Specimen.hpp"
#include "unit/traffic/CountedMpi.hpp"

namespace stroma::test {
namespace {

using solver::PreconditionerKind;

Specimen block() {
  Specimen specimen;
  specimen.elements = {24, 23, 22};  // so many that the multigrid has a coarser level
  specimen.conditions = clamped(0.1);
  return specimen;
}

void expect_equal(const grid::Traffic& real, const grid::Traffic& said) {
  EXPECT_EQ(real.neighbours, said.neighbours);
  EXPECT_EQ(real.messages, said.messages);
  EXPECT_EQ(real.bytes, said.bytes);
  EXPECT_EQ(real.reductions, said.reductions);
  EXPECT_EQ(real.reduced_bytes, said.reduced_bytes);
}

class CountedTraffic : public ::testing::Test {
 protected:
  base::Communicator world = base::Communicator::world();
  Specimen specimen = block();
  std::unique_ptr<mechanics::MomentumBalance> balance = specimen.balance(world);
  const grid::Partition& partition = balance->halo().partition();
  grid::Vector u{balance->owned_map()}, v{balance->owned_map()}, product{balance->owned_map()};

  /// The traffic of a solve to a tolerance, and its iterations.
  std::pair<grid::Traffic, int> solve(PreconditionerKind kind, double tolerance) {
    solver::SolverParameters parameters;
    parameters.preconditioner = kind;
    solver::LinearSolver linear(parameters, *balance);
    linear.set_tangent(balance->tangent());
    int iterations = 0;
    const auto traffic =
        counted([&] { iterations = linear.solve(v, product, tolerance).iterations; });
    return {traffic, iterations};
  }

  /// From two solves: what one more iteration sends.
  void expect_iteration(PreconditionerKind kind) {
    fill(balance->halo(), v, [](const grid::Index3& node, int c) { return scatter(node, c); });
    balance->supports().clear(v);
    const auto [few, low] = solve(kind, 1e-2);
    const auto [many, high] = solve(kind, 1e-7);
    const int more = high - low;
    ASSERT_GT(more, 2);
    const grid::Traffic said = solver::iteration_traffic(partition, world.rank(), kind).total();
    EXPECT_EQ(many.messages - few.messages, more * said.messages);
    EXPECT_EQ(many.bytes - few.bytes, more * said.bytes);
    EXPECT_EQ(many.reductions - few.reductions, more * said.reductions);
    EXPECT_EQ(many.reduced_bytes - few.reduced_bytes, more * said.reduced_bytes);
    EXPECT_EQ(many.neighbours, said.neighbours);
  }
};

// V-TRAFFIC.
TEST_F(CountedTraffic, OfAProductOfRows) {
  balance->assemble_tangent(u);
  const auto rows = balance->tangent_matrix();
  rows->apply(v, product);
  expect_equal(counted([&] { rows->apply(v, product); }),
               grid::rows_product_traffic(partition, world.rank()));
}

TEST_F(CountedTraffic, OfAProductOfTheStencil) {
  balance->choose_tangent(mechanics::TangentForm::stencil);
  balance->assemble_tangent(u);
  const auto kind = PreconditionerKind::geometric_multigrid;
  expect_equal(counted([&] { balance->tangent()->apply(v, product); }),
               solver::iteration_traffic(partition, world.rank(), kind).product);
}

TEST_F(CountedTraffic, OfACycle) {
  balance->choose_tangent(mechanics::TangentForm::stencil);
  balance->assemble_tangent(u);
  const auto stencil =
      Teuchos::rcp_dynamic_cast<const tangent::StencilMatrix>(balance->tangent(), true);
  multigrid::GeometricMultigrid multigrid(stencil, partition.grid().spacing);
  multigrid.compute();
  ASSERT_GT(multigrid.levels(), 1);
  const auto kind = PreconditionerKind::geometric_multigrid;
  expect_equal(counted([&] { multigrid.apply(v, product); }),
               *solver::iteration_traffic(partition, world.rank(), kind).preconditioner);
}

TEST_F(CountedTraffic, OfAnIterationWithJacobi) {
  balance->assemble_tangent(u);
  expect_iteration(PreconditionerKind::jacobi);
}

TEST_F(CountedTraffic, OfAnIterationWithGeometricMultigrid) {
  balance->choose_tangent(mechanics::TangentForm::stencil);
  balance->assemble_tangent(u);
  expect_iteration(PreconditionerKind::geometric_multigrid);
}

}  // namespace
}  // namespace stroma::test
