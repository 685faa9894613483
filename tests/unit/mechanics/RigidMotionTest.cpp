// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Rigid motions that the conditions leave free are found, counted and held. Claim V-SUP-1,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <set>

#include "stroma/mechanics/conditions/RigidMotion.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma::mechanics {
namespace {

using test::hold;
using test::Specimen;
using test::stretch;

std::vector<NodeComponent> holds(const NamedConditions& conditions, bool plane_strain = false,
                                 const grid::Index3& elements = {4, 4, 4}) {
  Specimen specimen;
  specimen.elements = elements;
  specimen.conditions = conditions;
  specimen.plane_strain = plane_strain;
  return specimen.balance(world())->supports().rigid_holds();
}

TEST(RigidMotion, ClampedBodiesNeedNothing) {
  EXPECT_EQ(holds(test::clamped(0.1)).size(), 0u);
  EXPECT_EQ(holds({{"bottom", hold(Face::y_lower, "xyz")}}).size(), 0u);
}

TEST(RigidMotion, SymmetryPlanesNeedNothing) {
  EXPECT_EQ(holds({{"x", hold(Face::x_lower, "x")},
                   {"y", hold(Face::y_lower, "y")},
                   {"z", hold(Face::z_lower, "z")}})
                .size(),
            0u);
}

// Rollers at top and bottom leave two translations and the rotation about y.
TEST(RigidMotion, RollersLeaveThree) {
  const auto held =
      holds({{"bottom", hold(Face::y_lower, "y")}, {"top", stretch(Face::y_upper, "y", 0.1)}});
  ASSERT_EQ(held.size(), 3u);
  for (const NodeComponent& hold : held) EXPECT_NE(hold.component, 1) << "y is prescribed";
  // The first two stand at one node, the third elsewhere, straight along an axis from it.
  EXPECT_EQ(held[0].node, held[1].node);
  EXPECT_NE(held[0].component, held[1].component);
  int axes_apart = 0;
  for (std::size_t d = 0; d < 3; ++d)
    axes_apart += std::abs(held[2].position[d] - held[0].position[d]) > 1e-9 ? 1 : 0;
  EXPECT_EQ(axes_apart, 1);
}

TEST(RigidMotion, PlaneStrainRollersLeaveOne) {
  const auto held =
      holds({{"bottom", hold(Face::y_lower, "y")}, {"top", stretch(Face::y_upper, "y", 0.1)}}, true,
            {6, 6, 1});
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].component, 0);
}

TEST(RigidMotion, AFreeBodyHasSix) {
  const auto held = holds({});
  ASSERT_EQ(held.size(), 6u);
  std::set<std::pair<std::int64_t, int>> distinct;
  for (const NodeComponent& hold : held) distinct.emplace(hold.node, hold.component);
  EXPECT_EQ(distinct.size(), 6u);
}

TEST(RigidMotion, OneRollerFaceLeavesThree) {
  EXPECT_EQ(holds({{"wall", hold(Face::x_upper, "x")}}).size(), 3u);
}

TEST(RigidMotion, AHingeIsFound) {
  // x and y held on z-, x and y on z+: nothing stops the drift along z.
  const auto held = holds({{"a", hold(Face::z_lower, "xy")}, {"b", hold(Face::z_upper, "xy")}});
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].component, 2);
}

// The choice must not depend on the ranks: positions and components as on one rank.
TEST(RigidMotion, TheHoldsDoNotDependOnTheRanks) {
  for (const grid::Index3& elements : {grid::Index3{4, 4, 4}, grid::Index3{5, 3, 6}}) {
    Specimen specimen;
    specimen.elements = elements;
    specimen.conditions = {{"bottom", hold(Face::y_lower, "y")}};
    const auto together = specimen.balance(world());
    const auto alone = specimen.balance(base::Communicator::self());
    const auto& a = together->supports().rigid_holds();
    const auto& b = alone->supports().rigid_holds();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t n = 0; n < a.size(); ++n) {
      EXPECT_EQ(a[n].position, b[n].position) << "hold " << n;
      EXPECT_EQ(a[n].component, b[n].component) << "hold " << n;
    }
  }
}

}  // namespace
}  // namespace stroma::mechanics
