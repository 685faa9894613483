// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Laws of fibres, their directions, and matrices with fibres in them. Claims V-FIBER-1 to
/// V-FIBER-4, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "LawChecks.hpp"

namespace stroma::material {
namespace {

using namespace test;
using tensor::identity;
using tensor::transpose;

// Collagen fibres of AngioFE's gel, of a tendon, and of a cell-traction laboratory.
const ExponentialPower squares{300.0, 2.0, 2.0}, powers{800.0, 0.0, 3.0}, angio{250.0, 1.5, 2.5};
const ExponentialLinear tendon{120.0, 45.0, 30000.0, 1.06};
const BucklingStiffening collagen{1449.0, 0.0022, 0.032, 0.055};

struct NamedFiber {
  const char* name;
  AnyFiberLaw law;
  double slack;  ///< energy of a fibre shortened to half [Pa]
};

struct FiberResponse {
  double energy, slope, curvature;
};
template <class Law>
FiberResponse response(const Law& law, double x) {
  const FiberSlopes psi = law.slopes(x);
  return {law.energy(x), psi.first, psi.second};
}

class FiberLaws : public ::testing::TestWithParam<NamedFiber> {
 protected:
  FiberResponse at(double x) const {
    return GetParam().law.visit([=](const auto& law) { return response(law, x); });
  }
};
INSTANTIATE_TEST_SUITE_P(
    Fibers, FiberLaws,
    ::testing::Values(NamedFiber{"Squares", squares, 0.0}, NamedFiber{"Powers", powers, 0.0},
                      NamedFiber{"Angio", angio, 0.0}, NamedFiber{"Tendon", tendon, 0.0},
                      NamedFiber{"Collagen", collagen, 1449.0 * 0.0022 * (0.5 - 0.0022)}),
    [](const auto& instance) { return instance.param.name; });

// V-FIBER-1. Between kinks, central differences of second order.
TEST_P(FiberLaws, SlopesAreDerivatives) {
  for (const double x : {0.005, 0.05, 0.2, 0.5}) {
    const auto error = [&](double h, double FiberResponse::*value, double FiberResponse::*slope) {
      const double found = ((at(x + h).*value) - (at(x - h).*value)) / (2.0 * h);
      return std::abs(found - at(x).*slope) / std::abs(at(x).*slope);
    };
    const double h = 1e-4;
    EXPECT_LT(error(h, &FiberResponse::energy, &FiberResponse::slope), 2e-3) << x;
    EXPECT_LT(error(h / 10, &FiberResponse::energy, &FiberResponse::slope), 2e-5) << x;
    EXPECT_LT(error(h, &FiberResponse::slope, &FiberResponse::curvature), 2e-3) << x;
    EXPECT_LT(error(h / 10, &FiberResponse::slope, &FiberResponse::curvature), 2e-5) << x;
  }
}

TEST_P(FiberLaws, AtRestHasNeitherEnergyNorForce) {
  EXPECT_EQ(at(0.0).energy, 0.0);
  EXPECT_EQ(at(0.0).slope, 0.0);
}

TEST_P(FiberLaws, ResistsCompressionAsItSays) {
  const double slack = GetParam().slack;
  EXPECT_NEAR(at(-0.75).energy, slack, 1e-10 * slack);  // lambda = 1/2
}

TEST(ExponentialLinear, IsContinuousWhereFibresAreStraight) {
  const double x = 1.06 * 1.06 - 1.0, h = 1e-12;
  EXPECT_NEAR(response(tendon, x - h).slope, response(tendon, x + h).slope,
              1e-8 * response(tendon, x).slope);
  EXPECT_NEAR(response(tendon, x - h).energy, response(tendon, x + h).energy,
              1e-9 * response(tendon, x).energy);
  // Beyond, dpsi/dl = C5 + C6 / l.
  const double l = 1.2, c6 = 120.0 * std::expm1(45.0 * 0.06) - 30000.0 * 1.06;
  EXPECT_NEAR(2.0 * l * response(tendon, l * l - 1.0).slope, 30000.0 + c6 / l, 1e-10 * 30000.0);
}

// w' of its three branches.
TEST(BucklingStiffening, HasTheForceOfItsBranches) {
  const auto force = [](double s) {
    return 2.0 * (1.0 + s) * response(collagen, s * (2.0 + s)).slope;
  };
  EXPECT_NEAR(force(-0.1), 1449.0 * 0.0022 * std::expm1(-0.1 / 0.0022), 1e-12 * 1449.0);
  EXPECT_NEAR(force(0.02), 1449.0 * 0.02, 1e-12 * 1449.0);
  EXPECT_NEAR(force(0.15), 1449.0 * (0.032 + 0.055 * std::expm1((0.15 - 0.032) / 0.055)),
              1e-10 * 1449.0);
}

/// Mean of f over a family's directions.
double mean(const DistributionParameters& p, const std::function<double(const double*)>& f) {
  double sum = 0.0;
  for (const FiberDirection& direction : directions(p)) sum += direction.weight * f(direction.n);
  return sum;
}

DistributionParameters spherical() {
  DistributionParameters p;
  p.distribution = Distribution::spherical;
  return p;
}

// V-FIBER-2. Over the sphere <x^2> = 1/3, <x^4> = 1/5, <x^2 y^2> = 1/15, <x^8> = 1/9.
TEST(Directions, IntegratePolynomialsOverTheSphere) {
  const DistributionParameters p = spherical();
  EXPECT_NEAR(mean(p, [](const double*) { return 1.0; }), 1.0, 1e-14);
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(mean(p, [=](const double* n) { return n[d] * n[d]; }), 1.0 / 3.0, 1e-14);
    EXPECT_NEAR(mean(p, [=](const double* n) { return std::pow(n[d], 4); }), 1.0 / 5.0, 1e-14);
    EXPECT_NEAR(mean(p, [=](const double* n) { return std::pow(n[d], 8); }), 1.0 / 9.0, 1e-14);
  }
  EXPECT_NEAR(mean(p, [](const double* n) { return n[0] * n[0] * n[2] * n[2]; }), 1.0 / 15.0,
              1e-14);
}

TEST(Directions, OfADistributionWithoutPreferenceAreTheSpheres) {
  DistributionParameters axial = spherical(), ellipsoid = spherical();
  axial.distribution = Distribution::axial;
  axial.direction = {1.0, 2.0, -0.5};
  ellipsoid.distribution = Distribution::ellipsoidal;
  ellipsoid.axes = {0.7, 0.7, 0.7};
  for (const auto& p : {axial, ellipsoid})
    EXPECT_NEAR(mean(p, [](const double* n) { return std::pow(n[1], 6); }), 1.0 / 7.0, 1e-14);
}

TEST(Directions, AreThoseOfTheShortestAndTheLongestVector) {
  for (const double length : {5e-324, 1e-200, 1.0, 1e200, 1e308}) {
    EXPECT_EQ(normalised({0.0, 0.0, -length}), (std::array<double, 3>{0.0, 0.0, -1.0}));
    DistributionParameters ellipsoid = spherical();
    ellipsoid.distribution = Distribution::ellipsoidal;
    ellipsoid.axes = {length, length, length};
    EXPECT_NEAR(mean(ellipsoid, [](const double* n) { return std::pow(n[1], 6); }), 1.0 / 7.0,
                1e-14);
  }
}

// With t = N.A, <t^2> = integral of t^2 exp(2 b t^2) / integral of exp(2 b t^2), by Simpson's rule.
TEST(Directions, OfAnAxialFamilyCrowdAroundItsAxis) {
  DistributionParameters p = spherical();
  p.distribution = Distribution::axial;
  p.direction = {3.0, 0.0, 4.0};
  for (const double b : {-2.0, 0.5, 3.0}) {
    p.concentration = b;
    double above = 0.0, below = 0.0;
    const int pieces = 2000;
    for (int k = 0; k <= pieces; ++k) {
      const double t = 1.0 * k / pieces, weight = k == 0 || k == pieces ? 1.0 : 2.0 + 2.0 * (k % 2);
      above += weight * t * t * std::exp(2.0 * b * t * t);
      below += weight * std::exp(2.0 * b * t * t);
    }
    const auto along = [](const double* n) { return std::pow(0.6 * n[0] + 0.8 * n[2], 2); };
    EXPECT_NEAR(mean(p, along), above / below, 1e-8) << b;
  }
}

/// A law with its families and the directions that they point to.
struct Body {
  AnyLaw law;
  std::vector<std::vector<FiberDirection>> kept;

