// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The solid of Holzapfel, Gasser and Ogden in states that are solved on paper, and against its
/// energy, written down a second time and differentiated by complex steps. Claim V-MAT-9,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "LawChecks.hpp"
#include "support/NamedMaterial.hpp"

namespace stroma::material {
namespace {

using Number = std::complex<double>;
using Direction = std::array<double, 3>;

constexpr double c = 400.0, k1 = 200.0, k2 = 3.0, K = 3000.0;
constexpr double dispersions[] = {0.0, 0.1, 0.226, 1.0 / 3.0};

AnyLaw artery(double kappa, const std::vector<Direction>& directions) {
  MaterialParameters material = stroma::test::material_of(
      "Holzapfel-Gasser-Ogden",
      {{"C [Pa]", c}, {"K1 [Pa]", k1}, {"K2", k2}, {"Kappa", kappa}, {"Bulk Modulus [Pa]", K}});
  material.fibers = FibersParameters{};
  for (const Direction& direction : directions) {
    FiberParameters family;
    family.direction = direction;
    material.fibers->families.emplace_back("family", family);
  }
  return laws_of({{"artery", material}}).laws.front();
}

/// dpsi/dE of a family.
double slope(double e) { return e > 0.0 ? k1 * e * std::exp(k2 * e * e) : 0.0; }

// V-MAT-9. An isochoric stretch l along x, two families at +-45 degrees in the plane of x and y;
// shortened families carry nothing.
TEST(Artery, UniaxialStretchHasTheAnalyticStress) {
  for (const double kappa : dispersions)
    for (const double l : {0.7, 1.2, 1.5}) {
      const AnyLaw law = artery(kappa, {{1, 1, 0}, {1, -1, 0}});
      Tensor3 at;
      at(0, 0) = l - 1.0;
      at(1, 1) = at(2, 2) = 1.0 / std::sqrt(l) - 1.0;
      const double e =
          kappa * (l * l + 2.0 / l - 3.0) + (1.0 - 3.0 * kappa) * (0.5 * (l * l + 1.0 / l) - 1.0);
      const double matrix = c + 4.0 * slope(e) * kappa,
                   fibers = 4.0 * slope(e) * (1.0 - 3.0 * kappa);
      const Tensor3 tau = kirchhoff_stress(law, at);
      EXPECT_NEAR(tau(0, 0) - tau(2, 2), matrix * (l * l - 1.0 / l) + fibers * 0.5 * l * l,
                  1e-10 * c);
      EXPECT_NEAR(tau(1, 1) - tau(2, 2), fibers * 0.5 / l, 1e-10 * c);
      EXPECT_NEAR(tau(0, 1), 0.0, 1e-10 * c);
      EXPECT_NEAR(tensor::trace(tau), 0.0, 1e-10 * K);
    }
}

// A stretch l along the fibres' x alone.
TEST(Artery, ConfinedStretchHasTheAnalyticStress) {
  for (const double kappa : dispersions)
    for (const double l : {0.8, 1.1, 1.4}) {
      const AnyLaw law = artery(kappa, {{1, 0, 0}});
      Tensor3 at;
      at(0, 0) = l - 1.0;
      const double bar = std::pow(l, -2.0 / 3.0);
      const double e =
          kappa * (bar * (l * l + 2.0) - 3.0) + (1.0 - 3.0 * kappa) * (bar * l * l - 1.0);
      const double difference = bar * ((c + 2.0 * slope(e) * kappa) * (l * l - 1.0) +
                                       2.0 * slope(e) * (1.0 - 3.0 * kappa) * l * l);
      const double pressure = 0.5 * K * (l * l - 1.0);
      const Tensor3 tau = kirchhoff_stress(law, at);
      EXPECT_NEAR(tau(0, 0), pressure + 2.0 / 3.0 * difference, 1e-10 * c);
      EXPECT_NEAR(tau(1, 1), pressure - 1.0 / 3.0 * difference, 1e-10 * c);
      EXPECT_NEAR(tau(2, 2), pressure - 1.0 / 3.0 * difference, 1e-10 * c);
    }
}

// Shear g along x of fibres along y: Ibar1 - 3 = Ibar4 - 1 = g^2.
TEST(Artery, SimpleShearHasTheAnalyticStress) {
  for (const double kappa : dispersions)
    for (const double g : {-0.3, 0.5}) {
      const AnyLaw law = artery(kappa, {{0, 2, 0}});
      Tensor3 at;
      at(0, 1) = g;
      const double e = (1.0 - 2.0 * kappa) * g * g, rest = 1.0 - 3.0 * kappa;
      const double matrix = c + 2.0 * slope(e) * kappa, fibers = 2.0 * slope(e) * rest;
      const Tensor3 tau = kirchhoff_stress(law, at);
      EXPECT_NEAR(tau(0, 1), (matrix + fibers) * g, 1e-10 * c);
      EXPECT_NEAR(tau(0, 0) - tau(2, 2), (matrix + fibers) * g * g, 1e-10 * c);
      EXPECT_NEAR(tau(1, 1) - tau(2, 2), fibers, 1e-10 * c);
      EXPECT_NEAR(energy(law, at), 0.5 * c * g * g + 0.5 * k1 / k2 * std::expm1(k2 * e * e),
                  1e-10 * c);
    }
}

/// The energy as it is written.
Number written_energy(const std::array<std::array<Number, 3>, 3>& F, double kappa,
                      const std::vector<Direction>& directions) {
  const Number J = F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) -
                   F[0][1] * (F[1][0] * F[2][2] - F[1][2] * F[2][0]) +
                   F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
  const Number bar = std::pow(J, -2.0 / 3.0);
  Number square = 0.0;
  for (const auto& row : F)
    for (const Number f : row) square += f * f;
  Number sum = 0.5 * c * (bar * square - 3.0) + 0.5 * K * (0.5 * (J * J - 1.0) - std::log(J));
  for (const Direction& n : directions) {
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    Number stretch = 0.0;
    for (const auto& row : F) {
      const Number m = (row[0] * n[0] + row[1] * n[1] + row[2] * n[2]) / length;
      stretch += m * m;
    }
    const Number e = kappa * (bar * square - 3.0) + (1.0 - 3.0 * kappa) * (bar * stretch - 1.0);
    if (e.real() > 0.0) sum += 0.5 * k1 / k2 * (std::exp(k2 * e * e) - 1.0);
  }
  return sum;
}

// Three families in a general state: some are stretched, and one is shortened.
TEST(Artery, HasTheStressOfItsEnergyAsItIsWritten) {
  const std::vector<Direction> directions{{1, 2, 2}, {-3, 4, 0}, {0, 1, 5}};
  const double h = 1e-30;
  for (const double kappa : dispersions)
    for (const double size : {0.3, 1.0, 1.5}) {
      const AnyLaw law = artery(kappa, directions);
      const Tensor3 at = size * test::H, F = tensor::identity() + at;
      std::array<std::array<Number, 3>, 3> here;
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          here[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)] = F(k, l);
      Tensor3 piola;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          auto moved = here;
          moved[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += Number(0.0, h);
          piola(i, j) = written_energy(moved, kappa, directions).imag() / h;
        }
      const Tensor3 expected = piola * tensor::transpose(F), found = kirchhoff_stress(law, at);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(found(i, j), expected(i, j), 1e-10 * c);
      EXPECT_NEAR(energy(law, at), written_energy(here, kappa, directions).real(), 1e-10 * c);
    }
}

}  // namespace
}  // namespace stroma::material
