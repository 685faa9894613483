// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Each law of the list, alone and as one of several, against its own energy, and against Hooke's
/// law at tiny strains. Claims V-MAT-1 to V-MAT-7, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "LawChecks.hpp"

namespace stroma::material {
namespace {

using namespace test;
using tensor::contract;
using tensor::identity;
using tensor::inverse;
using tensor::transpose;

const NeoHookean collagen{520.8, 2430.4};

Tensor3 rotation(double angle, int axis) {
  Tensor3 q = identity();
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  q(i, i) = q(j, j) = std::cos(angle);
  q(i, j) = -std::sin(angle);
  q(j, i) = std::sin(angle);
  return q;
}

struct NamedLaw {
  const char* name;
  AnyLaw law;
};

class EachLaw : public ::testing::TestWithParam<NamedLaw> {
 protected:
  const AnyLaw law = GetParam().law;
  const double K = law.small_strain().bulk, mu = law.small_strain().shear;
};
constexpr auto quadratic = VolumetricEnergy::quadratic;
INSTANTIATE_TEST_SUITE_P(
    Laws, EachLaw,
    ::testing::Values(NamedLaw{"NeoHookean", NeoHookean{520.8, 2430.4}},
                      NamedLaw{"NeoHookeanQuadratic", NeoHookean{520.8, 2430.4, quadratic}},
                      NamedLaw{"CoupledNeoHookean", CoupledNeoHookean{520.8, 2083.2}},
                      NamedLaw{"MooneyRivlin", MooneyRivlin{{2430.4}, 200.0, 60.4}},
                      NamedLaw{"MooneyRivlinQuadratic",
                               MooneyRivlin{{2430.4, quadratic}, 500.0, -20.8}},
                      NamedLaw{"OgdenOfOneTerm", Ogden{{2430.4}, 1, {1041.6}, {2.0}}},
                      NamedLaw{"Ogden", Ogden{{2430.4}, 3, {900.0, 150.0, 20.0}, {4.0, -2.0, 7.5}}},
                      NamedLaw{"Yeoh", Yeoh{{2430.4}, 3, {260.4, -30.0, 55.0}}},
                      NamedLaw{"VerondaWestmann", VerondaWestmann{{2430.4}, 100.0, 4.0}},
                      NamedLaw{"HolmesMow", HolmesMow{400.0, 500.0, 0.8}},
                      NamedLaw{"HolmesMowAuxetic", HolmesMow{400.0, -100.0, 1.5}},
                      NamedLaw{"ArrudaBoyce", ArrudaBoyce{{2430.4}, 450.0, 6.5}}),
    [](const auto& instance) { return instance.param.name; });

// V-MAT-1. Central differences are of second order, so halving h must quarter the error. The smallest h
// stays far above eps^(1/3) = 6e-6, where rounding would spoil the order.
TEST_P(EachLaw, StressIsTheDerivativeOfTheEnergy) {
  for (const double h : {1e-2, 5e-3, 2.5e-3})
    EXPECT_NEAR(std::log2(stress_error(law, h) / stress_error(law, h / 2)), 2.0, 0.05)
        << "at h = " << h;
  EXPECT_LT(stress_error(law, 1e-5), 1e-6);
}

// V-MAT-2.
TEST_P(EachLaw, TangentIsTheDerivativeOfTheStress) {
  for (const double h : {1e-2, 5e-3, 2.5e-3})
    EXPECT_NEAR(std::log2(tangent_error(law, h) / tangent_error(law, h / 2)), 2.0, 0.05)
        << "at h = " << h;
  EXPECT_LT(tangent_error(law, 1e-5), 1e-5);
}

TEST_P(EachLaw, TangentIsTheDerivativeInEachDirection) {
  const Tensor3 F = identity() + H;
  const double h = 1e-5;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Tensor3 one;
      one(i, j) = 1.0;
      const Tensor3 dF = one * F;
      const Tensor3 slope = (0.5 / h) * (piola(law, H + h * dF) - piola(law, H - h * dF));
      const Tensor3 exact = product(tangent(law, H).in_full(), one) * transpose(inverse(F));
      EXPECT_LT(norm(slope - exact), 1e-8 * norm(exact)) << "direction " << i << j;
    }
}

TEST_P(EachLaw, TangentHasMajorSymmetry) {
  const Tensor4 a = tangent(law, H).in_full();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) EXPECT_NEAR(a(i, j, k, l), a(k, l, i, j), 1e-12 * K);
}

TEST_P(EachLaw, StressOfBothFunctionsIsTheSame) {
  const Tensor3 tau = tangent(law, H).tau;
  EXPECT_LT(norm(tau - kirchhoff_stress(law, H)), 1e-12 * norm(tau));
  const double j = tensor::det(identity() + H);
  EXPECT_LT(norm(tau - j * cauchy_stress(law, H)), 1e-12 * norm(tau));
}

