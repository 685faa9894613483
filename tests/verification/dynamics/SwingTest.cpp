// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A block of two materials that swings on its clamped base, against an independent finite element
/// solution (tests/data/reference/T2_dynamic_swing.json). Claim V-DYN-SWING, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/LoadSteps.hpp"
#include "support/Places.hpp"
#include "support/Specimen.hpp"

namespace stroma {
namespace {

nlohmann::json reference() {
  std::ifstream file(test::clone_folder().string() + "/tests/data/reference/T2_dynamic_swing.json");
  return nlohmann::json::parse(file);
}

test::Specimen block(const nlohmann::json& reference) {
  test::Specimen specimen;
  const std::string law = reference.at("law_of_point");
  specimen.label = [law](const grid::Index3& voxel) {
    const auto of = [&](std::size_t d) { return static_cast<std::size_t>(voxel[d]); };
    const std::size_t element = of(0) / 2 + 4 * (of(1) / 2 + 4 * (of(2) / 2));
    const std::size_t point = of(0) % 2 + 2 * (of(1) % 2) + 4 * (of(2) % 2);
    return law[8 * element + point] - '0';
  };
  specimen.conditions = {{"base", test::hold(mechanics::Face::y_lower, "xyz")}};
  specimen.density = {1000.0, 1100.0};
  specimen.duration = 2e-5;
  mechanics::Dynamics dynamics;
  const double height = specimen.grid().length(1);
  dynamics.initial_velocity = [height](const std::array<double, 3>& X) {
    return std::array<double, 3>{2e5 * (X[1] / height) * (X[1] / height), 0.0, 0.0};
  };
  specimen.dynamics = dynamics;
  return specimen;
}

double strain_energy(const mechanics::Body& body, const grid::Vector& u) {
  const auto fields = body.particle_fields(u);
  double sum = 0.0;
  for (int p = 0; p < body.particles().count(); ++p)
    sum += fields.energy(p) * body.particles().volume(p);
  return body.communicator().sum(sum);
}

// Reactions, energies of each of 20 steps, and all displacements of the last: to the reference's ten
// digits.
TEST(Swing, IsThatOfTheReference) {
  const nlohmann::json expected = reference();
  const auto& steps = expected.at("results").at("steps");
  mechanics::MovingBody body = block(expected).moving_body(base::Communicator::world());
  constexpr double close = 1e-8;
  std::size_t step = 0;
  solver::SolverParameters exact = test::to_rounding();
  exact.newton_tolerance = 1e-12;
  test::take_steps(body, 20, exact, [&](double, const grid::Vector& u) {
    const auto& one = steps.at(step++);
    SCOPED_TRACE(step);
    const double kinetic = one.at("kinetic_energy"), elastic = one.at("energy");
    EXPECT_NEAR(body.balance().inertia()->kinetic_energy(), kinetic, close * kinetic);
    EXPECT_NEAR(strain_energy(body.balance().body(), u), elastic, close * elastic);
    const auto force = one.at("F_y0").get<std::array<double, 3>>();
    const auto found = test::reactions(body, u)[0];
    const double size = std::hypot(force[0], force[1], force[2]);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], force[c], close * size);
    if (step < 20) return;
    const auto displacement =
        expected.at("results").at("displacement").get<std::vector<std::array<double, 3>>>();
    double largest = 0.0;
    for (const auto& of_node : displacement)
      for (const double component : of_node) largest = std::max(largest, std::abs(component));
    test::for_each_unknown(
        body.balance().halo(), u, [&](const grid::Index3& node, int c, double value) {
          const auto n = static_cast<std::size_t>(node[0] + 5 * (node[1] + 5 * node[2]));
          EXPECT_NEAR(value, displacement[n][static_cast<std::size_t>(c)], close * largest);
        });
  });
}

}  // namespace
}  // namespace stroma
