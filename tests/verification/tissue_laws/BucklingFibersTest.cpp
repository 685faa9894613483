// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A bar of collagen fibres that buckle and stiffen, pulled: it contracts by more than it is
/// stretched, and is in the state of one point. Claim V-FIBER-5, docs/verification.md.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "stroma/material/FiberDirections.hpp"
#include "support/LawList.hpp"
#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using Number = std::complex<double>;
using Gradient = std::array<std::array<Number, 3>, 3>;
using Entries = std::vector<std::array<std::size_t, 2>>;  // of F
using mechanics::Face;

constexpr double matrix_mu = 5.0;  // [Pa], of a matrix without lateral contraction
constexpr int steps = 20;

struct Collagen {
  double k, d0, lambda_s, ds;  // Steinwachs et al. 2016, three concentrations
};
const Collagen gels[] = {{1449.0, 0.0022, 0.032, 0.055},
                         {6062.0, 0.0025, 0.0804, 0.034},
                         {900.0, 0.0004, 0.0075, 0.033}};

/// w(s) of a fibre.
Number fiber_energy(const Collagen& gel, Number s) {
  if (s.real() < 0.0) return gel.k * gel.d0 * gel.d0 * (std::exp(s / gel.d0) - 1.0 - s / gel.d0);
  if (s.real() < gel.lambda_s) return 0.5 * gel.k * s * s;
  const Number t = s - gel.lambda_s;
  return gel.k * (0.5 * gel.lambda_s * gel.lambda_s + gel.lambda_s * t +
                  gel.ds * gel.ds * (std::exp(t / gel.ds) - 1.0 - t / gel.ds));
}

/// mu/2 (tr C - 3) - mu ln J, and the mean of w over the directions.
Number energy(const Collagen& gel, const std::vector<material::FiberDirection>& directions,
              const Gradient& F) {
  Number square = 0.0, sum = 0.0;
  for (const auto& row : F)
    for (const Number f : row) square += f * f;
  const Number J = F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) -
                   F[0][1] * (F[1][0] * F[2][2] - F[1][2] * F[2][0]) +
                   F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
  for (const auto& direction : directions) {
    Number stretch = 0.0;
    for (const auto& row : F) {
      const Number m = row[0] * direction.n[0] + row[1] * direction.n[1] + row[2] * direction.n[2];
      stretch += m * m;
    }
    sum += direction.weight * fiber_energy(gel, std::sqrt(stretch) - 1.0);
  }
  return 0.5 * matrix_mu * (square - 3.0) - matrix_mu * std::log(J) + sum;
}

