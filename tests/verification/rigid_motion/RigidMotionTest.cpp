// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Rigid motions leave no stress, whatever the shape functions. Claims V-SHA-3 and V-SHA-4,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support/LoadSteps.hpp"
#include "support/ShapeChoices.hpp"
#include "support/ShiftedBody.hpp"
#include "support/Turn.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using tensor::Tensor3;
using test::Specimen;
using test::turn;
using Vector3 = std::array<double, 3>;

/// Where a body of particles starts, against its lattice.
struct Start {
  double origin;  ///< of the lattice [um]
  Vector3 share;  ///< of an element, by which the particles are shifted
};

/// A particle starts at a quarter of an element; so these are: inside; on nodes; on edges along y;
/// on faces; anywhere.
std::vector<Start> starts() {
  return {{0.0, {0.0, 0.0, 0.0}},
          {0.0, {0.25, 0.25, 0.25}},
          {-13.37, {0.25, 0.0, 0.25}},
          {5.3, {0.0, -0.25, 0.0}},
          {-13.37, {0.6, -0.3, 1.9}}};
}

Specimen bar(const test::ShapeChoice& choice, bool plane_strain, bool reset) {
  Specimen specimen;
  choice.apply_to(specimen);
  specimen.plane_strain = plane_strain;
  specimen.reset = reset;
  specimen.layout = {particles::Layout::per_element, 1, 2};
  specimen.elements = {2, plane_strain ? 9 : 5, plane_strain ? 1 : 2};
  specimen.label = [](const grid::Index3& voxel) { return voxel[1] % 3 == 0 ? 1 : 0; };
  return specimen;
}

Vector3 shift_of(const Start& start, const Specimen& specimen) {
  Vector3 shift;
  for (std::size_t d = 0; d < 3; ++d)
    shift[d] = d == 2 && specimen.plane_strain ? 0.0 : start.share[d] * specimen.spacing[d];
  return shift;
}

/// Expects the particles unstressed, and each where the motion x -> R x + t has carried it.
void expect_rigid(const mechanics::MovingBody& body, const grid::Vector& u,
                  const std::map<std::int64_t, Vector3>& start, const Tensor3& R, const Vector3& t,
                  double shear_modulus) {
  const auto& particles = body.balance().body().particles();
  const auto fields = body.balance().body().particle_fields(u);
  for (int p = 0; p < particles.count(); ++p) {
    const auto s = [&](int c) { return fields.stress(p, c); };
    const double von_mises =
        tensor::von_mises({{{s(0), s(3), s(5)}, {s(3), s(1), s(4)}, {s(5), s(4), s(2)}}});
    EXPECT_LT(von_mises, 1e-11 * shear_modulus);
    EXPECT_NEAR(fields.jacobian(p), 1.0, 1e-11);
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) EXPECT_NEAR(fields.gradient(p, c, d), R(c, d) - (c == d), 1e-11);
    const Vector3& X = start.at(particles.id(p));
    for (int c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(c);
      const double expected = R(c, 0) * X[0] + R(c, 1) * X[1] + R(c, 2) * X[2] + t[i];
      EXPECT_NEAR(fields.displacement(p, c), expected - X[i], 1e-11);
    }
  }
}

/// Positions of all particles at the start, by id, on each rank.
std::map<std::int64_t, Vector3> positions(const mechanics::MovingBody& body) {
  const auto& particles = body.balance().body().particles();
  std::vector<double> mine;
  for (int p = 0; p < particles.count(); ++p) {
    mine.push_back(static_cast<double>(particles.id(p)));
    for (int d = 0; d < 3; ++d) mine.push_back(particles.position(p, d));
  }
  const auto counts = world().gather(static_cast<int>(mine.size()));
  std::vector<int> begin{0};
  for (const int count : counts) begin.push_back(begin.back() + count);
  std::vector<double> all(static_cast<std::size_t>(begin.back()));
  MPI_Allgatherv(mine.data(), static_cast<int>(mine.size()), MPI_DOUBLE, all.data(), counts.data(),
                 begin.data(), MPI_DOUBLE, world().raw());
  std::map<std::int64_t, Vector3> result;
  for (std::size_t n = 0; n < all.size(); n += 4)
    result[static_cast<std::int64_t>(all[n])] = {all[n + 1], all[n + 2], all[n + 3]};
  return result;
}

/// Of the box of the lattice's elements that hold particles.
Vector3 lowest_corner(const std::map<std::int64_t, Vector3>& positions, const Specimen& specimen) {
  Vector3 corner;
  for (std::size_t d = 0; d < 3; ++d) {
    double lowest = positions.begin()->second[d];
    for (const auto& named : positions) lowest = std::min(lowest, named.second[d]);
    const double element = (lowest - specimen.origin[d]) / specimen.spacing[d];
    corner[d] = specimen.origin[d] + std::floor(element + 1e-9) * specimen.spacing[d];
  }
  return corner;
}

class RigidMotion : public ::testing::TestWithParam<test::ShapeChoice> {};

