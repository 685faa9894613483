// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A laminate of a soft and a stiff layer, pulled across and along, with the interface on faces of
/// elements and inside elements. Claims V-LAM-1 to V-LAM-3, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/LoadSteps.hpp"
#include "support/ShapeChoices.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using mechanics::ImposedBy;
using test::Specimen;

constexpr double L = 12.0;                                            // [um]
const material::NeoHookean law[2] = {{520.8, 2430.4}, {5208, 8000}};  // lower layer, upper layer

/// Root of an increasing function between 0.3 and 3, by bisection.
double root(const std::function<double(double)>& f) {
  double lower = 0.3, upper = 3.0;
  for (int n = 0; n < 200; ++n) {
    const double middle = 0.5 * (lower + upper);
    (f(middle) < 0.0 ? lower : upper) = middle;
  }
  return lower;
}

/// Nominal stress P_yy at the stretches ax, ay in plane strain, from the law as docs/theory.md
/// writes it, (3.1), with long-hand algebra.
double stress_across(const material::NeoHookean& m, double ax, double ay) {
  const double J = ax * ay, trace = ax * ax + ay * ay + 1.0;
  const double tau = m.shear_modulus * std::pow(J, -2.0 / 3.0) * (ay * ay - trace / 3.0) +
                     m.bulk_modulus * std::log(J);
  return tau / ay;
}

/// The stretches of both layers across them.
struct Exact {
  double a[2];
  double displacement(double Y) const {
    return Y < 0.5 * L ? (a[0] - 1.0) * Y : (a[0] - 1.0) * 0.5 * L + (a[1] - 1.0) * (Y - 0.5 * L);
  }
};

/// n elements across the layers; the interface is on a face if n is even, else inside elements.
Specimen laminate(const test::ShapeChoice& choice, bool reset, std::int64_t n) {
  Specimen specimen;
  choice.apply_to(specimen);
  specimen.reset = reset;
  specimen.stabilization = reset ? 0.01 : 0.0;
  specimen.plane_strain = true;
  specimen.elements = {4, n, 1};
  const double h = L / static_cast<double>(n);
  specimen.spacing = {h, h, h};
  specimen.layout = {particles::Layout::per_element, 1, 2};
  specimen.laws = {law[0], law[1]};
  specimen.label = [n](const grid::Index3& voxel) { return voxel[1] < n ? 0 : 1; };
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "y")},
                         {"left", test::hold(Face::x_lower, "x")}};
  for (auto& named : specimen.conditions) named.second.imposed_by = ImposedBy::nodes;
  return specimen;
}

/// Error of the displacement along y at the particles, root mean square, by L.
double error(const Specimen& specimen, int steps, const Exact& exact) {
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::self());
  double squares = 0.0;
  int count = 0;
  test::take_steps(body, steps, test::to_rounding(), [&](double load, const grid::Vector& u) {
    if (load < 1.0) return;
    const auto& particles = body.balance().body().particles();
    const auto fields = body.balance().body().particle_fields(u);
    count = particles.count();
    for (int p = 0; p < count; ++p) {
      const double Y = particles.undeformed_position(p, 1);
      const double e = fields.displacement(p, 1) - exact.displacement(Y);
      squares += e * e;
    }
  });
  return std::sqrt(squares / count) / L;
}

/// Pulled across by a traction, between sides that do not move: the stress is the traction in both.
double error_across(const test::ShapeChoice& choice, bool reset, std::int64_t n) {
  Specimen specimen = laminate(choice, reset, n);
  const double traction = 900.0;
  specimen.conditions.push_back({"right", test::hold(Face::x_upper, "x")});
  specimen.conditions.back().second.imposed_by = ImposedBy::nodes;
  mechanics::ExternalForce pull;
  pull.traction = std::array<double, 3>{0.0, traction, 0.0};
  pull.face = Face::y_upper;
  specimen.forces = {{"pull", pull}};
  Exact exact{};
  for (int m = 0; m < 2; ++m)
    exact.a[m] = root([&](double a) { return stress_across(law[m], 1.0, a) - traction; });
  return error(specimen, reset ? 8 : 2, exact);
}

/// Stretched along by a quarter, free across: each layer grows thin for itself.
double error_along(const test::ShapeChoice& choice, std::int64_t n) {
  Specimen specimen = laminate(choice, false, n);
  specimen.conditions.push_back({"right", test::stretch(Face::x_upper, "x", 0.25)});
  Exact exact{};
  for (int m = 0; m < 2; ++m)
    exact.a[m] = root([&](double a) { return stress_across(law[m], 1.25, a); });
  return error(specimen, 2, exact);
}

class Laminate : public ::testing::TestWithParam<test::ShapeChoice> {
 protected:
  static bool is_smooth_at_nodes() {
    return GetParam().shape_functions == shape::ShapeFunctions::quadratic_b_spline ||
           GetParam().shape_functions == shape::ShapeFunctions::cubic_b_spline;
  }
};

// V-LAM-1. Hats, and their means over domains that end at the interface, have its kink: with the
// interface on faces of elements they are exact. B-splines smooth it over.
TEST_P(Laminate, IsExactWithTheInterfaceOnFaces) {
  if (is_smooth_at_nodes()) return;
  EXPECT_LT(error_across(GetParam(), false, 6), 1e-12);
  EXPECT_LT(error_along(GetParam(), 6), 1e-12);
}

/// Mean order of convergence between two numbers of elements.
double order(const std::function<double(std::int64_t)>& error, std::int64_t coarse,
             std::int64_t fine) {
  const double before = error(coarse), now = error(fine);
  std::printf("  %2d elements: %.2e L, %2d elements: %.2e L\n", static_cast<int>(coarse), before,
              static_cast<int>(fine), now);
  return std::log(before / now) / std::log(static_cast<double>(fine) / static_cast<double>(coarse));
}

// V-LAM-2. With the interface in the middle of elements, and for B-splines anywhere, the
// displacement is of first order.
TEST_P(Laminate, IsOfFirstOrderWithTheInterfaceInsideElements) {
  const auto across = [](std::int64_t n) { return error_across(GetParam(), false, n); };
  const auto along = [](std::int64_t n) { return error_along(GetParam(), n); };
  EXPECT_NEAR(order(across, 13, 49), 1.0, 0.05);
  EXPECT_NEAR(order(along, 13, 49), 1.0, 0.05);
  if (!is_smooth_at_nodes()) return;
  EXPECT_NEAR(order(across, 12, 48), 1.0, 0.05);
  EXPECT_NEAR(order(along, 12, 48), 1.0, 0.05);
}

class LaminateReset : public ::testing::TestWithParam<test::ShapeChoice> {};

// V-LAM-3. With reset, the interface wanders through the elements, and the error is that of
// wherever it lies at the time; it stays below a line of first order.
TEST_P(LaminateReset, IsOfFirstOrder) {
  for (const std::int64_t n : {6, 7, 12, 13, 24, 25, 48, 49}) {
    const double error = error_across(GetParam(), true, n);
    std::printf("  %-18s %2d elements: %.2e L\n", GetParam().name.c_str(), static_cast<int>(n),
                error);
    EXPECT_LT(error, 0.09 / static_cast<double>(n));
  }
}

INSTANTIATE_TEST_SUITE_P(Smooth, LaminateReset, ::testing::ValuesIn(test::smooth_choices()),
                         [](const auto& tested) { return tested.param.name; });
INSTANTIATE_TEST_SUITE_P(All, Laminate, ::testing::ValuesIn(test::shape_choices()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace stroma