/// One point in equilibrium: some entries of F are free, and the stress that belongs to them is 0 but
/// for a pull [Pa] along y.
struct OnePoint {
  Collagen gel;
  std::vector<material::FiberDirection> directions;
  Entries free;
  Gradient F{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

  /// dW/dF of an entry [Pa], by a complex step.
  double stress(const std::array<std::size_t, 2>& entry) const {
    Gradient at = F;
    at[entry[0]][entry[1]] += Number(0.0, 1e-30);
    return energy(gel, directions, at).imag() / 1e-30;
  }
  std::vector<double> unbalanced(double pull) const {
    std::vector<double> all;
    for (const auto& entry : free)
      all.push_back(stress(entry) - (entry[0] == 1 && entry[1] == 1 ? pull : 0.0));
    return all;
  }
  /// Newton's method, with differences for the tangent.
  void relax(double pull) {
    const std::size_t n = free.size();
    for (int iteration = 0; iteration < 50; ++iteration) {
      std::vector<double> r = unbalanced(pull);
      std::vector<std::vector<double>> K(n, std::vector<double>(n));
      const double h = 1e-7;
      for (std::size_t b = 0; b < n; ++b) {
        Number& moved = F[free[b][0]][free[b][1]];
        moved += h;
        const auto up = unbalanced(pull);
        moved -= 2.0 * h;
        const auto down = unbalanced(pull);
        moved += h;
        for (std::size_t a = 0; a < n; ++a) K[a][b] = (up[a] - down[a]) / (2.0 * h);
      }
      for (std::size_t c = 0; c < n; ++c)  // positive definite: no pivoting
        for (std::size_t a = c + 1; a < n; ++a) {
          const double factor = K[a][c] / K[c][c];
          for (std::size_t b = c; b < n; ++b) K[a][b] -= factor * K[c][b];
          r[a] -= factor * r[c];
        }
      double change = 0.0;
      for (std::size_t c = n; c-- > 0;) {
        for (std::size_t b = c + 1; b < n; ++b) r[c] -= K[c][b] * r[b];
        r[c] /= K[c][c];
        F[free[c][0]][free[c][1]] -= r[c];
        change = std::max(change, std::abs(r[c]));
      }
      if (change < 1e-14) return;
    }
    double left = 0.0;
    for (const double r : unbalanced(pull)) left = std::max(left, std::abs(r));
    EXPECT_LT(left, 1e-10);
  }
  /// C = F^T F.
  double right_cauchy_green(std::size_t a, std::size_t b) const {
    double sum = 0.0;
    for (const auto& row : F) sum += row[a].real() * row[b].real();
    return sum;
  }
};

test::Specimen bar(const mechanics::LawList& laws) {
  test::Specimen specimen;
  specimen.elements = {1, 2, 1};
  specimen.other_laws = mechanics::Laws(laws);
  return specimen;
}

/// Fibres that point everywhere alike, with the quadrature's pole where the distribution has it.
material::MaterialParameters tissue(const Collagen& gel, material::Distribution distribution,
                                    int quadrature = 16) {
  material::MaterialParameters material = test::material_of(
      "Coupled Neo-Hookean", {{"Shear Modulus [Pa]", matrix_mu}, {"Lame Modulus [Pa]", 0.0}});
  auto family = test::fibers_of(
      "Buckling-Stiffening",
      {{"K [Pa]", gel.k}, {"D0", gel.d0}, {"Lambda S", gel.lambda_s}, {"DS", gel.ds}}, {0, 1, 0});
  family.distribution = distribution;
  family.quadrature = quadrature;
  material.fibers = material::FibersParameters{{{"collagen", family}}};
  return material;
}

std::vector<material::FiberDirection> directions_of(material::Distribution distribution,
                                                    int quadrature = 16) {
  material::DistributionParameters where;
  where.distribution = distribution;
  where.direction = {0.0, 1.0, 0.0};
  where.quadrature = quadrature;
  return material::directions(where);
}

/// Largest difference of C of any particle from the point's.
double difference(const mechanics::MovingBody& body, const grid::Vector& u, const OnePoint& point) {
  const auto H = body.balance().body().moved_particles(u).base_gradient;
  double worst = 0.0;
  for (int p = 0; p < body.balance().body().particles().count(); ++p)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        double sum = 0.0;
        for (int k = 0; k < 3; ++k) sum += ((k == a) + H(p, k, a)) * ((k == b) + H(p, k, b));
        worst =
            std::max(worst, std::abs(sum - point.right_cauchy_green(static_cast<std::size_t>(a),
                                                                    static_cast<std::size_t>(b))));
      }
  return world().max(worst);
}

/// Lateral contraction by axial extension, both of the length.
double poisson_ratio(const OnePoint& point) {
  const double across =
      std::sqrt(point.right_cauchy_green(0, 0)) + std::sqrt(point.right_cauchy_green(2, 2));
  return (1.0 - 0.5 * across) / (std::sqrt(point.right_cauchy_green(1, 1)) - 1.0);
}

// V-FIBER-5. A free bar of spherical fibres under tractions at its ends. The quadrature is not
// quite isotropic: the state is uniform, but with a little shear, which nothing hinders.
TEST(BucklingFibers, OfAFreeBarContractMoreThanTheyStretch) {
  for (const Collagen& gel : gels) {
    const double pull = 0.06 * gel.k;
    const mechanics::LawList laws =
        test::law_list(tissue(gel, material::Distribution::spherical), 2);
    test::Specimen specimen = bar(laws);
    mechanics::ExternalForce up, down;
    up.face = Face::y_upper;
    up.traction = {0.0, pull, 0.0};
    down.face = Face::y_lower;
    down.traction = {0.0, -pull, 0.0};
    specimen.forces = {{"up", up}, {"down", down}};
    // A dead pull turns a bar along itself: F e_y is along y.
    OnePoint point{gel,
                   directions_of(material::Distribution::spherical),
                   {{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 0}, {1, 2}}};
    mechanics::MovingBody body = specimen.moving_body(world());
    double worst = 0.0, largest = 0.0;
    test::take_steps(body, steps, test::to_rounding(), [&](double load, const grid::Vector& u) {
      point.relax(load * pull);
      worst = std::max(worst, difference(body, u, point));
      largest = std::max(largest, poisson_ratio(point));
    });
    EXPECT_LT(worst, 1e-8);
    EXPECT_GT(largest, 1.0);
    std::printf("  K %4.0f Pa: C within %.1e; at a stretch of %.3f contraction is %.2f of it\n",
                gel.k, worst, std::sqrt(point.right_cauchy_green(1, 1)), largest);
  }
}

