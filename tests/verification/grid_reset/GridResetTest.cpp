// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The grid that is reset after each step. Claims V-RESET-1 to V-RESET-7, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "support/LoadSteps.hpp"
#include "support/ShiftedBody.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using mechanics::ImposedBy;
using test::Specimen;

mechanics::BoundaryCondition moved(Face face, const std::array<double, 3>& displacement) {
  mechanics::BoundaryCondition condition = test::hold(face, "xyz");
  condition.displacement = displacement;
  return condition;
}

Specimen with_bars(bool reset) {
  Specimen specimen;
  specimen.label = test::crossing_bars;
  specimen.layout = {particles::Layout::per_element, 1, 2};
  specimen.reset = reset;
  specimen.conditions = test::clamped(0.1);
  for (auto& named : specimen.conditions) named.second.imposed_by = ImposedBy::grip;
  return specimen;
}

/// Largest difference of two vectors over the largest entry of the first.
double relative_difference(const grid::Vector& a, const grid::Vector& b) {
  grid::Vector difference(a, Teuchos::Copy);
  difference.update(-1.0, b, 1.0);
  return difference.normInf() / a.normInf();
}

/// What is known of a particle at the end, by its id.
struct Fate {
  std::array<double, 3> position;
  double von_mises, jacobian;
};

/// Every particle of this communicator's ranks, on each of them.
std::map<std::int64_t, Fate> fates(const base::Communicator& communicator,
                                   const mechanics::MovingBody& body, const grid::Vector& u) {
  const auto& particles = body.balance().body().particles();
  const auto moved_to = body.balance().body().moved_particles(u).position;
  const auto fields = body.balance().body().particle_fields(u);
  std::vector<double> mine;
  for (int p = 0; p < particles.count(); ++p) {
    const auto s = [&](int c) { return fields.stress(p, c); };
    mine.push_back(static_cast<double>(particles.id(p)));
    for (int d = 0; d < 3; ++d) mine.push_back(moved_to(p, d));
    mine.push_back(
        tensor::von_mises({{{s(0), s(3), s(5)}, {s(3), s(1), s(4)}, {s(5), s(4), s(2)}}}));
    mine.push_back(fields.jacobian(p));
  }
  const auto counts = communicator.gather(static_cast<int>(mine.size()));
  std::vector<int> begin{0};
  for (const int count : counts) begin.push_back(begin.back() + count);
  std::vector<double> all(static_cast<std::size_t>(begin.back()));
  MPI_Allgatherv(mine.data(), static_cast<int>(mine.size()), MPI_DOUBLE, all.data(), counts.data(),
                 begin.data(), MPI_DOUBLE, communicator.raw());
  std::map<std::int64_t, Fate> result;
  for (std::size_t n = 0; n < all.size(); n += 6)
    EXPECT_TRUE(result
                    .emplace(static_cast<std::int64_t>(all[n]),
                             Fate{{all[n + 1], all[n + 2], all[n + 3]}, all[n + 4], all[n + 5]})
                    .second)
        << "two particles have id " << all[n];
  return result;
}

// V-RESET-1. In its first step a grid that will be reset is one that will not.
TEST(GridReset, FirstStepIsThatWithoutReset) {
  for (const bool plane_strain : {false, true}) {
    std::vector<grid::Vector> answers;
    for (const bool reset : {false, true}) {
      Specimen specimen = with_bars(reset);
      if (plane_strain) {
        specimen.plane_strain = true;
        specimen.elements = {6, 6, 1};
      }
      mechanics::MovingBody body = specimen.moving_body(world());
      test::take_steps(body, 1, test::to_rounding(),
                       [&](double, const grid::Vector& u) { answers.push_back(u); });
    }
    EXPECT_LT(relative_difference(answers[0], answers[1]), 1e-12) << plane_strain;
    EXPECT_GT(answers[0].normInf(), 0.5);
  }
}

