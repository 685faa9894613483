// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Forces are evaluated once at each displacement. Claim V-TERM-2, docs/verification.md.

#include <gtest/gtest.h>

#include <limits>

#include "support/CountingTerm.hpp"
#include "support/Specimen.hpp"

namespace stroma::mechanics {
namespace {

TEST(ForceBalance, IsEvaluatedOnceAtEachDisplacementAndLoad) {
  const auto world = base::Communicator::world();
  test::Specimen specimen;
  specimen.conditions = test::clamped(0.1);
  int steady = 0, loaded = 0;
  Problem problem = specimen.problem();
  problem.terms = {[&](const Body&) { return std::make_unique<test::CountingTerm>(steady, false); },
                   [&](const Body&) { return std::make_unique<test::CountingTerm>(loaded, true); }};
  MomentumBalance balance(world, specimen.partition(world), specimen.particles(world), problem);
  grid::Vector u(balance.owned_map()), r(balance.owned_map());
  test::fill(balance.halo(), u,
             [](const grid::Index3& node, int c) { return 0.01 * test::scatter(node, c); });

  balance.residual(u, r);
  EXPECT_EQ(steady, 1);
  EXPECT_EQ(loaded, 1);
  const double scale = balance.forces(u).scale;
  balance.reactions(u);
  balance.assemble_tangent(u);
  EXPECT_EQ(steady, 1);
  EXPECT_EQ(loaded, 1);

  balance.set_load(0.5);
  balance.residual(u, r);
  EXPECT_EQ(steady, 1);
  EXPECT_EQ(loaded, 2);
  EXPECT_EQ(balance.forces(u).scale, scale);

  // The last bit of one component on one rank makes another displacement, for all of them.
  if (world.is_root()) {
    const auto values = u.getLocalViewHost(Tpetra::Access::ReadWrite);
    values(0, 0) *= 1.0 + std::numeric_limits<double>::epsilon();
  }
  balance.residual(u, r);
  EXPECT_EQ(steady, 2);
  EXPECT_EQ(loaded, 3);
}

}  // namespace
}  // namespace stroma::mechanics
