// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The assembled tangent: derivative of the residual, symmetric, and the same on any number of
/// ranks. Claims V-TAN-1 to V-TAN-3, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma::mechanics {
namespace {

using test::Specimen;

/// Two materials, empty space in a corner, and faces that hold some components only, one of them by
/// springs; as a block, or as a slice in plane strain, whose upper and lower nodes are one.
Specimen mixed_specimen(bool slice) {
  Specimen specimen;
  specimen.elements = {5, 4, 6};
  specimen.label = [](const grid::Index3& voxel) {
    return voxel[0] > 7 && voxel[1] > 5 && voxel[2] > 7 ? -1 : test::crossing_bars(voxel);
  };
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")},
                         {"side", test::hold(Face::z_lower, "z")},
                         {"top", test::stretch(Face::y_upper, "y", 0.1)},
                         {"springs", test::stretch(Face::x_upper, "xy", 0.1)}};
  specimen.conditions.back().second.imposed_by = ImposedBy::penalty;
  specimen.conditions.back().second.penalty_factor = 10.0;
  if (slice) {
    specimen.elements = {7, 6, 1};
    specimen.plane_strain = true;
    specimen.label = [](const grid::Index3& voxel) {
      return voxel[0] > 9 && voxel[1] > 7 ? -1 : test::crossing_bars({voxel[0], voxel[1], 4});
    };
  }
  return specimen;
}

