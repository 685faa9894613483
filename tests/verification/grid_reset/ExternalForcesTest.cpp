// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Forces on particles: their balance, and bodies under them whose answer is known. Claims V-FEXT-1
/// to V-FEXT-3, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using mechanics::ExternalForce;
using mechanics::Face;
using test::Specimen;
using Vector3 = std::array<double, 3>;

ExternalForce body_force(const Vector3& per_volume) {
  ExternalForce force;
  force.body_force = per_volume;
  return force;
}

ExternalForce traction(Face face, const Vector3& per_area) {
  ExternalForce force;
  force.traction = per_area;
  force.face = face;
  return force;
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A force that differs from place to place in the undeformed body [pN/um^3].
Vector3 uneven_force(const Vector3& X) { return {0.5 * X[1], -0.25 * X[0], 0.125 * X[1] * X[2]}; }

// V-FEXT-1. Reactions, body forces, weight and traction are in balance, and so are their moments
// about the origin, at the places where nodes and particles are by then. The forces on the
// particles are summed here from the deck's words, not from the code under test.
TEST(ExternalForces, BalanceWithTheReactions) {
  for (const bool reset : {false, true}) {
    Specimen specimen;
    specimen.label = test::crossing_bars;
    specimen.layout = {particles::Layout::per_element, 1, 2};
    specimen.reset = reset;
    specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")}};
    specimen.density = {1000.0, 1100.0};
    const Vector3 b{3.0, -2.0, 1.0}, t{25.0, 10.0, -15.0}, a{-2e3, 1e3, 3e3};
    ExternalForce weight;
    weight.acceleration = a;
    specimen.forces = {
        {"push", body_force(b)}, {"weight", weight}, {"pull", traction(Face::x_upper, t)}};
    specimen.body_force = uneven_force;
    mechanics::MovingBody body = specimen.moving_body(world());
    test::take_steps(body, 3, test::to_rounding(), [&](double load, const grid::Vector& u) {
      auto& balance = body.balance();
      const auto& particles = balance.body().particles();
      const auto fields = balance.body().particle_fields(u);
      const auto H = balance.body().moved_particles(u).base_gradient;
      double sums[6] = {}, size = 0.0;
      const double s = 2.1 / 2.0;  // distance of particles along x
      for (int p = 0; p < particles.count(); ++p) {
        const double V = particles.volume(p);
        const double rho = specimen.density[particles.material(p)];
        Vector3 x, X, f;
        for (int d = 0; d < 3; ++d) {
          const auto i = static_cast<std::size_t>(d);
          X[i] = reset ? particles.position(p, d) - particles.base_displacement(p, d)
                       : particles.position(p, d);
          x[i] = X[i] + fields.displacement(p, d);
        }
        const Vector3 uneven = uneven_force(X);
        for (std::size_t i = 0; i < 3; ++i)
          f[i] = load * V * (b[i] + 1e-6 * rho * a[i] + uneven[i]);
        const auto add = [&](const Vector3& at, const Vector3& force) {
          const Vector3 moment = cross(at, force);
          for (std::size_t i = 0; i < 3; ++i) {
            sums[i] += force[i];
            sums[3 + i] += moment[i];
            size += std::abs(moment[i]);
          }
        };
        add(x, f);
        if (X[0] < 8.4 - s) continue;
        Vector3 at_face = x, pull;
        for (std::size_t i = 0; i < 3; ++i) {
          at_face[i] += ((i == 0 ? 1.0 : 0.0) + H(p, static_cast<int>(i), 0)) * (8.4 - X[0]);
          pull[i] = load * (V / s) * t[i];
        }
        add(at_face, pull);
      }
      const double applied = world().sum(sums[0]);
      double mass = 0.0;
      for (int p = 0; p < particles.count(); ++p)
        mass += particles.volume(p) * specimen.density[particles.material(p)];
      const double whole = 8.4 * 8.4 * 8.0;
      EXPECT_NEAR(
          applied,
          load * (whole * (b[0] + 0.5 * 4.2) + 8.4 * 8.0 * t[0] + 1e-6 * a[0] * world().sum(mass)),
          1e-10 * std::abs(applied));
      const grid::Vector& force = *balance.forces(u).unbalanced;
      const grid::Grid& grid = balance.halo().partition().grid();
      std::map<std::int64_t, Vector3> at_node, node_force;
      const grid::Box owned = balance.halo().partition().owned_nodes(world().rank());
      test::for_each_unknown(balance.halo(), u, [&](const grid::Index3& node, int c, double value) {
        const auto i = static_cast<std::size_t>(c);
        at_node[owned.local(node)][i] = grid.node_position(node)[i] + value;
      });
      test::for_each_unknown(balance.halo(), force,
                             [&](const grid::Index3& node, int c, double value) {
                               node_force[owned.local(node)][static_cast<std::size_t>(c)] = value;
                             });
      for (const auto& [node, x] : at_node) {
        const Vector3 moment = cross(x, node_force.at(node));
        for (std::size_t i = 0; i < 3; ++i) {
          sums[i] += node_force.at(node)[i];
          sums[3 + i] += moment[i];
        }
      }
      size = world().sum(size);
      for (const double sum : sums) EXPECT_NEAR(world().sum(sum), 0.0, 1e-10 * size);
      const auto reaction = test::reactions(body, u)[0];
      EXPECT_NEAR(reaction[0], -applied, 1e-10 * std::abs(applied));
    });
  }
}

/// A column of 1 x n x 1 elements, 32 um high, that cannot move sideways and stands on its bottom.
Specimen column(std::int64_t n) {
  Specimen specimen;
  specimen.elements = {1, n, 1};
  specimen.spacing = {4.0, 32.0 / static_cast<double>(n), 4.0};
  specimen.layout = {particles::Layout::gauss, 1, 2};
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "y")},
                         {"x", test::hold(Face::x_lower, "x")},
                         {"x2", test::hold(Face::x_upper, "x")},
                         {"z", test::hold(Face::z_lower, "z")},
                         {"z2", test::hold(Face::z_upper, "z")}};
  return specimen;
}