// V-MAT-3.
TEST_P(EachLaw, RotatingTheSpecimenRotatesTheStress) {
  const Tensor3 Q = rotation(0.7, 0) * rotation(-2.1, 1) * rotation(1.3, 2);
  const Tensor3 F = identity() + H;
  const Tensor3 rotated = Q * F - identity();
  EXPECT_NEAR(energy(law, rotated), energy(law, H), 1e-13 * K);
  const Tensor3 tau = kirchhoff_stress(law, H);
  EXPECT_LT(norm(kirchhoff_stress(law, rotated) - Q * tau * transpose(Q)), 1e-13 * norm(tau) * 10);
  // Rotating before the stretch does nothing: the law is isotropic.
  EXPECT_LT(norm(kirchhoff_stress(law, F * Q - identity()) - tau), 1e-13 * norm(tau) * 10);
}

// V-MAT-4.
// Hooke's law, with strains of 1e-12 in every entry. The next order of the expansion is smaller by
// a factor of the strain; forming J - 1 from F would lose all but 4 digits, and the energy, of
// second order, all of them.
TEST_P(EachLaw, TinyStrainsKeepTheirDigits) {
  for (const double scale : {1e-12, 1e-10, 1e-8}) {
    const Tensor3 small = scale * D;
    const Tensor3 strain = 0.5 * (small + transpose(small));
    const Tensor3 deviator = tensor::deviator(strain);
    const double volume = tensor::trace(strain);
    const Tensor3 stress = 2.0 * mu * deviator + (K * volume) * identity();
    const double expected = mu * contract(deviator, deviator) + 0.5 * K * volume * volume;
    const double relative = std::max(10.0 * scale, 1e-14);
    EXPECT_LT(norm(kirchhoff_stress(law, small) - stress), relative * norm(stress)) << scale;
    EXPECT_LT(norm(cauchy_stress(law, small) - stress), relative * norm(stress)) << scale;
    EXPECT_NEAR(energy(law, small), expected, relative * expected) << scale;
  }
  EXPECT_EQ(energy(law, Tensor3{}), 0.0);
  EXPECT_EQ(norm(kirchhoff_stress(law, Tensor3{})), 0.0);
}

// V-MAT-5.
TEST_P(EachLaw, AnInvertedParticleIsNotFinite) {
  const Tensor3 flat{{{0, 0, 0}, {0, -1, 0}, {0, 0, 0}}};
  const Tensor3 inside_out{{{0, 0, 0}, {0, -2.5, 0}, {0, 0, 0}}};
  for (const Tensor3& at : {flat, inside_out}) {
    EXPECT_FALSE(std::isfinite(energy(law, at)));
    const Tensor3 tau = kirchhoff_stress(law, at);
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(std::isfinite(tau(i, i)));
  }
}

// V-MAT-7. Its own path through the kernels and that of bodies of several laws, which a compiler may round
// in its own way.
TEST(NeoHookean, AloneAndAsOneOfSeveralIsTheSame) {
  const AnyLaw any = collagen;
  EXPECT_NEAR(energy(any, H), energy(collagen, H), 1e-15 * 2430.4);
  EXPECT_LT(norm(kirchhoff_stress(any, H) - kirchhoff_stress(collagen, H)), 1e-15 * 2430.4);
  const Tensor4 a = tangent(any, H).in_full(), b = tangent(collagen, H).in_full();
  for (int i = 0; i < 81; ++i)
    EXPECT_NEAR(a(i / 27, i / 9 % 3, i / 3 % 3, i % 3), b(i / 27, i / 9 % 3, i / 3 % 3, i % 3),
                1e-15 * 2430.4);
}

TEST(MooneyRivlin, WithoutItsSecondModulusIsNeoHookean) {
  const MooneyRivlin law{{2430.4}, 260.4, 0.0};
  EXPECT_NEAR(energy(law, H), energy(collagen, H), 1e-13 * 2430.4);
  EXPECT_LT(norm(kirchhoff_stress(law, H) - kirchhoff_stress(collagen, H)), 1e-13 * 2430.4);
}