// V-RESET-2. While no particle crosses, reset and no reset differ by two things: the stretched
// particles overfill their elements, which raises the force by the strain, and the grip's nodes
// stay where they were while its particles move on, so that the same material is stretched over a
// shorter way, by half of that. Both are the grip's way over the free length, delta / (L - 2 h).
TEST(GridReset, WithoutCrossingItsErrorFallsWithTheElements) {
  const double strain = 0.015;
  double before = 1.0;
  for (const std::int64_t n : {4, 8, 12}) {
    double force[2];
    for (const bool reset : {false, true}) {
      Specimen specimen;
      specimen.elements = {n, n, n};
      specimen.spacing = {32.0 / static_cast<double>(n), 32.0 / static_cast<double>(n),
                          32.0 / static_cast<double>(n)};
      specimen.layout = {particles::Layout::per_element, 1, 2};
      specimen.conditions = with_bars(reset).conditions;
      specimen.conditions[1].second.strain = strain;
      specimen.reset = reset;
      mechanics::MovingBody body = specimen.moving_body(world());
      solver::SolverParameters parameters;
      parameters.preconditioner = solver::PreconditionerKind::chebyshev;
      parameters.newton_tolerance = 1e-9;
      test::take_steps(body, 4, parameters, [&](double, const grid::Vector& u) {
        force[reset] = test::reactions(body, u)[1][1];
        EXPECT_EQ(body.balance().halo().partition().grid().elements[1], n);
      });
    }
    const double departure = force[1] / force[0] - 1.0;
    const double h = 32.0 / static_cast<double>(n);
    const double expected = 1.5 * strain * 32.0 / (32.0 - 2.0 * h);
    EXPECT_NEAR(departure, expected, 0.15 * expected) << n;
    EXPECT_LT(departure, before) << n;
    before = departure;
    if (world().is_root())
      std::printf("  %lld elements: departure %.4f, expected %.4f\n", static_cast<long long>(n),
                  departure, expected);
  }
}

// V-RESET-3. A translation by 3.7 elements in steps of a tenth of one: particles that start at a
// quarter of an element, or on nodes, edges and faces, meet nodes, edges and faces on their way.
TEST(GridReset, RigidTranslationLeavesNoStress) {
  const double quarter = 0.25;
  struct Start {
    double origin;                // of the lattice [um]
    std::array<double, 3> share;  // of an element, by which the particles are shifted against it
  };
  for (const Start& start :
       {Start{0.0, {0.0, 0.0, 0.0}}, Start{0.0, {quarter, quarter, quarter}},
        Start{-13.37, {quarter, 0.0, quarter}}, Start{-13.37, {0.6, -0.3, 1.9}}}) {
    Specimen specimen = with_bars(true);
    specimen.elements = {3, 4, 3};
    specimen.origin = {start.origin, 2.0 * start.origin, -start.origin};
    const std::array<double, 3> h = specimen.spacing;
    const std::array<double, 3> way{3.7 * h[0], -3.7 * h[1], 3.7 * h[2]};
    specimen.conditions = {{"bottom", moved(Face::y_lower, way)},
                           {"top", moved(Face::y_upper, way)}};
    for (auto& named : specimen.conditions) named.second.imposed_by = ImposedBy::grip;
    std::array<double, 3> shift;
    for (std::size_t d = 0; d < 3; ++d) shift[d] = start.share[d] * h[d];
    mechanics::MovingBody body = test::shifted_body(world(), specimen, shift);
    const auto at_start = fates(world(), body, body.displacement());
    std::map<std::int64_t, Fate> at_end;
    test::take_steps(body, 37, test::to_rounding(), [&](double load, const grid::Vector& u) {
      if (load == 1.0) at_end = fates(world(), body, u);
    });
    ASSERT_EQ(at_end.size(), 8u * 3 * 4 * 3);
    for (const auto& [id, fate] : at_end) {
      EXPECT_LT(fate.von_mises, 1e-10 * specimen.laws[0].shear_modulus) << id;
      EXPECT_NEAR(fate.jacobian, 1.0, 1e-10) << id;
      for (std::size_t d = 0; d < 3; ++d)
        EXPECT_NEAR(fate.position[d], at_start.at(id).position[d] + way[d], 1e-10) << id;
    }
  }
}

// V-RESET-4. Bent sideways, stretched and carried along, every particle changes its element, most
// of them several times and to another rank. None is lost, none is doubled, their volumes stay, and
// all is as on one rank.
TEST(GridReset, EveryParticleChangesElement) {
  const auto run = [](const base::Communicator& communicator, double& force) {
    Specimen specimen = with_bars(true);
    specimen.stabilization = 0.01;
    specimen.elements = {4, 6, 4};
    const std::array<double, 3> h = specimen.spacing;
    specimen.conditions = {{"bottom", moved(Face::y_lower, {1.3 * h[0], 1.2 * h[1], 0.0})},
                           {"top", moved(Face::y_upper, {2.1 * h[0], 1.9 * h[1], -1.1 * h[2]})}};
    mechanics::MovingBody body = specimen.moving_body(communicator);
    std::map<std::int64_t, Fate> end;
    test::take_steps(body, 12, test::to_rounding(), [&](double load, const grid::Vector& u) {
      const auto& particles = body.balance().body().particles();
      double volume = 0.0;
      for (int p = 0; p < particles.count(); ++p) volume += particles.volume(p);
      const double whole = 96 * h[0] * h[1] * h[2];
      EXPECT_NEAR(communicator.sum(volume), whole, 1e-12 * whole);
      if (load < 1.0) return;
      end = fates(communicator, body, u);
      const auto reactions = test::reactions(body, u);
      force = reactions[1][1];
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(reactions[0][c] + reactions[1][c], 0.0, 1e-10 * std::abs(force));
    });
    return end;
  };
  double force, force_alone;
  const auto together = run(world(), force);
  const auto alone = run(base::Communicator::self(), force_alone);

  Specimen specimen = with_bars(true);
  specimen.elements = {4, 6, 4};
  const auto seeded = specimen.particles(base::Communicator::self());
  ASSERT_EQ(together.size(), static_cast<std::size_t>(seeded.count()));
  EXPECT_NEAR(force, force_alone, 1e-10 * force_alone);
  for (int p = 0; p < seeded.count(); ++p) {
    const Fate& fate = together.at(seeded.id(p));
    const Fate& same = alone.at(seeded.id(p));
    bool changed = false;
    for (int d = 0; d < 3; ++d) {
      const auto i = static_cast<std::size_t>(d);
      changed = changed || std::floor(fate.position[i] / specimen.spacing[i]) !=
                               std::floor(seeded.position(p, d) / specimen.spacing[i]);
      EXPECT_NEAR(fate.position[i], same.position[i], 1e-10 * 30.0);
    }
    EXPECT_TRUE(changed) << "particle " << seeded.id(p);
    EXPECT_NEAR(fate.von_mises, same.von_mises, 1e-10 * specimen.laws[0].shear_modulus);
  }
}

