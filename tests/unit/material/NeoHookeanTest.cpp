// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The neo-Hookean law, with either energy of volume, against its own energy, and against Hooke's
/// law at tiny strains. Claims V-MAT-1 to V-MAT-6, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "stroma/material/Material.hpp"
#include "stroma/material/NeoHookean.hpp"

namespace stroma::material {
namespace {

using tensor::contract;
using tensor::identity;
using tensor::inverse;
using tensor::transpose;

const NeoHookean collagen{520.8, 2430.4};

// Stretch, shear and rotation at once, and a direction that moves all nine entries.
const Tensor3 H{{{0.10, 0.30, -0.05}, {-0.20, 0.05, 0.15}, {0.08, -0.12, 0.02}}};
const Tensor3 D{{{0.7, -0.4, 0.2}, {0.5, 0.3, -0.6}, {-0.1, 0.8, 0.9}}};

double norm(const Tensor3& a) { return std::sqrt(contract(a, a)); }

Tensor3 rotation(double angle, int axis) {
  Tensor3 q = identity();
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  q(i, i) = q(j, j) = std::cos(angle);
  q(i, j) = -std::sin(angle);
  q(j, i) = std::sin(angle);
  return q;
}

/// Both energies of volume.
class NeoHookeanLaw : public ::testing::TestWithParam<VolumetricEnergy> {
 protected:
  const NeoHookean law{520.8, 2430.4, GetParam()};

  /// a : D, by the law's tangent at H.
  Tensor3 tangent_times(const Tensor3& at, const Tensor3& direction) const {
    const Tensor4 a = law.isotropic_tangent(at).in_full();
    Tensor3 product;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l) product(i, j) += a(i, j, k, l) * direction(k, l);
    return product;
  }

  /// First Piola-Kirchhoff stress tau F^-T.
  Tensor3 piola(const Tensor3& at) const {
    return law.kirchhoff_stress(at) * transpose(inverse(identity() + at));
  }

  /// | dW/dh by central differences - tau : (D F^-1) |  [Pa]
  double stress_error(double h) const {
    const double slope = (law.energy(H + h * D) - law.energy(H - h * D)) / (2.0 * h);
    const Tensor3 F = identity() + H;
    return std::abs(slope - contract(law.kirchhoff_stress(H), D * inverse(F)));
  }

  /// || d(tau F^-T)/dh by central differences, dF = D F, - (a : D) F^-T ||  [Pa]
  double tangent_error(double h) const {
    const Tensor3 F = identity() + H;
    const Tensor3 dF = D * F;
    const Tensor3 slope = (0.5 / h) * (piola(H + h * dF) - piola(H - h * dF));
    return norm(slope - tangent_times(H, D) * transpose(inverse(F)));
  }
};
INSTANTIATE_TEST_SUITE_P(EnergiesOfVolume, NeoHookeanLaw,
                         ::testing::Values(VolumetricEnergy::logarithmic,
                                           VolumetricEnergy::quadratic),
                         [](const auto& energy) {
                           return energy.param == VolumetricEnergy::quadratic ? "quadratic"
                                                                              : "logarithmic";
                         });

// Central differences are of second order, so halving h must quarter the error. The smallest h
// stays far above eps^(1/3) = 6e-6, where rounding would spoil the order.
TEST_P(NeoHookeanLaw, StressIsTheDerivativeOfTheEnergy) {
  for (const double h : {1e-2, 5e-3, 2.5e-3})
    EXPECT_NEAR(std::log2(stress_error(h) / stress_error(h / 2)), 2.0, 0.05) << "at h = " << h;
  EXPECT_LT(stress_error(1e-5), 1e-6);
}

// V-MAT-2.
TEST_P(NeoHookeanLaw, TangentIsTheDerivativeOfTheStress) {
  for (const double h : {1e-2, 5e-3, 2.5e-3})
    EXPECT_NEAR(std::log2(tangent_error(h) / tangent_error(h / 2)), 2.0, 0.05) << "at h = " << h;
  EXPECT_LT(tangent_error(1e-5), 1e-5);
}

TEST_P(NeoHookeanLaw, TangentIsTheDerivativeInEachDirection) {
  const Tensor3 F = identity() + H;
  const double h = 1e-5;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Tensor3 one;
      one(i, j) = 1.0;
      const Tensor3 dF = one * F;
      const Tensor3 slope = (0.5 / h) * (piola(H + h * dF) - piola(H - h * dF));
      const Tensor3 exact = tangent_times(H, one) * transpose(inverse(F));
      EXPECT_LT(norm(slope - exact), 1e-8 * norm(exact)) << "direction " << i << j;
    }
}

TEST_P(NeoHookeanLaw, TangentHasMajorSymmetry) {
  const Tensor4 a = law.isotropic_tangent(H).in_full();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          EXPECT_NEAR(a(i, j, k, l), a(k, l, i, j), 1e-12 * law.bulk_modulus);
}

TEST_P(NeoHookeanLaw, StressOfBothFunctionsIsTheSame) {
  const Tensor3 tau = law.isotropic_tangent(H).tau;
  EXPECT_LT(norm(tau - law.kirchhoff_stress(H)), 1e-12 * norm(tau));
  const double j = tensor::det(identity() + H);
  EXPECT_LT(norm(tau - j * law.cauchy_stress(H)), 1e-12 * norm(tau));
}