  explicit Body(const AnyLaw& matrix) : law(matrix) { kept.reserve(AnyLaw::most_families); }
  void add(const AnyFiberLaw& fiber, const DistributionParameters& p) {
    kept.push_back(directions(p));
    law.add({fiber, kept.back().data(), static_cast<int>(kept.back().size())});
  }
};

DistributionParameters along(double x, double y, double z) {
  DistributionParameters p;
  p.direction = {x, y, z};
  return p;
}

const CoupledNeoHookean gel{520.8, 700.0};

/// V-FIBER-3, of order 2.
void expect_derivatives(const AnyLaw& law) {
  const Tensor4 a = tangent(law, H).in_full();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) EXPECT_NEAR(a(i, j, k, l), a(k, l, i, j), 1e-11 * 1e3);
  for (const double h : {4e-3, 2e-3}) {
    EXPECT_NEAR(std::log2(stress_error(law, h) / stress_error(law, h / 2)), 2.0, 0.1) << h;
    EXPECT_NEAR(std::log2(tangent_error(law, h) / tangent_error(law, h / 2)), 2.0, 0.1) << h;
  }
  EXPECT_LT(stress_error(law, 1e-5), 1e-5);
  EXPECT_LT(tangent_error(law, 1e-5), 1e-3);
  EXPECT_LT(norm(tangent(law, H).tau - kirchhoff_stress(law, H)),
            1e-12 * norm(tangent(law, H).tau));
}

