// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Prescribed components: their values, their reactions, and contradictions between conditions.

#include <gtest/gtest.h>

#include "Refusal.hpp"
#include "stroma/mechanics/conditions/Supports.hpp"

namespace stroma::mechanics {
namespace {

using test::hold;
using test::Specimen;
using test::stretch;

TEST(Supports, ImposeTheLoadFactorsShare) {
  Specimen specimen;
  specimen.conditions = test::clamped(0.1);
  const auto balance = specimen.balance(world());
  grid::Vector u(balance->owned_map());
  u.putScalar(7.0);
  balance->supports().impose(0.5, u);
  test::for_each_unknown(balance->halo(), u, [](const grid::Index3& node, int c, double value) {
    const bool prescribed = node[1] == 0 || node[1] == 4;
    const double moved = node[1] == 4 && c == 1 ? 0.5 * 0.1 * 8.4 : 0.0;
    EXPECT_NEAR(value, prescribed ? moved : 7.0, 1e-15);
  });
  EXPECT_EQ(balance->supports().unknowns(), 3 * 25 * 3);
  balance->supports().clear(u);
  test::for_each_unknown(balance->halo(), u, [](const grid::Index3& node, int, double value) {
    EXPECT_EQ(value, node[1] == 0 || node[1] == 4 ? 0.0 : 7.0);
  });
}

TEST(Supports, ReactionsAreTheInternalForcesOfEachCondition) {
  Specimen specimen;
  specimen.conditions = test::clamped(0.1);
  const auto balance = specimen.balance(world());
  grid::Vector force(balance->owned_map());
  test::fill(balance->halo(), force, [](const grid::Index3& node, int c) {
    return node[1] == 0 ? 1.0 + c : node[1] == 4 ? -10.0 : 1000.0;
  });
  const auto reactions = balance->supports().reactions(force);
  ASSERT_EQ(reactions.size(), 2u);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(reactions[0][c], 25.0 * static_cast<double>(1 + c), 1e-12);
    EXPECT_NEAR(reactions[1][c], -250.0, 1e-12);
  }
  EXPECT_NEAR(balance->supports().reaction_norm(force),
              std::sqrt(25.0 * (1 + 4 + 9) + 75.0 * 100.0), 1e-10);
}

// V-SUP-2.
TEST(Supports, ContradictionsAreNamed) {
  Specimen specimen;
  specimen.conditions = {{"floor", hold(Face::y_lower, "xyz")}, {"wall", hold(Face::x_lower, "y")}};
  specimen.conditions[1].second.displacement = {{0.0, 0.3, 0.0}};
  const std::string message = refusal(specimen);
  EXPECT_NE(message.find("floor"), std::string::npos) << message;
  EXPECT_NE(message.find("wall"), std::string::npos) << message;
  EXPECT_NE(message.find("y displacement"), std::string::npos) << message;
}

TEST(Supports, EqualValuesAreNoContradiction) {
  Specimen specimen;
  specimen.conditions = {{"floor", hold(Face::y_lower, "xyz")}, {"wall", hold(Face::x_lower, "x")}};
  EXPECT_EQ(refusal(specimen), "");
}

TEST(Supports, PlaneStrainAllowsNoMotionAlongZ) {
  Specimen specimen;
  specimen.elements = {4, 4, 1};
  specimen.plane_strain = true;
  specimen.conditions = {{"pull", hold(Face::z_upper, "z")}};
  EXPECT_EQ(refusal(specimen), "");
  specimen.conditions[0].second.displacement = {{0.0, 0.0, 0.2}};
  const std::string message = refusal(specimen);
  EXPECT_NE(message.find("pull"), std::string::npos) << message;
  EXPECT_NE(message.find("Plane Strain holds z"), std::string::npos) << message;
  specimen.conditions = {{"held", hold(Face::z_lower, "z")}, specimen.conditions[0]};
  EXPECT_EQ(refusal(specimen), message);  // the same nodes: not a matter of the two
}

// What counts is the displacement by the curve, not the full one.
TEST(Supports, DisplacementsTooFarAreRefused) {
  const auto moved = [](double displacement, double factor) {
    Specimen specimen;
    specimen.conditions = {{"held", hold(Face::y_lower, "xyz")},
                           {"moved", hold(Face::y_upper, "y")}};
    specimen.conditions[1].second.displacement = {{0.0, displacement, 0.0}};
    specimen.conditions[1].second.curve.loads = {0.0, 1.0};
    specimen.conditions[1].second.curve.values = {0.0, factor};
    return refusal(specimen);
  };
  EXPECT_EQ(moved(1e7, 1e-7), "");
  const std::string message = moved(1.0, 1e7);
  EXPECT_NE(message.find("the displacement over the body's longest edge is 1.19e+06"),
            std::string::npos)
      << message;
}

TEST(Supports, AFaceInEmptySpaceIsAnInputError) {
  Specimen specimen;
  specimen.label = [](const grid::Index3& voxel) { return voxel[1] >= 6 ? -1 : 0; };
  specimen.conditions = test::clamped(0.1);
  const std::string message = refusal(specimen);
  EXPECT_NE(message.find("top"), std::string::npos) << message;
  EXPECT_NE(message.find("no particle"), std::string::npos) << message;
}

// Nodes that no particle touches leave the system: the upper quarter of the block is empty.
TEST(Supports, UntouchedNodesAreNoUnknowns) {
  Specimen specimen;
  specimen.label = [](const grid::Index3& voxel) { return voxel[1] >= 6 ? -1 : 0; };
  specimen.conditions = {{"bottom", hold(Face::y_lower, "xyz")}};
  EXPECT_EQ(specimen.balance(world())->supports().unknowns(), 3 * 25 * 3);
}

}  // namespace
}  // namespace stroma::mechanics