// V-MAT-3.
TEST_P(NeoHookeanLaw, RotatingTheSpecimenRotatesTheStress) {
  const Tensor3 Q = rotation(0.7, 0) * rotation(-2.1, 1) * rotation(1.3, 2);
  const Tensor3 F = identity() + H;
  const Tensor3 rotated = Q * F - identity();
  EXPECT_NEAR(law.energy(rotated), law.energy(H), 1e-13 * law.bulk_modulus);
  const Tensor3 tau = law.kirchhoff_stress(H);
  EXPECT_LT(norm(law.kirchhoff_stress(rotated) - Q * tau * transpose(Q)), 1e-13 * norm(tau) * 10);
  // Rotating before the stretch does nothing: the law is isotropic.
  EXPECT_LT(norm(law.kirchhoff_stress(F * Q - identity()) - tau), 1e-13 * norm(tau) * 10);
}

// V-MAT-4.
// Hooke's law, with strains of 1e-12 in every entry. The next order of the expansion is smaller by
// a factor of the strain; forming J - 1 from F would lose all but 4 digits, and the energy, of
// second order, all of them.
TEST_P(NeoHookeanLaw, TinyStrainsKeepTheirDigits) {
  for (const double scale : {1e-12, 1e-10, 1e-8}) {
    const Tensor3 small = scale * D;
    const Tensor3 strain = 0.5 * (small + transpose(small));
    const Tensor3 deviator = tensor::deviator(strain);
    const double volume = tensor::trace(strain);
    const Tensor3 stress =
        2.0 * law.shear_modulus * deviator + (law.bulk_modulus * volume) * identity();
    const double energy =
        law.shear_modulus * contract(deviator, deviator) + 0.5 * law.bulk_modulus * volume * volume;
    const double relative = std::max(10.0 * scale, 1e-14);
    EXPECT_LT(norm(law.kirchhoff_stress(small) - stress), relative * norm(stress)) << scale;
    EXPECT_LT(norm(law.cauchy_stress(small) - stress), relative * norm(stress)) << scale;
    EXPECT_NEAR(law.energy(small), energy, relative * energy) << scale;
  }
  EXPECT_EQ(law.energy(Tensor3{}), 0.0);
  EXPECT_EQ(norm(law.kirchhoff_stress(Tensor3{})), 0.0);
}

// V-MAT-5.
TEST_P(NeoHookeanLaw, AnInvertedParticleIsNotFinite) {
  const Tensor3 flat{{{0, 0, 0}, {0, -1, 0}, {0, 0, 0}}};
  const Tensor3 inside_out{{{0, 0, 0}, {0, -2.5, 0}, {0, 0, 0}}};
  for (const Tensor3& at : {flat, inside_out}) {
    EXPECT_FALSE(std::isfinite(law.energy(at)));
    const Tensor3 tau = law.kirchhoff_stress(at);
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(std::isfinite(tau(i, i)));
  }
}

// Simple shear of 0.2: sigma_xy = mu g, and the normal stresses of the isochoric law
// (tests/data/reference, case E).
TEST(NeoHookean, SimpleShearHasTheAnalyticStress) {
  const double g = 0.2, mu = collagen.shear_modulus;
  Tensor3 shear;
  shear(0, 1) = g;
  const Tensor3 sigma = collagen.cauchy_stress(shear);
  EXPECT_NEAR(sigma(0, 1), mu * g, 1e-12 * mu);
  EXPECT_NEAR(sigma(0, 0), 2.0 / 3.0 * mu * g * g, 1e-12 * mu);
  EXPECT_NEAR(sigma(1, 1), -mu * g * g / 3.0, 1e-12 * mu);
  EXPECT_NEAR(collagen.energy(shear), 0.5 * mu * g * g, 1e-12 * mu);
}

// Confined compression to 80 %.
TEST(NeoHookean, ConfinedCompressionHasTheAnalyticStress) {
  const double l = 0.8, mu = collagen.shear_modulus, k = collagen.bulk_modulus;
  Tensor3 squeezed;
  squeezed(1, 1) = l - 1.0;
  const Tensor3 sigma = collagen.cauchy_stress(squeezed);
  EXPECT_NEAR(sigma(1, 1),
              2.0 / 3.0 * mu * std::pow(l, -5.0 / 3.0) * (l * l - 1) + k * std::log(l) / l,
              1e-12 * k);
  EXPECT_NEAR(sigma(0, 0),
              1.0 / 3.0 * mu * std::pow(l, -5.0 / 3.0) * (1 - l * l) + k * std::log(l) / l,
              1e-12 * k);
}

// The quadratic energy by its own formula in long double, from large strains to small ones; the
// pressure and modulus that go with it.
TEST(NeoHookean, TheQuadraticEnergyOfVolumeIsItsFormula) {
  const NeoHookean law{520.8, 2430.4, VolumetricEnergy::quadratic};
  for (const double j : {-0.6, -0.1, 1e-3, 0.1, 2.0}) {
    const long double J = 1.0L + j, K = law.bulk_modulus;
    const auto energy = static_cast<double>(K / 4 * (J * J - 1 - 2 * std::log(J)));
    const double log_j = std::log1p(j);
    EXPECT_NEAR(law.energy_of_volume(log_j), energy, 1e-13 * energy) << j;
    const VolumetricStress stress = law.volumetric_stress(log_j);
    const auto pressure = static_cast<double>(K / 2 * (J * J - 1));
    EXPECT_NEAR(stress.pressure, pressure, 1e-14 * std::abs(pressure)) << j;
    EXPECT_NEAR(stress.modulus, static_cast<double>(K * J * J), 1e-14 * stress.modulus) << j;
  }
}

}  // namespace
}  // namespace stroma::material