class AssembledTangent : public ::testing::TestWithParam<bool> {
 protected:
  static Specimen specimen() { return mixed_specimen(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Bodies, AssembledTangent, ::testing::Bool(),
                         [](const auto& slice) { return slice.param ? "slice" : "block"; });

grid::Vector displacement(const MomentumBalance& balance, int seed, double size) {
  grid::Vector u(balance.owned_map());
  test::fill(balance.halo(), u,
             [&](const grid::Index3& node, int c) { return size * test::scatter(node, c, seed); });
  return u;
}

grid::Vector times(MomentumBalance& balance, const grid::Vector& v) {
  grid::Vector product(balance.owned_map());
  balance.tangent_matrix()->apply(v, product);
  return product;
}

TEST_P(AssembledTangent, IsTheDerivativeOfTheResidual) {
  const auto balance = specimen().balance(world());
  const grid::Vector u = displacement(*balance, 0, 0.15);
  grid::Vector v = displacement(*balance, 1, 1.0);
  balance->supports().clear(v);
  EXPECT_EQ(balance->assemble_tangent(u), 0);
  const grid::Vector Kv = times(*balance, v);
  const auto error = [&](double h) {
    grid::Vector high(u, Teuchos::Copy), low(u, Teuchos::Copy);
    high.update(h, v, 1.0);
    low.update(-h, v, 1.0);
    grid::Vector r_high(balance->owned_map()), r_low(balance->owned_map());
    balance->residual(high, r_high);
    balance->residual(low, r_low);
    r_high.update(-0.5 / h, r_low, 0.5 / h);
    r_high.update(-1.0, Kv, 1.0);
    return r_high.norm2();
  };
  for (const double h : {1e-2, 5e-3, 2.5e-3})
    EXPECT_NEAR(std::log2(error(h) / error(h / 2)), 2.0, 0.1) << "at h = " << h;
  EXPECT_LT(error(1e-5), 1e-7 * Kv.norm2());
}

TEST_P(AssembledTangent, AgreesWithTheProductThatFormsNoMatrix) {
  const auto balance = specimen().balance(world());
  const grid::Vector u = displacement(*balance, 0, 0.15);
  grid::Vector v = displacement(*balance, 1, 1.0);
  balance->supports().clear(v);
  balance->assemble_tangent(u);
  const grid::Vector Kv = times(*balance, v);
  grid::Vector product(balance->owned_map());
  balance->tangent_times(u, v, product);
  balance->supports().clear(product);
  product.update(-1.0, Kv, 1.0);
  EXPECT_LT(product.normInf(), 1e-13 * Kv.normInf());
}

// V-TAN-2.
TEST_P(AssembledTangent, IsSymmetric) {
  const auto balance = specimen().balance(world());
  balance->assemble_tangent(displacement(*balance, 0, 0.15));
  const grid::Vector v = displacement(*balance, 1, 1.0), w = displacement(*balance, 2, 1.0);
  const grid::Vector Kw = times(*balance, w);
  EXPECT_NEAR(v.dot(Kw), w.dot(times(*balance, v)), 1e-13 * v.norm2() * Kw.norm2());
}

TEST_P(AssembledTangent, IsPositiveDefiniteAtRest) {
  const auto balance = specimen().balance(world());
  balance->assemble_tangent(grid::Vector(balance->owned_map()));
  for (int seed = 1; seed < 6; ++seed) {
    const grid::Vector v = displacement(*balance, seed, 1.0);
    EXPECT_GT(v.dot(times(*balance, v)), 0.0);
  }
}

// Rows and columns of prescribed components hold only a diagonal.
TEST_P(AssembledTangent, PrescribedComponentsAreDecoupled) {
  const auto balance = specimen().balance(world());
  balance->assemble_tangent(displacement(*balance, 0, 0.15));
  const grid::Vector all = displacement(*balance, 1, 1.0);
  grid::Vector free(all, Teuchos::Copy);
  balance->supports().clear(free);
  grid::Vector held(all, Teuchos::Copy);
  held.update(-1.0, free, 1.0);
  grid::Vector K_held = times(*balance, held);
  EXPECT_GT(K_held.norm2(), 0.0);
  balance->supports().clear(K_held);
  EXPECT_EQ(K_held.norm2(), 0.0);  // no column leads from held to free
  grid::Vector K_free = times(*balance, free), cleared(K_free, Teuchos::Copy);
  balance->supports().clear(cleared);
  K_free.update(-1.0, cleared, 1.0);
  EXPECT_EQ(K_free.norm2(), 0.0);  // nor from free to held
}

// Every rank also solves the whole problem by itself: the products must agree at its own nodes.
TEST_P(AssembledTangent, ProductsDoNotDependOnTheRanks) {
  const Specimen body = specimen();
  const auto together = body.balance(world());
  const auto alone = body.balance(base::Communicator::self());
  together->assemble_tangent(displacement(*together, 0, 0.15));
  alone->assemble_tangent(displacement(*alone, 0, 0.15));
  const grid::Vector product = times(*together, displacement(*together, 1, 1.0));
  const grid::Vector whole = times(*alone, displacement(*alone, 1, 1.0));
  const grid::Box nodes = body.grid().all_nodes();
  const auto expected = whole.getLocalViewHost(Tpetra::Access::ReadOnly);
  const double size = whole.normInf();
  test::for_each_unknown(together->halo(), product,
                         [&](const grid::Index3& node, int c, double value) {
                           EXPECT_NEAR(value, expected(3 * nodes.local(node) + c, 0), 1e-13 * size);
                         });

  grid::Vector f(together->owned_map()), f_whole(alone->owned_map());
  together->internal_force(displacement(*together, 0, 0.15), f);
  alone->internal_force(displacement(*alone, 0, 0.15), f_whole);
  const auto force = f_whole.getLocalViewHost(Tpetra::Access::ReadOnly);
  const double force_size = f_whole.normInf();
  test::for_each_unknown(together->halo(), f, [&](const grid::Index3& node, int c, double value) {
    EXPECT_NEAR(value, force(3 * nodes.local(node) + c, 0), 1e-13 * force_size);
  });
  EXPECT_EQ(together->supports().unknowns(), alone->supports().unknowns());
}

// A second assembly at the same place gives the same bits: sums have one order.
TEST_P(AssembledTangent, AssemblyIsReproducible) {
  const auto balance = specimen().balance(world());
  const grid::Vector u = displacement(*balance, 0, 0.15), v = displacement(*balance, 1, 1.0);
  balance->assemble_tangent(u);
  const grid::Vector first = times(*balance, v);
  balance->assemble_tangent(displacement(*balance, 3, 0.1));
  balance->assemble_tangent(u);
  grid::Vector second = times(*balance, v);
  second.update(-1.0, first, 1.0);
  EXPECT_EQ(second.normInf(), 0.0);
}

}  // namespace
}  // namespace stroma::mechanics