// Simple shear g: Ibar1 = Ibar2 = 3 + g^2, so that shear stress and energy are those of mu =
// 2 (C1 + C2), but the normal stresses are not: sigma_xx - sigma_zz = 2 C1 g^2 and
// sigma_yy - sigma_zz = -2 C2 g^2.
TEST(MooneyRivlin, SimpleShearHasTheAnalyticStress) {
  const double g = 0.4, c1 = 200.0, c2 = 60.4;
  const MooneyRivlin law{{2430.4}, c1, c2};
  Tensor3 shear;
  shear(0, 1) = g;
  const Tensor3 sigma = cauchy_stress(law, shear);
  EXPECT_NEAR(sigma(0, 1), 2.0 * (c1 + c2) * g, 1e-12 * c1);
  EXPECT_NEAR(sigma(0, 0) - sigma(2, 2), 2.0 * c1 * g * g, 1e-12 * c1);
  EXPECT_NEAR(sigma(1, 1) - sigma(2, 2), -2.0 * c2 * g * g, 1e-12 * c1);
  EXPECT_NEAR(energy(law, shear), (c1 + c2) * g * g, 1e-12 * c1);
}

// Triaxial stretch by the formula of the energy, in long double.
TEST(CoupledNeoHookean, StretchHasTheAnalyticStressAndEnergy) {
  const long double mu = 520.8L, lambda = 2083.2L, l[3] = {1.3L, 0.9L, 0.8L};
  const CoupledNeoHookean law{520.8, 2083.2};
  Tensor3 stretch;
  long double J = 1.0L, trace = 0.0L;
  for (int d = 0; d < 3; ++d) {
    stretch(d, d) = static_cast<double>(l[d] - 1.0L);
    J *= l[d];
    trace += l[d] * l[d];
  }
  const long double log_j = std::log(J);
  EXPECT_NEAR(energy(law, stretch),
              static_cast<double>(mu / 2 * (trace - 3) - mu * log_j + lambda / 2 * log_j * log_j),
              1e-12 * 520.8);
  const Tensor3 tau = kirchhoff_stress(law, stretch);
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR(tau(d, d), static_cast<double>(mu * (l[d] * l[d] - 1) + lambda * log_j),
                1e-12 * 520.8);
}

// Simple shear of 0.2: sigma_xy = mu g, and the normal stresses of the isochoric law
// (tests/data/reference, case E).
TEST(NeoHookean, SimpleShearHasTheAnalyticStress) {
  const double g = 0.2, mu = collagen.shear_modulus;
  Tensor3 shear;
  shear(0, 1) = g;
  const Tensor3 sigma = cauchy_stress(collagen, shear);
  EXPECT_NEAR(sigma(0, 1), mu * g, 1e-12 * mu);
  EXPECT_NEAR(sigma(0, 0), 2.0 / 3.0 * mu * g * g, 1e-12 * mu);
  EXPECT_NEAR(sigma(1, 1), -mu * g * g / 3.0, 1e-12 * mu);
  EXPECT_NEAR(energy(collagen, shear), 0.5 * mu * g * g, 1e-12 * mu);
}

// Confined compression to 80 %.
TEST(NeoHookean, ConfinedCompressionHasTheAnalyticStress) {
  const double l = 0.8, mu = collagen.shear_modulus, k = collagen.bulk_modulus;
  Tensor3 squeezed;
  squeezed(1, 1) = l - 1.0;
  const Tensor3 sigma = cauchy_stress(collagen, squeezed);
  EXPECT_NEAR(sigma(1, 1),
              2.0 / 3.0 * mu * std::pow(l, -5.0 / 3.0) * (l * l - 1) + k * std::log(l) / l,
              1e-12 * k);
  EXPECT_NEAR(sigma(0, 0),
              1.0 / 3.0 * mu * std::pow(l, -5.0 / 3.0) * (1 - l * l) + k * std::log(l) / l,
              1e-12 * k);
}

// V-MAT-6. The quadratic energy by its own formula in long double, from large strains to small ones; the
// pressure and modulus that go with it.
TEST(NeoHookean, TheQuadraticEnergyOfVolumeIsItsFormula) {
  const NeoHookean law{520.8, 2430.4, VolumetricEnergy::quadratic};
  for (const double j : {-0.6, -0.1, 1e-3, 0.1, 2.0}) {
    const long double J = 1.0L + j, K = law.bulk_modulus;
    const auto energy = static_cast<double>(K / 4 * (J * J - 1 - 2 * std::log(J)));
    const double log_j = std::log1p(j);
    EXPECT_NEAR(law.energy_of_volume(log_j), energy, 1e-13 * energy) << j;
    const VolumetricStress stress = law.stress_of_volume(log_j);
    const auto pressure = static_cast<double>(K / 2 * (J * J - 1));
    EXPECT_NEAR(stress.pressure, pressure, 1e-14 * std::abs(pressure)) << j;
    EXPECT_NEAR(stress.modulus, static_cast<double>(K * J * J), 1e-14 * stress.modulus) << j;
  }
}

}  // namespace
}  // namespace stroma::material
