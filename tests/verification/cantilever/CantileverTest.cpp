// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A slender cantilever under a tip load, bent far, on a grid that is reset. Claim V-CANT-1,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using mechanics::ImposedBy;
using test::Specimen;

// V-CANT-1. L = 20 thicknesses, nu = 0, so that plane strain bends as a plane beam does; the tip is
// pushed down, up to P L^2 / EI = 10, in ten steps. The beam has turned by more than 80 degrees
// then and lies across the lattice at every angle. What the elastica leaves out, shear and the
// strain of the fibres, up to 11 %, softens the beam by a few thousandths here; so do the domains,
// over each of which the strain of bending is averaged, by 1/24^2 with 24 particles across.
TEST(Cantilever, BendsAsTheElasticaDoes) {
  const double thickness = 1.0, L = 20.0, young = 2000.0;  // [um], [Pa]
  const double EI = young * thickness * thickness * thickness / 12.0;
  constexpr int across = 4, per_element = 6;
  Specimen specimen;
  specimen.shape_functions = shape::ShapeFunctions::quadratic_b_spline;
  specimen.reset = true;
  specimen.stabilization = 0.01;
  specimen.plane_strain = true;
  specimen.elements = {across * 20, across, 1};
  specimen.spacing = {thickness / across, thickness / across, 1.0};
  specimen.layout = {particles::Layout::per_element, 1, per_element};
  specimen.laws = {{young / 2.0, young / 3.0}};  // mu and K
  mechanics::ExternalForce load;
  load.traction = std::array<double, 3>{0.0, -10.0 * EI / (L * L) / thickness, 0.0};
  load.face = Face::x_upper;
  specimen.forces = {{"tip", load}};
  specimen.conditions = {{"clamp", test::hold(Face::x_lower, "xyz")}};
  specimen.conditions[0].second.imposed_by = ImposedBy::nodes;
  solver::SolverParameters parameters = test::to_rounding();
  parameters.newton_tolerance = 1e-6;
  parameters.newton_iterations = 30;
  parameters.linear_tolerance = 1e-10;

  const std::map<int, std::pair<double, double>> elastica{// alpha: w / L down, u / L back
                                                          {1, {0.30172, 0.05643}},
                                                          {5, {0.71379, 0.38763}},
                                                          {10, {0.81061, 0.55500}}};
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::self());
  test::take_steps(body, 10, parameters, [&](double load_factor, const grid::Vector& u) {
    const int alpha = static_cast<int>(std::lround(10.0 * load_factor));
    if (elastica.count(alpha) == 0) return;
    // The tip: from the outermost column of particles to the end, as they are strained there.
    const auto& particles = body.balance().body().particles();
    const auto fields = body.balance().body().particle_fields(u);
    const auto gradient = body.balance().body().moved_particles(u).base_gradient;
    double count = 0.0, w = 0.0, back = 0.0;
    for (int p = 0; p < particles.count(); ++p) {
      const double beyond = L - particles.undeformed_position(p, 0);
      if (beyond > specimen.spacing[0] / per_element) continue;
      count += 1.0;
      back -= (fields.displacement(p, 0) + gradient(p, 0, 0) * beyond) / L;
      w -= (fields.displacement(p, 1) + gradient(p, 1, 0) * beyond) / L;
    }
    ASSERT_EQ(count, across * per_element);
    w /= count;
    back /= count;
    const auto& [exact_w, exact_back] = elastica.at(alpha);
    std::printf("  alpha %2d: w/L %.5f (%+.2f %%), u/L %.5f (%+.2f %%)\n", alpha, w,
                100.0 * (w / exact_w - 1.0), back, 100.0 * (back / exact_back - 1.0));
    EXPECT_NEAR(w, exact_w, 0.01 * exact_w);
    EXPECT_NEAR(back, exact_back, 0.01 * exact_back);
  });
}

}  // namespace
}  // namespace stroma