// On rollers, pulled by 20 %. With the quadrature's pole along the pull, an axial family without
// preference, there is no shear, and the state is uniform; the spherical one's is nearly the same.
TEST(BucklingFibers, OfABarOnRollersContractMoreThanTheyStretch) {
  for (const auto kind : {material::Distribution::axial, material::Distribution::spherical})
    for (const Collagen& gel : gels) {
      const bool is_exact = kind == material::Distribution::axial;
      const mechanics::LawList laws = test::law_list(tissue(gel, kind), 2);
      test::Specimen specimen = bar(laws);
      specimen.conditions = {{"bottom", test::hold(Face::y_lower, "y")},
                             {"top", test::stretch(Face::y_upper, "y", 0.2)},
                             {"left", test::hold(Face::x_lower, "x")},
                             {"back", test::hold(Face::z_lower, "z")}};
      OnePoint point{gel, directions_of(kind), {{0, 0}, {2, 2}}};
      mechanics::MovingBody body = specimen.moving_body(world());
      double worst = 0.0, of_force = 0.0, above = 0.0, ratio = 0.0;
      test::take_steps(body, steps, test::to_rounding(), [&](double load, const grid::Vector& u) {
        point.F[1][1] = 1.0 + 0.2 * load;
        point.relax(0.0);
        worst = std::max(worst, difference(body, u, point));
        const double force = 2.1 * 2.0 * point.stress({1, 1});
        of_force = std::max(of_force, std::abs(test::reactions(body, u)[1][1] / force - 1.0));
        ratio = poisson_ratio(point);
        if (ratio > 1.0 && above == 0.0) above = 0.2 * load;
      });
      EXPECT_LT(worst, is_exact ? 1e-8 : 1e-3);
      EXPECT_LT(of_force, is_exact ? 1e-8 : 1e-3);
      EXPECT_GT(ratio, 1.0);
      std::printf(
          "  K %4.0f Pa: C within %.1e, force within %.1e; contraction above extension from %.2f "
          "on, at 0.2 %.2f of it\n",
          gel.k, worst, of_force, above, ratio);
    }
}

/// Largest difference of C between the bar on rollers and one point without shear, at a stretch of 1.05.
double departure_on_rollers(const Collagen& gel, int quadrature) {
  const auto kind = material::Distribution::spherical;
  test::Specimen specimen = bar(test::law_list(tissue(gel, kind, quadrature), 2));
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "y")},
                         {"top", test::stretch(Face::y_upper, "y", 0.05)},
                         {"left", test::hold(Face::x_lower, "x")},
                         {"back", test::hold(Face::z_lower, "z")}};
  OnePoint point{gel, directions_of(kind, quadrature), {{0, 0}, {2, 2}}};
  mechanics::MovingBody body = specimen.moving_body(world());
  double worst = 0.0;
  test::take_steps(body, 4, test::to_rounding(), [&](double load, const grid::Vector& u) {
    point.F[1][1] = 1.0 + 0.05 * load;
    point.relax(0.0);
    worst = std::max(worst, difference(body, u, point));
  });
  return worst;
}

// What is left of the spherical family on rollers is the shear of its quadrature.
TEST(BucklingFibers, OnRollersDepartByTheirQuadrature) {
  const double coarse = departure_on_rollers(gels[0], 8), fine = departure_on_rollers(gels[0], 32);
  std::printf("  C within %.1e with 8 rings, %.1e with 32\n", coarse, fine);
  EXPECT_LT(fine, coarse / 4.0);
}

}  // namespace
}  // namespace stroma