/// u / L of the upper face at full load.
double top_displacement(const Specimen& specimen, int steps) {
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::self());
  double top = 0.0;
  test::take_steps(body, steps, test::to_rounding(), [&](double, const grid::Vector& u) {
    test::for_each_unknown(body.balance().halo(), u,
                           [&](const grid::Index3& node, int c, double value) {
                             if (node[1] == specimen.elements[1] && c == 1) top = value;
                           });
  });
  return top / 32.0;
}

// V-FEXT-2. A column under its own weight q = rho g L. Its Cauchy stress is -q (1 - Y/L) (confined:
// nominal and Cauchy stress are one), and the top sinks by these figures, for q / M with
// M = K + 4 mu / 3; they come from integrating the stretch along the column.
TEST(ExternalForces, AColumnSinksUnderItsWeight) {
  const double M = 2430.4 + 4.0 / 3.0 * 520.8;
  for (const auto& [ratio, exact] :
       {std::pair{0.1, -0.0457586370}, {0.2, -0.0846429375}, {0.5, -0.1746535845}}) {
    double error[3];
    int i = 0;
    for (const std::int64_t n : {8, 16, 32}) {
      Specimen specimen = column(n);
      specimen.density = {1000.0, 1000.0};
      ExternalForce weight;  // rho g L = ratio M, g in m/s^2: 1e-6 pN a kg/m^3 um^3
      weight.acceleration = Vector3{0.0, -ratio * M / 32.0 / 1000.0 * 1e6, 0.0};
      specimen.forces = {{"gravity", weight}};
      error[i++] = std::abs(top_displacement(specimen, 2) - exact);
    }
    EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.1) << ratio;
    EXPECT_NEAR(std::log2(error[1] / error[2]), 2.0, 0.1) << ratio;
    EXPECT_LT(error[2], 2e-5) << ratio;
  }
}

// V-FEXT-3. A small traction on top of the column strains all of it by t / M: it acts at the face.
TEST(ExternalForces, ATractionActsAtTheFace) {
  const double M = 2430.4 + 4.0 / 3.0 * 520.8, t = 1e-7 * M;
  for (const std::int64_t n : {2, 5})
    for (const auto layout : {particles::Layout::gauss, particles::Layout::per_element}) {
      Specimen specimen = column(n);
      specimen.layout.layout = layout;
      specimen.forces = {{"pull", traction(Face::y_upper, {0.0, t, 0.0})}};
      EXPECT_NEAR(top_displacement(specimen, 1), 1e-7, 1e-6 * 1e-7);
    }
}

}  // namespace
}  // namespace stroma