// V-RESET-5. Half a body on a symmetry plane, whose nodes are held, is half of the whole body.
TEST(GridReset, NodesHoldASymmetryPlane) {
  double force[2];
  for (const bool half : {false, true}) {
    Specimen specimen;
    specimen.reset = true;
    specimen.elements = {half ? 3 : 6, 5, 3};
    specimen.layout = {particles::Layout::per_element, 1, 2};
    specimen.conditions = test::clamped(0.2);
    if (half) {
      specimen.conditions.push_back({"middle", test::hold(Face::x_lower, "x")});
      specimen.conditions.back().second.imposed_by = ImposedBy::nodes;
    }
    mechanics::MovingBody body = specimen.moving_body(world());
    test::take_steps(body, 7, test::to_rounding(), [&](double, const grid::Vector& u) {
      force[half] = test::reactions(body, u)[1][1];
    });
  }
  EXPECT_GT(force[0], 0.0);
  EXPECT_NEAR(2.0 * force[1], force[0], 1e-9 * force[0]);
}

// V-RESET-6. A body all of whose nodes a grip moves linearly has the prescribed gradient in each
// particle, though the nodes are others in each step.
TEST(GridReset, GripsFollowADisplacementGradient) {
  const std::array<double, 9> G{0.15, 0.20, -0.04, -0.10, 0.28, 0.06, 0.03, -0.07, -0.15};
  Specimen specimen;
  specimen.reset = true;
  specimen.elements = {3, 3, 3};
  specimen.layout = {particles::Layout::voxel_centers, 2, 2};
  specimen.conditions = {{"boundary", test::hold(Face::all, "xyz")}};
  specimen.conditions[0].second.displacement_gradient = G;
  specimen.conditions[0].second.imposed_by = ImposedBy::grip;
  mechanics::MovingBody body = specimen.moving_body(world());
  test::take_steps(body, 6, test::to_rounding(), [&](double load, const grid::Vector& u) {
    const auto gradient = body.balance().body().moved_particles(u).base_gradient;
    for (std::size_t p = 0; p < gradient.extent(0); ++p)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          ASSERT_NEAR(gradient(p, i, j), load * G[static_cast<std::size_t>(3 * i + j)], 1e-12);
  });
}

// V-RESET-7. Clamped grips and rollers, extension and compression, in space and in plane strain:
// each goes its way in both modes, and they tell the same force but for the error of resetting.
TEST(GridReset, ExtensionAndCompressionInBothModes) {
  for (const bool plane_strain : {false, true})
    for (const char* components : {"xyz", "y"})
      for (const double strain : {0.1, -0.1}) {
        double force[2];
        for (const bool reset : {false, true}) {
          Specimen specimen = with_bars(reset);
          specimen.plane_strain = plane_strain;
          specimen.elements = {8, 8, plane_strain ? 1 : 4};
          specimen.stabilization = 0.01;
          specimen.conditions[0].second.components = components;
          specimen.conditions[1].second.components = components;
          specimen.conditions[1].second.strain = strain;
          mechanics::MovingBody body = specimen.moving_body(world());
          solver::SolverParameters parameters;
          parameters.preconditioner = solver::PreconditionerKind::jacobi;
          test::take_steps(body, 5, parameters, [&](double, const grid::Vector& u) {
            force[reset] = test::reactions(body, u)[1][1];
          });
        }
        EXPECT_GT(force[0] * strain, 0.0);
        EXPECT_NEAR(force[1], force[0], 0.2 * std::abs(force[0]))
            << plane_strain << components << strain;
      }
}

}  // namespace
}  // namespace stroma
