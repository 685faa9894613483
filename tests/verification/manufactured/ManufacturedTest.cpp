/// \file
/// A displacement that was chosen, and the body force that makes it the solution: how fast the
/// method approaches it. Claims V-MAN-1 and V-MAN-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "support/LoadSteps.hpp"
#include "support/ShapeChoices.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using mechanics::ImposedBy;
using test::Specimen;
using Vector3 = std::array<double, 3>;

const double pi = std::acos(-1.0);
const Vector3 amplitude{0.05 * std::sin(2.0 * pi / 3.0), 0.05 * std::sin(4.0 * pi / 3.0), 0.0};
const material::NeoHookean law{520.8, 2430.4};

/// u_i = A_i sin(pi X_i) on the unit square.
double displacement(int i, double X) {
  return amplitude[static_cast<std::size_t>(i)] * std::sin(pi * X);
}

/// Force per reference volume. F is diagonal, a_i = 1 + du_i/dX_i, and so is the first
/// Piola-Kirchhoff stress, P_i = tau_i / a_i, of which X_i changes a_i alone:
///
///     B_i = -dP_i/dX_i = -a_i' { K (1 - ln J) / a_i^2 + mu J^(-2/3) (-1/3 + 5 tr b / (9 a_i^2)) }.
Vector3 body_force(const Vector3& X) {
  Vector3 a, change;
  double J = 1.0, trace = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = 1.0 + amplitude[i] * pi * std::cos(pi * X[i]);
    change[i] = -amplitude[i] * pi * pi * std::sin(pi * X[i]);
    J *= a[i];
    trace += a[i] * a[i];
  }
  Vector3 force;
  for (std::size_t i = 0; i < 3; ++i)
    force[i] = -change[i] * (law.bulk_modulus * (1.0 - std::log(J)) / (a[i] * a[i]) +
                             law.shear_modulus * std::pow(J, -2.0 / 3.0) *
                                 (-1.0 / 3.0 + 5.0 * trace / (9.0 * a[i] * a[i])));
  return force;
}

int env(const char* name, int fallback) {
  const char* v = std::getenv(name);
  return v ? std::atoi(v) : fallback;
}

/// Error of the displacement at the particles, root mean square by volume, and of the stress.
std::array<double, 2> errors(const test::ShapeChoice& choice, std::int64_t n, bool reset) {
  Specimen specimen;
  choice.apply_to(specimen);
  specimen.reset = reset;
  specimen.plane_strain = true;
  specimen.elements = {n, n, 1};
  specimen.spacing = {1.0 / static_cast<double>(n), 1.0 / static_cast<double>(n), 1.0};
  specimen.layout = {particles::Layout::per_element, 1, env("PPE", 2)};
  specimen.laws = {law};
  specimen.body_force = body_force;
  specimen.stabilization = reset ? 0.01 * env("STAB", 1) : 0.0;
  specimen.conditions = {{"x-", test::hold(Face::x_lower, "x")},
                         {"x+", test::hold(Face::x_upper, "x")},
                         {"y-", test::hold(Face::y_lower, "y")},
                         {"y+", test::hold(Face::y_upper, "y")}};
  for (auto& named : specimen.conditions) named.second.imposed_by = ImposedBy::nodes;
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::self());
  double sum = 0.0, volume = 0.0, stress = 0.0;
  solver::SolverParameters p = test::to_rounding();
  p.newton_tolerance = 1e-10;
  test::take_steps(body, reset ? env("STEPS", 5) : 2, p, [&](double load, const grid::Vector& u) {
    if (load < 1.0) return;
    const auto& particles = body.balance().particles();
    const auto fields = body.balance().particle_fields(u);
    for (int q = 0; q < particles.count(); ++q) {
      volume += particles.volume(q);
      double a[3] = {1, 1, 1};
      for (int d = 0; d < 2; ++d) {
        const double X = particles.undeformed_position(q, d);
        const double error = fields.displacement(q, d) - displacement(d, X);
        sum += particles.volume(q) * error * error;
        a[d] = 1.0 + amplitude[static_cast<std::size_t>(d)] * pi * std::cos(pi * X);
      }
      const double J = a[0] * a[1];
      const double error = fields.jacobian(q) - J;
      stress += particles.volume(q) * error * error;
    }
  });
  return {std::sqrt(sum / volume), std::sqrt(stress / volume)};
}

class Manufactured : public ::testing::TestWithParam<test::ShapeChoice> {};

TEST_P(Manufactured, Explore) {
  for (const bool reset : {false, true}) {
    std::array<double, 2> before{};
    for (int n = 4; n <= env("MAX", 32); n *= 2) {
      try {
        const auto now = errors(GetParam(), n, reset);
        std::printf("%-20s %s n=%2d u %.3e (%.2f)  J %.3e (%.2f)\n", GetParam().name.c_str(),
                    reset ? "reset" : "     ", n, now[0], std::log2(before[0] / now[0]), now[1],
                    std::log2(before[1] / now[1]));
        before = now;
      } catch (const std::exception& e) {
        std::printf("%-20s %s n=%2d %s\n", GetParam().name.c_str(), reset ? "reset" : "     ", n,
                    e.what());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Manufactured, ::testing::ValuesIn(test::shape_choices()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace stroma
