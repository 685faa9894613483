// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Deformation Gradient = Projected Displacement, the paper's equations 1 and 2, and what they cost
/// at a face. Claims V-PROJ-1 and V-PROJ-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using test::Specimen;

Specimen stretched(double strain, particles::Layout layout) {
  Specimen specimen;
  specimen.elements = {3, 6, 3};
  specimen.layout = {layout, 1, 2};
  specimen.deformation_gradient = mechanics::DeformationGradient::projected_displacement;
  specimen.conditions = {{"boundary", test::hold(Face::all, "xyz")}};
  specimen.conditions[0].second.displacement_gradient =
      std::array<double, 9>{0, 0, 0, 0, strain, 0, 0, 0, 0};
  return specimen;
}

// V-PROJ-1. A uniform strain e, u = e Y. The quotient of equation 1 is the mean displacement of the
// particles around a node, weighted by its hat. Inside the body they lie around the node, and the
// mean is e Y exactly. At a face they lie to one side of it, on the average c h away, with
// c = (sum xi (1 - xi)) / (sum xi) over the points xi of an element: the node is put at e (L - c
// h), and equation 2 gives the outermost elements a strain of (1 - c) e. The error is as large as
// the strain, and finer grids only make its layer thinner.
TEST(ProjectedDisplacement, IsWrongInTheElementsAtAFace) {
  const double e = 0.1;
  for (const auto layout : {particles::Layout::per_element, particles::Layout::gauss}) {
    const Specimen specimen = stretched(e, layout);
    mechanics::MovingBody body = specimen.moving_body(world());
    test::take_steps(body, 1, test::to_rounding(), [](double, const grid::Vector&) {});
    ASSERT_FALSE(body.begin_step());

    const double xi = layout == particles::Layout::gauss ? 0.5 - 0.5 / std::sqrt(3.0) : 0.25;
    const double c = 2.0 * xi * (1.0 - xi);
    const double h = 2.1, L = 6 * h;
    test::for_each_unknown(body.balance().halo(), body.displacement(),
                           [&](const grid::Index3& node, int i, double value) {
                             const double Y = static_cast<double>(node[1]) * h;
                             const double expected = i != 1         ? 0.0
                                                     : node[1] == 0 ? e * c * h
                                                     : node[1] == 6 ? e * (L - c * h)
                                                                    : e * Y;
                             EXPECT_NEAR(value, expected, 1e-13);
                           });
    const auto& particles = body.balance().body().particles();
    const auto fields = body.balance().body().particle_fields(body.displacement());
    for (int p = 0; p < particles.count(); ++p) {
      const double Y = particles.position(p, 1);
      const bool at_face = Y < h || Y > L - h;
      EXPECT_NEAR(fields.jacobian(p), 1.0 + (at_face ? (1.0 - c) * e : e), 1e-13);
      EXPECT_NEAR(fields.displacement(p, 1), e * Y, 1e-13);  // the particle forgets nothing
    }
  }
}

// V-PROJ-2. With reset, gradients are those of the deformed configuration: F = (I - du/dx)^-1.
// Where the projected displacement is linear, inside, F is that of the motion, not only to first
// order.
TEST(ProjectedDisplacement, OnAResetGridIsExactWhereTheProjectionIs) {
  const double e = 0.5;  // h (1 + e) / 2 = 3/4 h: every third particle meets the lattice alike
  Specimen specimen = stretched(e, particles::Layout::per_element);
  specimen.reset = true;
  for (auto& named : specimen.conditions) named.second.imposed_by = mechanics::ImposedBy::grip;
  specimen.elements = {3, 12, 3};
  mechanics::MovingBody body = specimen.moving_body(world());
  test::take_steps(body, 4, test::to_rounding(), [&](double, const grid::Vector&) {});
  ASSERT_TRUE(body.begin_step());
  const auto& balance = body.balance();
  const auto& particles = balance.body().particles();

  // Equation 1 by plain sums over all particles of the line; masses cancel, all are equal.
  const double h = 2.1;
  std::map<int, std::pair<double, double>> sums;  // node along y: sum N, sum N u
  for (int n = 0; n < 24; ++n) {
    const double Y = (0.5 * n + 0.25) * h, y = (1.0 + e) * Y;
    const int lower = static_cast<int>(std::floor(y / h));
    const double xi = y / h - lower;
    sums[lower].first += 1.0 - xi;
    sums[lower].second += (1.0 - xi) * e * Y;
    sums[lower + 1].first += xi;
    sums[lower + 1].second += xi * e * Y;
  }
  for (int p = 0; p < particles.count(); ++p) {
    const int lower = static_cast<int>(std::floor(particles.position(p, 1) / h));
    const auto u = [&](int node) { return sums.at(node).second / sums.at(node).first; };
    const double slope = (u(lower + 1) - u(lower)) / h;
    EXPECT_NEAR(particles.base_gradient(p, 1, 1), 1.0 / (1.0 - slope) - 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace stroma
