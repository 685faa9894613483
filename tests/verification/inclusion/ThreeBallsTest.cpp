// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Three stiff balls in a block, object by object in objects.csv, against Eshelby. Claim V-TABLE-5,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "support/Program.hpp"
#include "support/TableRows.hpp"

namespace stroma::test {
namespace {

constexpr double mu = 500.0, nu = 0.4, bulk = 2.0 * mu * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
constexpr double stiffer = 10.0, dilatation = 3e-4, deviatoric = 1e-4;

/// Balls of so many voxels, one an element, 8 radii apart, in a block whose faces are 4 radii away
/// from their middles and take part in a uniform strain.
std::string deck(int radius) {
  const double lateral = dilatation / 3.0 - 0.5 * deviatoric;
  std::ostringstream text;
  text.precision(17);
  text << "Stroma:\n  Image:\n    Phantom:\n      Kind: Shapes\n      Size: [" << 24 * radius
       << ", " << 8 * radius << ", " << 8 * radius
       << "]\n      Voxel Size [um]: [1, 1, 1]\n      Shapes:\n";
  for (const int ball : {0, 1, 2})
    text << "        ball" << ball << ": {Kind: Ball, Label: 1, \"Radius [um]\": " << radius
         << ", \"Center [um]\": [" << (4 + 8 * ball) * radius << ", " << 4 * radius << ", "
         << 4 * radius << "]}\n";
  text << "  Materials:\n    gel: {Label: 0, \"Shear Modulus [Pa]\": " << mu
       << ", Poisson Ratio: " << nu
       << "}\n    ball: {Label: 1, \"Shear Modulus [Pa]\": " << stiffer * mu
       << ", Poisson Ratio: " << nu
       << "}\n  Particles: {Layout: Per Element, Per Element: 2}\n"
          "  Grid: {\"Element Size [um]\": [1, 1, 1]}\n"
          "  Boundary Conditions:\n    all: {Face: all, Components: xyz, Displacement Gradient: ["
       << dilatation / 3.0 + deviatoric << ", 0, 0, 0, " << lateral << ", 0, 0, 0, " << lateral
       << "]}\n  Loading: {Steps: 1}\n  Solver: {Newton Tolerance: 1e-7}\n"
          "  Output: {Pictures: false, Report: false, Particles Every: 0, Grid Every: 0}\n";
  return text.str();
}

struct Ball {
  double voxels, volume, deviatoric, mean;  // stress there by that far away
};

std::array<Ball, 3> balls_of(int radius) {
  const TemporaryFolder folder;
  run_deck(folder, "balls", deck(radius), 2);
  const auto rows = rows_of(folder / "balls/objects.csv");
  EXPECT_EQ(rows.size(), 3U);
  std::array<Ball, 3> balls{};
  for (std::size_t b = 0; b < std::min<std::size_t>(rows.size(), 3); ++b) {
    const auto at = [&](const char* column) { return std::stod(rows[b].at(column)); };
    const double mean = (at("stress_xx") + at("stress_yy") + at("stress_zz")) / 3.0;
    balls[b] = {at("voxels"), at("volume"), (at("stress_xx") - mean) / (2.0 * mu * deviatoric),
                mean / (bulk * dilatation)};
    std::printf("  radius %d, ball %d: deviatoric %.4f, mean %.4f\n", radius,
                static_cast<int>(b) + 1, balls[b].deviatoric, balls[b].mean);
  }
  return balls;
}

/// Voxels of a ball whose middle is a corner of voxels.
double voxels_of_ball(int radius) {
  double count = 0.0;
  for (int k = -radius; k < radius; ++k)
    for (int j = -radius; j < radius; ++j)
      for (int i = -radius; i < radius; ++i)
        count +=
            std::pow(i + 0.5, 2) + std::pow(j + 0.5, 2) + std::pow(k + 0.5, 2) <= radius * radius;
  return count;
}

// V-TABLE-5. For the strains see InclusionTest.cpp: with b = 4/9 and 7/9, stresses are m / (1 + b (m
// - 1)) of those far away. The error is that of balls of few voxels, of first order; what extrapolation
// leaves is felt from the faces and the other balls.
TEST(ThreeBalls, AreStressedAsEshelbySays) {
  const std::array<Ball, 3> coarse = balls_of(3), fine = balls_of(6);
  const double of_shape = stiffer / (1.0 + 4.0 / 9.0 * 9.0),
               of_size = stiffer / (1.0 + 7.0 / 9.0 * 9.0);
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_EQ(coarse[b].voxels, voxels_of_ball(3));
    EXPECT_EQ(fine[b].voxels, voxels_of_ball(6));
    EXPECT_EQ(fine[b].volume, voxels_of_ball(6));
    EXPECT_NEAR(fine[b].deviatoric / of_shape, 1.0, 0.17);
    EXPECT_NEAR(fine[b].mean / of_size, 1.0, 0.08);
    EXPECT_NEAR((2.0 * fine[b].deviatoric - coarse[b].deviatoric) / of_shape, 1.0, 0.05);
    EXPECT_NEAR((2.0 * fine[b].mean - coarse[b].mean) / of_size, 1.0, 0.05);
  }
}

}  // namespace
}  // namespace stroma::test