// Two single families and a spherical one, whose energy has no kinks of second order.
TEST(Fibers, StressAndTangentAreDerivatives) {
  Body body{AnyLaw(gel)};
  body.add(squares, along(1, 3, 1));
  body.add(collagen, along(1, 1, 0));
  body.add(powers, spherical());
  expect_derivatives(body.law);
}

const double third = 1.0 / 3.0;
const HolzapfelGasserOgden dispersed{
    {3000.0}, 400.0, 200.0, 3.0, 0.1, 2, {{third, 2 * third, 2 * third}, {-0.6, 0.8, 0.0}}};

// At H, its first family is stretched, and the second shortened.
TEST(HolzapfelGasserOgden, StressAndTangentAreDerivatives) { expect_derivatives(dispersed); }

// With Kappa = 1/3 directions do not matter: E = (Ibar1 - 3) / 3, an isotropic law.
TEST(HolzapfelGasserOgden, EverywhereAlikeIsIsotropic) {
  HolzapfelGasserOgden law = dispersed;
  law.kappa = third;
  law.families = 1;
  const double x = isochoric_first_invariant_minus_3(H), e = x / 3.0;
  EXPECT_NEAR(
      energy(law, H),
      200.0 * x + 200.0 / 6.0 * std::expm1(3.0 * e * e) + law.energy_of_volume(log_jacobian(H)),
      1e-11 * 400.0);
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Tensor3 Q{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
  const Tensor3 tau = kirchhoff_stress(law, H);
  EXPECT_LT(norm(kirchhoff_stress(law, (identity() + H) * Q - identity()) - tau),
            1e-12 * norm(tau));
}

TEST(Fibers, RotateWithTheSpecimen) {
  Body body{AnyLaw(gel)};
  body.add(squares, along(1, 3, 1));
  body.add(tendon, spherical());
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Tensor3 Q{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}, F = identity() + H;
  const Tensor3 tau = kirchhoff_stress(body.law, H);
  EXPECT_LT(norm(kirchhoff_stress(body.law, Q * F - identity()) - Q * tau * transpose(Q)),
            1e-12 * norm(tau));
}

// A fibre along the stretch l adds 2 psi' l^2 there, and nothing across it.
TEST(Fibers, AlongTheStretchAddTheirForce) {
  Body body{AnyLaw(gel)};
  body.add(angio, along(0, -2, 0));
  Tensor3 stretch;
  stretch(1, 1) = 0.25;
  const Tensor3 added = kirchhoff_stress(body.law, stretch) - kirchhoff_stress(gel, stretch);
  const double x = 1.25 * 1.25 - 1.0;
  const double force = 250.0 * std::pow(x, 1.5) * std::exp(1.5 * std::pow(x, 2.5));
  EXPECT_NEAR(added(1, 1), 2.0 * force * 1.25 * 1.25, 1e-10 * force);
  EXPECT_NEAR(norm(added), added(1, 1), 1e-12 * force);
  stretch(1, 1) = -0.25;  // shortened, it carries nothing
  EXPECT_EQ(norm(kirchhoff_stress(body.law, stretch) - kirchhoff_stress(gel, stretch)), 0.0);
}

// Fibres of modulus E that point everywhere alike: mu = E/15, K = E/9 in small strain.
TEST(Fibers, EverywhereAlikeAreIsotropicAtSmallStrains) {
  Body body{AnyLaw(gel)};
  body.add(collagen, spherical());
  const SmallStrainModuli all = body.law.small_strain(), matrix = gel.small_strain();
  EXPECT_DOUBLE_EQ(all.shear, matrix.shear + 1449.0 / 15.0);
  EXPECT_DOUBLE_EQ(all.bulk, matrix.bulk + 1449.0 / 9.0);
  const Tensor3 small = 1e-12 * D, strain = 0.5 * (small + transpose(small));
  const Tensor3 stress =
      2.0 * all.shear * tensor::deviator(strain) + all.bulk * tensor::trace(strain) * identity();
  EXPECT_LT(norm(kirchhoff_stress(body.law, small) - stress), 1e-8 * norm(stress));
}

// V-FIBER-4. The default quadrature against one of six times as many rings, 20 % uniaxial strain
// along each axis, and shear: fibres that buckle make kinks.
TEST(Fibers, DefaultQuadratureIsGoodToAThousandthOfTheStress) {
  Tensor3 states[4];
  for (int d = 0; d < 3; ++d) {
    for (int e = 0; e < 3; ++e) states[d](e, e) = d == e ? 0.2 : -0.08;
    states[3](0, 1) = 0.2;
  }
  double worst = 0.0;
  for (const AnyFiberLaw& law :
       {AnyFiberLaw(squares), AnyFiberLaw(angio), AnyFiberLaw(tendon), AnyFiberLaw(collagen)})
    for (const Distribution kind : {Distribution::spherical, Distribution::ellipsoidal}) {
      DistributionParameters p = spherical();
      p.distribution = kind;
      p.axes = {1.2991, 1.0, 0.4};
      Body coarse{AnyLaw(gel)}, fine{AnyLaw(gel)};
      coarse.add(law, p);
      p.quadrature = 96;
      fine.add(law, p);
      for (const Tensor3& at : states) {
        const Tensor3 exact = kirchhoff_stress(fine.law, at);
        const double error = norm(kirchhoff_stress(coarse.law, at) - exact) / norm(exact);
        EXPECT_LT(error, 1e-3);
        worst = std::max(worst, error);
      }
    }
  std::printf("  quadrature good to %.1e of the stress\n", worst);
}

}  // namespace
}  // namespace stroma::material
