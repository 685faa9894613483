// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The tangent as a stencil: the compressed matrix's products, half the blocks, the same on any
/// number of ranks. Claim V-TAN-4, docs/verification.md.

#include <gtest/gtest.h>

#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma::mechanics {
namespace {

using test::Specimen;

/// Two materials, empty space in a corner, and faces that hold some components only; as a block, or
/// as a slice in plane strain.
class StencilTangent : public ::testing::TestWithParam<bool> {
 protected:
  static Specimen specimen() {
    Specimen specimen;
    specimen.elements = {11, 4, 6};
    specimen.label = [](const grid::Index3& voxel) {
      return voxel[0] > 7 && voxel[1] > 5 && voxel[2] > 7 ? -1 : test::crossing_bars(voxel);
    };
    specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")},
                           {"side", test::hold(Face::z_lower, "z")},
                           {"top", test::stretch(Face::y_upper, "y", 0.1)},
                           {"springs", test::stretch(Face::x_upper, "xy", 0.1)}};
    specimen.conditions.back().second.imposed_by = ImposedBy::penalty;
    specimen.conditions.back().second.penalty_factor = 10.0;
    if (GetParam()) {
      specimen.elements = {9, 6, 1};
      specimen.plane_strain = true;
      specimen.label = [](const grid::Index3& voxel) {
        return voxel[0] > 9 && voxel[1] > 7 ? -1 : test::crossing_bars({voxel[0], voxel[1], 4});
      };
    }
    return specimen;
  }
};
INSTANTIATE_TEST_SUITE_P(Bodies, StencilTangent, ::testing::Bool(),
                         [](const auto& slice) { return slice.param ? "slice" : "block"; });

grid::Vector scattered(const MomentumBalance& balance, int seed, double size) {
  grid::Vector u(balance.owned_map());
  test::fill(balance.halo(), u,
             [&](const grid::Index3& node, int c) { return size * test::scatter(node, c, seed); });
  return u;
}

grid::Vector times(MomentumBalance& balance, TangentForm form, const grid::Vector& v) {
  balance.choose_tangent(form);
  EXPECT_EQ(balance.assemble_tangent(scattered(balance, 0, 0.15)), 0);
  grid::Vector product(balance.owned_map());
  balance.tangent()->apply(v, product);
  return product;
}

TEST_P(StencilTangent, HasTheProductsOfTheCompressedMatrix) {
  const auto balance = specimen().balance(world());
  for (int seed = 1; seed < 4; ++seed) {
    const grid::Vector v = scattered(*balance, seed, 1.0);
    const grid::Vector expected = times(*balance, TangentForm::compressed_rows, v);
    grid::Vector product = times(*balance, TangentForm::stencil, v);
    product.update(-1.0, expected, 1.0);
    EXPECT_LT(product.normInf(), 1e-6 * expected.normInf());  // single precision
    EXPECT_GT(product.normInf(), 0.0);                        // it was another matrix
  }
}

TEST_P(StencilTangent, AddsToWhatIsThere) {
  const auto balance = specimen().balance(world());
  const grid::Vector v = scattered(*balance, 1, 1.0), w = scattered(*balance, 2, 1.0);
  const grid::Vector Kv = times(*balance, TangentForm::stencil, v);
  grid::Vector sum(w, Teuchos::Copy), expected(w, Teuchos::Copy);
  balance->tangent()->apply(v, sum, Teuchos::NO_TRANS, -2.0, 3.0);
  expected.update(-2.0, Kv, 3.0);
  expected.update(-1.0, sum, 1.0);
  EXPECT_LT(expected.normInf(), 1e-13 * Kv.normInf());
}

// Exactly, for one block serves both of its rows: what is left is the rounding of the dot products.
TEST_P(StencilTangent, IsSymmetric) {
  const auto balance = specimen().balance(world());
  const grid::Vector v = scattered(*balance, 1, 1.0), w = scattered(*balance, 2, 1.0);
  const grid::Vector Kw = times(*balance, TangentForm::stencil, w);
  const grid::Vector Kv = times(*balance, TangentForm::stencil, v);
  EXPECT_NEAR(v.dot(Kw), w.dot(Kv), 1e-13 * v.norm2() * Kw.norm2());
}

TEST_P(StencilTangent, PrescribedComponentsAreDecoupled) {
  const auto balance = specimen().balance(world());
  grid::Vector free = scattered(*balance, 1, 1.0), held(free, Teuchos::Copy);
  balance->supports().clear(free);
  held.update(-1.0, free, 1.0);
  grid::Vector K_held = times(*balance, TangentForm::stencil, held);
  EXPECT_GT(K_held.norm2(), 0.0);
  balance->supports().clear(K_held);
  EXPECT_EQ(K_held.norm2(), 0.0);
  const grid::Vector K_free = times(*balance, TangentForm::stencil, free);
  grid::Vector cleared(K_free, Teuchos::Copy);
  balance->supports().clear(cleared);
  cleared.update(-1.0, K_free, 1.0);
  EXPECT_EQ(cleared.norm2(), 0.0);
}

TEST_P(StencilTangent, AssemblyAndProductsAreReproducible) {
  const auto balance = specimen().balance(world());
  const grid::Vector v = scattered(*balance, 1, 1.0);
  const grid::Vector first = times(*balance, TangentForm::stencil, v);
  balance->assemble_tangent(scattered(*balance, 3, 0.1));
  grid::Vector second = times(*balance, TangentForm::stencil, v);
  second.update(-1.0, first, 1.0);
  EXPECT_EQ(second.normInf(), 0.0);
}

// Every rank also solves the whole problem by itself: the products must agree at its own nodes.
TEST_P(StencilTangent, ProductsDoNotDependOnTheRanks) {
  const Specimen body = specimen();
  const auto together = body.balance(world());
  const auto alone = body.balance(base::Communicator::self());
  const grid::Vector product = times(*together, TangentForm::stencil, scattered(*together, 1, 1.0));
  const grid::Vector whole = times(*alone, TangentForm::stencil, scattered(*alone, 1, 1.0));
  const grid::Box nodes = body.grid().all_nodes();
  const auto expected = whole.getLocalViewHost(Tpetra::Access::ReadOnly);
  const double size = whole.normInf();
  test::for_each_unknown(together->halo(), product,
                         [&](const grid::Index3& node, int c, double value) {
                           EXPECT_NEAR(value, expected(3 * nodes.local(node) + c, 0), 1e-6 * size);
                         });
}

}  // namespace
}  // namespace stroma::mechanics
