// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Loss of ellipticity of a coupled neo-Hookean body, against its closed form. Claim V-ELL-1,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

constexpr double mu = 100.0, lambda = 1500.0;  // [Pa]

/// Of a coupled neo-Hookean body that is deformed by F = diag(stretch).
mechanics::Localization localization_of(const std::array<double, 3>& stretch, int share = 1) {
  test::Specimen specimen;
  specimen.other_laws = mechanics::LawList{
      {material::CoupledNeoHookean{mu, lambda}, material::CoupledNeoHookean{mu, lambda}}};
  const auto balance = specimen.balance(world());
  grid::Vector u(balance->owned_map());
  test::fill(balance->halo(), u, [&](const grid::Index3& node, int c) {
    const auto d = static_cast<std::size_t>(c);
    return (stretch[d] - 1.0) * static_cast<double>(node[c]) * specimen.spacing[d];
  });
  return balance->body().localization(u, share);
}

/// A wave across n along itself: Q = mu (n . b n) I + (lambda + mu - lambda ln J) n x n.
double modulus(const std::array<double, 3>& stretch, std::size_t n) {
  const double J = stretch[0] * stretch[1] * stretch[2];
  return mu * stretch[n] * stretch[n] + lambda + mu - lambda * std::log(J);
}

// V-ELL-1. Waves along the least stretch are the first to lose their modulus.
TEST(Localization, IsWhereALongitudinalWaveHasANegativeModulus) {
  const std::array<double, 3> far{1.9, 1.3, 1.7};
  ASSERT_LT(modulus(far, 1), 0.0);
  const mechanics::Localization found = localization_of(far);
  const test::Specimen specimen;
  EXPECT_EQ(found.particles,
            8 * specimen.elements[0] * specimen.elements[1] * specimen.elements[2]);
  EXPECT_NEAR(found.worst.figure, modulus(far, 1), 1e-6 * lambda);
  EXPECT_NEAR(std::abs(found.direction[1]), 1.0, 1e-6);
  const mechanics::Localization of_some = localization_of(far, 4);
  EXPECT_GT(of_some.particles, 0);
  EXPECT_LT(of_some.particles, found.particles / 2);
  EXPECT_EQ(of_some.particles % 8, 0);
}

TEST(Localization, BeginsWhereTheModulusVanishes) {
  double sound = 1.0, lost = 3.0;  // stretch all around
  while (lost - sound > 1e-12) {
    const double s = 0.5 * (sound + lost);
    (modulus({s, s, s}, 0) > 0.0 ? sound : lost) = s;
  }
  const auto particles = [](double s) { return localization_of({s, s, s}).particles; };
  EXPECT_EQ(particles(sound * (1.0 - 1e-9)), 0);
  EXPECT_GT(particles(lost * (1.0 + 1e-9)), 0);
  for (const std::array<double, 3>& stretch :
       {std::array{1.0, 1.0, 1.0}, {0.3, 0.4, 0.5}, {3.0, 0.5, 0.7}, {1.5, 1.0, 1.4}}) {
    ASSERT_GT(std::min({modulus(stretch, 0), modulus(stretch, 1), modulus(stretch, 2)}), 0.0);
    EXPECT_EQ(localization_of(stretch).particles, 0);
  }
}

// Its tangent is no number, which is another fault.
TEST(Localization, IsNotThatOfABodyTurnedInsideOut) {
  EXPECT_EQ(localization_of({-1.0, 1.0, 1.0}).particles, 0);
}

}  // namespace
}  // namespace stroma