// V-SHA-3. Nodes that turn by 40 degrees and go on by 0.77 of an element in each of six steps carry
// the particles along, through all places that a particle can have in an element. Nothing resists.
TEST_P(RigidMotion, OfTheNodesIsThatOfTheParticles) {
  for (const bool plane_strain : {false, true})
    for (const bool reset : {false, true})
      for (const Start& start : starts()) {
        SCOPED_TRACE(::testing::Message() << (plane_strain ? "plane strain" : "space") << ", reset "
                                          << reset << ", shift " << start.share[0]);
        Specimen specimen = bar(GetParam(), plane_strain, reset);
        specimen.origin = {start.origin, 2.0 * start.origin, plane_strain ? 0.0 : -start.origin};
        specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")}};
        specimen.conditions[0].second.imposed_by = mechanics::ImposedBy::grip;
        mechanics::MovingBody body =
            test::shifted_body(world(), specimen, shift_of(start, specimen));
        const auto at_start = positions(body);
        const test::RigidMotion step{turn(plane_strain ? Vector3{0, 0, 1} : Vector3{0.3, -0.5, 1.0},
                                          40.0 / 180.0 * std::acos(-1.0)),
                                     {0.77 * 2.1, -0.77 * 2.1, plane_strain ? 0.0 : 0.77 * 2.0}};
        test::RigidMotion motion;
        for (int n = 1; n <= 6; ++n) {
          motion = step.after(motion);
          body.begin_step();
          const test::RigidMotion& since_base = reset ? step : motion;
          const auto& balance = body.balance();
          const grid::Grid& grid = balance.halo().partition().grid();
          grid::Vector u(balance.owned_map());
          test::fill(balance.halo(), u, [&](const grid::Index3& node, int c) {
            return since_base.displacement(grid.node_position(node), c);
          });
          expect_rigid(body, u, at_start, motion.R, motion.t, specimen.laws[0].shear_modulus);
          grid::Vector force(balance.owned_map());
          EXPECT_EQ(balance.internal_force(u, force), 0);
          EXPECT_LT(force.normInf(), 1e-9 * specimen.laws[0].shear_modulus * 2.1 * 2.1);
          body.accept(n / 6.0, u);
        }
      }
}

// V-SHA-4. The ends of a bar are turned by 15 degrees in one step, or carried along in steps of
// 0.31 of an element; what lies between them follows by equilibrium, without stress.
TEST_P(RigidMotion, OfTheEndsIsThatOfTheBody) {
  for (const bool plane_strain : {false, true})
    for (const bool reset : {false, true})
      for (const bool turns : {false, true})
        for (const Start& start : starts()) {
          if (!reset && start.share[1] != 0.0) continue;          // nodes must lie in the face
          if (!plane_strain && start.share[0] == 0.25) continue;  // takes long
          SCOPED_TRACE(::testing::Message()
                       << (plane_strain ? "plane strain" : "space") << ", reset " << reset
                       << ", turns " << turns << ", shift " << start.share[0]);
          Specimen specimen = bar(GetParam(), plane_strain, reset);
          specimen.stabilization = reset ? 0.01 : 0.0;
          specimen.layout.per_element = 3;
          mechanics::BoundaryCondition bottom = test::hold(Face::y_lower, "xyz"),
                                       top = test::hold(Face::y_upper, "xyz");
          const Tensor3 R = turns ? turn(plane_strain ? Vector3{0, 0, 1} : Vector3{0.3, -0.5, 1.0},
                                         15.0 / 180.0 * std::acos(-1.0))
                                  : tensor::identity();
          Vector3 way{1.86 * 2.1, -1.86 * 2.1, plane_strain ? 0.0 : 1.86 * 2.0};
          if (turns) {
            bottom.displacement_gradient =
                std::array<double, 9>{R(0, 0) - 1, R(0, 1), R(0, 2), R(1, 0),    R(1, 1) - 1,
                                      R(1, 2),     R(2, 0), R(2, 1), R(2, 2) - 1};
            top.displacement_gradient = bottom.displacement_gradient;
          } else {
            bottom.displacement = top.displacement = way;
          }
          for (auto* end : {&bottom, &top})  // shifted particles do not end at nodes
            end->imposed_by = mechanics::ImposedBy::grip;
          specimen.conditions = {{"bottom", bottom}, {"top", top}};
          mechanics::MovingBody body =
              test::shifted_body(world(), specimen, shift_of(start, specimen));
          const auto at_start = positions(body);
          const Vector3 c = lowest_corner(at_start, specimen);  // the turn is about it
          for (std::size_t i = 0; i < 3 && turns; ++i) {
            const int row = static_cast<int>(i);
            way[i] = c[i] - R(row, 0) * c[0] - R(row, 1) * c[1] - R(row, 2) * c[2];
          }
          test::take_steps(body, turns ? 1 : 3, test::to_rounding(),
                           [&](double load, const grid::Vector& u) {
                             Vector3 t;
                             for (std::size_t i = 0; i < 3; ++i) t[i] = load * way[i];
                             expect_rigid(body, u, at_start, R, t, specimen.laws[0].shear_modulus);
                           });
        }
}

INSTANTIATE_TEST_SUITE_P(All, RigidMotion, ::testing::ValuesIn(test::shape_choices()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace stroma
