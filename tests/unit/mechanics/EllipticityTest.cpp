// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The least modulus of a plane wave, against its closed form. Claim V-ELL-1, docs/verification.md.

#include <gtest/gtest.h>

#include "support/Specimen.hpp"

namespace stroma {
namespace {

base::Communicator world() { return base::Communicator::world(); }

/// Of a coupled neo-Hookean body that is deformed by F = diag(stretch).
mechanics::Ellipticity least_of(const std::array<double, 3>& stretch, double mu) {
  test::Specimen specimen;
  specimen.other_laws = mechanics::LawList{
      {material::CoupledNeoHookean{mu, 1500.0}, material::CoupledNeoHookean{mu, 1500.0}}};
  const auto balance = specimen.balance(world());
  grid::Vector u(balance->owned_map());
  test::fill(balance->halo(), u, [&](const grid::Index3& node, int c) {
    const auto d = static_cast<std::size_t>(c);
    return (stretch[d] - 1.0) * static_cast<double>(node[c]) * specimen.spacing[d];
  });
  return balance->body().ellipticity(u);
}

// V-ELL-1. Waves across n with a polarisation across n have the modulus mu n.b.n: at rest mu, in a
// stretched body that across its shortest axis.
TEST(Ellipticity, IsTheLeastShearWave) {
  constexpr double mu = 520.8;
  EXPECT_NEAR(least_of({1.0, 1.0, 1.0}, mu).softest.figure, mu, 1e-9 * mu);
  const double least = least_of({1.2, 0.9, 1.05}, mu).softest.figure;
  EXPECT_GE(least, 0.81 * mu * (1.0 - 1e-9));
  EXPECT_LE(least, 0.82 * mu);  // no direction of the list is quite along y
}

}  // namespace
}  // namespace stroma
