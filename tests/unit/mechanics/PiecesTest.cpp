// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Connected pieces of a body: how many there are on any number of ranks, which of them leave the
/// system, and which bodies nothing holds against their loads. Claim V-SUP-3, docs/verification.md.

#include <gtest/gtest.h>

#include <random>

#include "Refusal.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/mechanics/conditions/PieceStatics.hpp"

namespace stroma::mechanics {
namespace {

using test::hold;
using test::Specimen;
using test::stretch;

PiecesSummary pieces_of(const Specimen& specimen) {
  return specimen.balance(world())->supports().pieces();
}

void expect_told(const std::string& message, const std::vector<std::string>& told) {
  for (const std::string& text : told)
    EXPECT_NE(message.find(text), std::string::npos) << "not told: " << text << "\n" << message;
}

NamedForces body_force(const std::array<double, 3>& f) {
  ExternalForce force;
  force.body_force = f;
  return {{"f", force}};
}

ExternalForce traction(Face face, const std::array<double, 3>& t) {
  ExternalForce force;
  force.face = face;
  force.traction = t;
  return force;
}

/// A block of 4^3 elements, held at the bottom, whose upper layer of elements is empty but for an
/// island of one element.
Specimen with_island() {
  Specimen specimen;
  specimen.elements = {4, 5, 4};
  specimen.label = [](const grid::Index3& voxel) {
    const bool is_island = voxel[1] >= 8 && voxel[0] >= 6 && voxel[2] >= 6;
    return voxel[1] < 6 || is_island ? 0 : -1;
  };
  specimen.conditions = {{"bottom", hold(Face::y_lower, "xyz")},
                         {"side", hold(Face::x_lower, "xyz")}};
  specimen.conditions[1].second.displacement_gradient = {{0.0, 0.1, 0.0, 0, 0, 0, 0, 0, 0}};
  return specimen;
}

TEST(Pieces, AreElementsThatShareNoNode) {
  Specimen specimen;
  EXPECT_EQ(pieces_of(specimen).count, 1);
  specimen.label = [](const grid::Index3& voxel) { return voxel[1] == 3 ? -1 : 0; };
  EXPECT_EQ(pieces_of(specimen).count, 1) << "half an element is no gap";
  specimen.label = [](const grid::Index3& voxel) { return voxel[1] / 2 == 1 ? -1 : 0; };
  EXPECT_EQ(pieces_of(specimen).count, 2);
  specimen.label = [](const grid::Index3& voxel) {  // two that meet at a corner
    return voxel[0] / 4 == voxel[1] / 4 && voxel[1] / 4 == voxel[2] / 4 ? 0 : -1;
  };
  EXPECT_EQ(pieces_of(specimen).count, 1);
  specimen.label = [](const grid::Index3& voxel) {  // every other element
    return voxel[0] / 2 % 2 == 0 && voxel[1] / 2 % 2 == 0 && voxel[2] / 2 % 2 == 0 ? 0 : -1;
  };
  const PiecesSummary summary = pieces_of(specimen);
  EXPECT_EQ(summary.count, 8);
  EXPECT_EQ(summary.elements, 8);
  EXPECT_EQ(summary.particles, 64);
}

// A path that crosses the borders of ranks again and again.
TEST(Pieces, AreTheSameOnAnyNumberOfRanks) {
  Specimen specimen;
  specimen.elements = {9, 9, 3};
  const auto path = [](int missing) {
    return [missing](const grid::Index3& voxel) {
      const std::int64_t x = voxel[0] / 2, y = voxel[1] / 2;
      const bool is_bridge = y % 2 == 1 && y != missing && x == (y % 4 == 1 ? 8 : 0);
      return y % 2 == 0 || is_bridge ? 0 : -1;
    };
  };
  specimen.label = path(-1);
  EXPECT_EQ(pieces_of(specimen).count, 1);
  specimen.label = path(3);
  EXPECT_EQ(pieces_of(specimen).count, 2);
}

// Crumbs, some of which end where the elements of another rank begin: that rank owns nodes that it
// does not touch.
TEST(Pieces, OfCrumbsAreTheSameOnAnyNumberOfRanks) {
  std::minstd_rand random(3);
  for (int n = 0; n < 20; ++n) {
    SCOPED_TRACE(n);
    std::vector<int> is_solid(6 * 8 * 6);
    for (int& one : is_solid) one = random() % 100 < 15 ? 1 : 0;
    Specimen specimen;
    specimen.elements = {6, 8, 6};
    specimen.label = [&](const grid::Index3& voxel) {
      const auto element =
          static_cast<std::size_t>(voxel[0] / 2 + 6 * (voxel[1] / 2 + 8 * (voxel[2] / 2)));
      const bool is_root = voxel[0] < 2 && voxel[2] < 2;  // what conditions at both ends strain
      return is_root || is_solid[element] != 0 ? 0 : -1;
    };
    specimen.conditions = {{"bottom", hold(Face::y_lower, "xy")},
                           {"side", hold(Face::x_lower, "z")},
                           {"top", stretch(Face::y_upper, "y", 0.1)}};
    const auto alone = specimen.balance(base::Communicator::self());
    const auto together = specimen.balance(world());
    const PiecesSummary& expected = alone->supports().pieces();
    const PiecesSummary& pieces = together->supports().pieces();
    EXPECT_GT(expected.count, 1);
    EXPECT_EQ(pieces.count, expected.count);
    EXPECT_EQ(pieces.elements, expected.elements);
    EXPECT_EQ(pieces.particles, expected.particles);
    EXPECT_EQ(pieces.carried, expected.carried);
    EXPECT_EQ(pieces.carried_particles, expected.carried_particles);
    EXPECT_EQ(together->supports().unknowns(), alone->supports().unknowns());
    EXPECT_EQ(together->supports().rigid_holds().size(), alone->supports().rigid_holds().size());
    EXPECT_EQ(together->supports().notes().size(), alone->supports().notes().size());
  }
}

// Wider functions reach over a gap of one element.
TEST(Pieces, AreThoseOfTheShapeFunctions) {
  Specimen specimen;
  specimen.elements = {4, 6, 4};
  specimen.layout = {particles::Layout::voxel_centers, 1, 2};
  specimen.label = [](const grid::Index3& voxel) { return voxel[1] / 2 == 2 ? -1 : 0; };
  EXPECT_EQ(pieces_of(specimen).count, 2);
  specimen.shape_functions = shape::ShapeFunctions::quadratic_b_spline;
  EXPECT_EQ(pieces_of(specimen).count, 1);
}

TEST(Pieces, AnIdleIslandLeavesTheSystem) {
  Specimen specimen = with_island();
  const auto with = specimen.balance(world());
  EXPECT_EQ(with->supports().pieces().count, 2);
  EXPECT_EQ(with->supports().pieces().carried, 1);
  EXPECT_EQ(with->supports().pieces().carried_elements, 1);
  EXPECT_EQ(with->supports().pieces().carried_particles, 8);
  EXPECT_EQ(with->supports().rigid_holds().size(), 0u);
  const std::string note = with->supports().notes().at(0);
  expect_told(note,
              {"1 of the body's 2 pieces", "1 element with 8 particles around (7.35, 9.45, 7)"});

  specimen.label = [](const grid::Index3& voxel) { return voxel[1] < 6 ? 0 : -1; };
  const auto without = specimen.balance(world());
  EXPECT_EQ(with->supports().unknowns(), without->supports().unknowns());
  EXPECT_TRUE(without->supports().notes().empty());
}

// What hangs on one condition alone moves with it.
TEST(Pieces, AnIdlePieceMovesWithItsCondition) {
  Specimen specimen;
  specimen.label = [](const grid::Index3& voxel) {
    const bool is_crumb = voxel[0] >= 6 && voxel[1] >= 6 && voxel[2] >= 6;
    return voxel[0] < 4 || is_crumb ? 0 : -1;
  };
  specimen.conditions = test::clamped(0.1);
  for (const ImposedBy by : {ImposedBy::nodes, ImposedBy::grip, ImposedBy::penalty}) {
    for (auto& named : specimen.conditions) named.second.imposed_by = by;
    const auto balance = specimen.balance(world());
    EXPECT_EQ(balance->supports().pieces().carried, 1);
    grid::Vector u(balance->owned_map());
    u.putScalar(7.0);
    balance->supports().impose(0.5, u);
    test::for_each_unknown(balance->halo(), u, [](const grid::Index3& node, int c, double value) {
      if (node[0] >= 3 && node[1] >= 3 && node[2] >= 3) {
        EXPECT_NEAR(value, c == 1 ? 0.5 * 0.1 * 8.4 : 0.0, 1e-15);
      }
    });
  }
}

TEST(Pieces, ALoadedIslandIsRefused) {
  Specimen specimen = with_island();
  specimen.forces = body_force({0.0, -0.5, 0.0});
  expect_told(refusal(specimen),
              {"External Forces: ", "along y: 4.41 pN",  // 0.5 * 2.1 * 2.1 * 2
               "1 element with 8 particles around (7.35, 9.45, 7) um, 2.1 x 2.1 x 2 um large",
               "the other piece"});
}

TEST(Pieces, ABodyInTwoBetweenItsGripsIsRefused) {
  Specimen specimen;
  specimen.label = [](const grid::Index3& voxel) { return voxel[1] / 2 == 1 ? -1 : 0; };
  specimen.conditions = test::clamped(0.1);
  for (const ImposedBy by : {ImposedBy::nodes, ImposedBy::grip, ImposedBy::penalty}) {
    for (auto& named : specimen.conditions) named.second.imposed_by = by;
    expect_told(refusal(specimen),
                {"Boundary Conditions|top: ", "strains nothing", "32 elements", "the other piece"});
  }
}

// The side holds the part without the bottom along x only; the weight pulls along y.
TEST(Pieces, APieceThatIsHeldInPartIsRefusedIfItsLoadMovesIt) {
  Specimen specimen;
  specimen.label = [](const grid::Index3& voxel) { return voxel[1] / 2 == 1 ? -1 : 0; };
  specimen.conditions = {{"bottom", hold(Face::y_lower, "xyz")},
                         {"side", hold(Face::x_lower, "x")}};
  EXPECT_EQ(refusal(specimen), "");
  ExternalForce weight;
  weight.acceleration = {{0.0, -9.81, 0.0}};
  specimen.forces = {{"weight", weight}};
  specimen.density = {1000.0, 1000.0};
  expect_told(refusal(specimen), {"along y: ", "32 elements"});
  specimen.forces = body_force({2.0, 0.0, 0.0});
  EXPECT_EQ(refusal(specimen), "") << "the side holds it";
  EXPECT_EQ(specimen.balance(world())->supports().rigid_holds().size(), 3u);
}

TEST(LoadsOnFreeMotions, AreRefusedHoweverTheyActAndWhateverHolds) {
  Specimen specimen;
  specimen.conditions = {{"bottom", hold(Face::y_lower, "y")}};
  const double volume = 8.4 * 8.4 * 8.0;
  for (const bool reset : {false, true}) {
    specimen.reset = reset;
    for (const ImposedBy by : {ImposedBy::nodes, ImposedBy::grip, ImposedBy::penalty}) {
      specimen.conditions[0].second.imposed_by = by;
      specimen.forces = body_force({1.0, 0.0, 0.0});
      expect_told(refusal(specimen), {"along x: " + base::format("%.6g pN", volume)});
      specimen.forces = {{"t", traction(Face::y_upper, {0.0, 0.0, 10.0})}};
      expect_told(refusal(specimen), {"along z: 672 pN"});
      specimen.forces = {{"t", traction(Face::x_upper, {0.0, -3.0, 0.0})}};
      EXPECT_EQ(refusal(specimen), "") << "what is held";
      specimen.forces = {{"t", traction(Face::z_upper, {10.0, 0.0, 0.0})},
                         {"u", traction(Face::z_lower, {-10.0, 0.0, 0.0})}};
      expect_told(refusal(specimen), {"about the axis along y through (4.2, 4.2, 4) um: 5644.8"});
      specimen.forces = {{"t", traction(Face::x_upper, {10.0, 0.0, 0.0})},
                         {"u", traction(Face::x_lower, {-10.0, 0.0, 0.0})}};
      EXPECT_EQ(refusal(specimen), "") << "in balance";
    }
  }
}

TEST(LoadsOnFreeMotions, AreRefusedInPlaneStrain) {
  Specimen specimen;
  specimen.elements = {4, 4, 1};
  specimen.plane_strain = true;
  specimen.conditions = {{"bottom", hold(Face::y_lower, "y")}};
  specimen.forces = body_force({0.0, 0.0, 1.0});
  EXPECT_EQ(refusal(specimen), "") << "nothing moves along z";
  specimen.forces = body_force({-0.6, 0.3, 0.0});
  expect_told(refusal(specimen), {"along x: "});
  specimen.conditions = {};
  expect_told(refusal(specimen), {"along (-0.894, 0.447, 0): "});
}

TEST(LoadsOnFreeMotions, AreNamedByTheAxisOfTheRotation) {
  const RigidFrame frame{{1.0, 2.0, 3.0}, 20.0};
  PieceSums piece;
  piece.elements = 1;
  piece.lower = {0.0, 0.0, -4.0};
  piece.upper = {8.0, 10.0, 4.0};
  for (const double y : {0.0, 10.0})
    for (int c = 0; c < 3; ++c) piece.add_held(frame, {0, {3.0, y, 0.0}, c}, 0.0);
  EXPECT_EQ(free_resultant(piece, frame, true), "");
  piece.add_load(frame, {5.0, 7.0, 0.0}, {0.0, 0.0, 4.0});
  EXPECT_EQ(free_resultant(piece, frame, true),
            "about the axis along y through (3, 5, 0) um: 8 pN um");
  EXPECT_EQ(free_resultant(piece, frame, false), "");
  piece.add_load(frame, {1.0, 2.0, 0.0}, {0.0, 0.0, 4.0});
  EXPECT_EQ(free_resultant(piece, frame, true), "") << "in balance";
}

}  // namespace
}  // namespace stroma::mechanics
