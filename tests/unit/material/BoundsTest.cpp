// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Bounds of a mixture: figures by hand, the textbooks' two-phase forms, limits and order. Claim
/// V-BOUNDS, docs/verification.md.

#include <gtest/gtest.h>

#include "stroma/material/Bounds.hpp"

namespace stroma::material {
namespace {

using Mixture = MixtureBounds (*)(const std::vector<Phase>&);
const Mixture both_dimensions[] = {bounds_in_space, bounds_in_plane_strain};

const std::vector<Bounds MixtureBounds::*> moduli{&MixtureBounds::shear, &MixtureBounds::bulk,
                                                  &MixtureBounds::young};

void expect_all(const Bounds& bounds, double modulus) {
  for (const double bound : {bounds.reuss, bounds.lower, bounds.upper, bounds.voigt})
    EXPECT_NEAR(bound, modulus, 1e-14 * modulus);
}

void expect_order(const MixtureBounds& bounds) {
  for (const auto modulus : moduli) {
    const Bounds& b = bounds.*modulus;
    const double rounding = 1e-14 * b.voigt;
    EXPECT_LE(b.reuss, b.lower + rounding);
    EXPECT_LE(b.lower, b.upper + rounding);
    EXPECT_LE(b.upper, b.voigt + rounding);
  }
}

// K = 1 and 3, mu = 3/4 and 3/2, half and half, in space: 4/3 mu = 1 and 2, y = 3/4 and 13/8.
TEST(Bounds, AreThoseComputedByHandInSpace) {
  const MixtureBounds bounds = bounds_in_space({{1.0, {0.75, 1.0}}, {1.0, {1.5, 3.0}}});
  EXPECT_NEAR(bounds.bulk.reuss, 1.5, 1e-14);
  EXPECT_NEAR(bounds.bulk.lower, 5.0 / 3.0, 1e-14);
  EXPECT_NEAR(bounds.bulk.upper, 1.75, 1e-14);
  EXPECT_NEAR(bounds.bulk.voigt, 2.0, 1e-14);
  EXPECT_NEAR(bounds.shear.reuss, 1.0, 1e-14);
  EXPECT_NEAR(bounds.shear.lower, 1.05, 1e-14);
  EXPECT_NEAR(bounds.shear.upper, 189.0 / 176.0, 1e-14);
  EXPECT_NEAR(bounds.shear.voigt, 1.125, 1e-14);
  EXPECT_NEAR(bounds.young.reuss, 27.0 / 11.0, 1e-14);  // 9 K mu / (3 K + mu)
  EXPECT_NEAR(bounds.young.voigt, 9.0 * 2.0 * 1.125 / 7.125, 1e-14);
}

// k = 1 and 3, mu = 1 and 2, half and half, in plane strain: y = 1/3 and 6/7.
TEST(Bounds, AreThoseComputedByHandInPlaneStrain) {
  const MixtureBounds bounds =
      bounds_in_plane_strain({{0.5, {1.0, 2.0 / 3.0}}, {0.5, {2.0, 7.0 / 3.0}}});
  EXPECT_NEAR(bounds.bulk.lower, 5.0 / 3.0, 1e-14);
  EXPECT_NEAR(bounds.bulk.upper, 1.75, 1e-14);
  EXPECT_NEAR(bounds.shear.lower, 15.0 / 11.0, 1e-14);
  EXPECT_NEAR(bounds.shear.upper, 46.0 / 33.0, 1e-14);
  EXPECT_NEAR(bounds.young.reuss, 4.0 * 1.5 * (4.0 / 3.0) / (1.5 + 4.0 / 3.0), 1e-14);
  EXPECT_NEAR(bounds.young.voigt, 4.0 * 2.0 * 1.5 / 3.5, 1e-14);
}

// The textbooks' form for two phases, the first one softer in both moduli (Hashin & Shtrikman 1963,
// equations 4.1 to 4.4; Hashin 1965).
TEST(Bounds, AreTheTextbooksOfTwoPhases) {
  const double K1 = 1041.6, mu1 = 520.8, K2 = 9000.0, mu2 = 2500.0;
  for (const double f2 : {0.05, 0.193634, 0.5, 0.9}) {
    const double f1 = 1.0 - f2;
    const MixtureBounds in_space = bounds_in_space({{f1, {mu1, K1}}, {f2, {mu2, K2}}});
    const auto bulk = [](double K, double mu, double Ko, double f, double fo) {
      return K + fo / (1.0 / (Ko - K) + 3.0 * f / (3.0 * K + 4.0 * mu));
    };
    const auto shear = [](double K, double mu, double muo, double f, double fo) {
      return mu +
             fo / (1.0 / (muo - mu) + 6.0 * f * (K + 2.0 * mu) / (5.0 * mu * (3.0 * K + 4.0 * mu)));
    };
    EXPECT_NEAR(in_space.bulk.lower, bulk(K1, mu1, K2, f1, f2), 1e-10);
    EXPECT_NEAR(in_space.bulk.upper, bulk(K2, mu2, K1, f2, f1), 1e-10);
    EXPECT_NEAR(in_space.shear.lower, shear(K1, mu1, mu2, f1, f2), 1e-10);
    EXPECT_NEAR(in_space.shear.upper, shear(K2, mu2, mu1, f2, f1), 1e-10);

    const double k1 = K1 + mu1 / 3.0, k2 = K2 + mu2 / 3.0;
    const MixtureBounds flat = bounds_in_plane_strain({{f1, {mu1, K1}}, {f2, {mu2, K2}}});
    const auto plane_bulk = [](double k, double mu, double ko, double f, double fo) {
      return k + fo / (1.0 / (ko - k) + f / (k + mu));
    };
    const auto plane_shear = [](double k, double mu, double muo, double f, double fo) {
      return mu + fo / (1.0 / (muo - mu) + f * (k + 2.0 * mu) / (2.0 * mu * (k + mu)));
    };
    EXPECT_NEAR(flat.bulk.lower, plane_bulk(k1, mu1, k2, f1, f2), 1e-10);
    EXPECT_NEAR(flat.bulk.upper, plane_bulk(k2, mu2, k1, f2, f1), 1e-10);
    EXPECT_NEAR(flat.shear.lower, plane_shear(k1, mu1, mu2, f1, f2), 1e-10);
    EXPECT_NEAR(flat.shear.upper, plane_shear(k2, mu2, mu1, f2, f1), 1e-10);
  }
}

// The paper's slice: vessels twice as stiff in both moduli, 19.3634 % of the area.
TEST(Bounds, OfThePapersSlice) {
  const double f = 0.193634;
  const SmallStrainModuli collagen{520.8, 1041.6}, vessel{1041.6, 2083.2};
  const double k = 1041.6 + 520.8 / 3.0;
  const double one = 4.0 * k * 520.8 / (k + 520.8);  // E' of collagen
  const Bounds stiffness = bounds_in_plane_strain({{1.0 - f, collagen}, {f, vessel}}).young;
  EXPECT_NEAR(stiffness.reuss / one - 1.0, 1.0 / (1.0 - f / 2.0) - 1.0, 1e-14);
  EXPECT_NEAR(stiffness.reuss / one - 1.0, 0.1072, 5e-5);
  EXPECT_NEAR(stiffness.voigt / one - 1.0, f, 1e-14);
  EXPECT_GT(stiffness.lower, stiffness.reuss * 1.01);
  EXPECT_LT(stiffness.upper, stiffness.voigt * 0.99);
}

TEST(Bounds, OfOneMaterialAreItsModuli) {
  const SmallStrainModuli gel{500.0, 7000.0};
  for (const auto& phases : {std::vector<Phase>{{3.0, gel}},
                             {{1.0, gel}, {0.0, {5.0, 1e6}}},
                             {{0.3, gel}, {0.7, gel}}}) {
    const MixtureBounds in_space = bounds_in_space(phases), flat = bounds_in_plane_strain(phases);
    expect_all(in_space.shear, 500.0);
    expect_all(in_space.bulk, 7000.0);
    expect_all(in_space.young, 9.0 * 7000.0 * 500.0 / 21500.0);
    expect_all(flat.shear, 500.0);
    expect_all(flat.bulk, 7000.0 + 500.0 / 3.0);
    const double nu = (3.0 * 7000.0 - 1000.0) / (6.0 * 7000.0 + 1000.0);
    expect_all(flat.young, 9.0 * 7000.0 * 500.0 / 21500.0 / (1.0 - nu * nu));  // E / (1 - nu^2)
  }
}

// Hill 1963: where all shear moduli are equal, the bulk modulus is known exactly.
TEST(Bounds, MeetWhereShearModuliAreEqual) {
  for (const Mixture bounds_of : both_dimensions) {
    const Bounds bulk = bounds_of({{0.2, {800.0, 1000.0}}, {0.8, {800.0, 50000.0}}}).bulk;
    EXPECT_NEAR(bulk.lower, bulk.upper, 1e-14 * bulk.upper);
    EXPECT_LT(bulk.reuss, 0.9 * bulk.lower);
    EXPECT_GT(bulk.voigt, 1.1 * bulk.upper);
  }
}

TEST(Bounds, KeepTheirOrder) {
  const double pairs[][4] = {{520.8, 1041.6, 1041.6, 2083.2},  // both moduli doubled
                             {520.8, 1041.6, 5208.0, 1041.6},  // only one
                             {520.8, 2000.0, 5208.0, 900.0},   // not well-ordered
                             {1.0, 1e4, 1e6, 1e6}};            // extreme
  for (const auto& [mu1, K1, mu2, K2] : pairs) {
    for (int i = 0; i <= 20; ++i) {
      const double f = i / 20.0;
      for (const Mixture bounds_of : both_dimensions) {
        expect_order(bounds_of({{1.0 - f, {mu1, K1}}, {f, {mu2, K2}}}));
        expect_order(bounds_of({{1.0 - f, {mu1, K1}}, {f, {mu2, K2}}, {0.3, {77.0, 3000.0}}}));
      }
    }
  }
}

// A phase may be cut in two, and shares may be volumes in any unit.
TEST(Bounds, DoNotDependOnHowThePhasesAreListed) {
  const SmallStrainModuli soft{520.8, 1041.6}, stiff{1041.6, 9000.0}, third{77.0, 3000.0};
  for (const Mixture bounds_of : both_dimensions) {
    const MixtureBounds one = bounds_of({{0.5, soft}, {0.3, stiff}, {0.2, third}});
    const MixtureBounds other =
        bounds_of({{20.0, third}, {10.0, stiff}, {50.0, soft}, {20.0, stiff}});
    for (const auto modulus : moduli) {
      const Bounds &a = one.*modulus, &b = other.*modulus;
      EXPECT_NEAR(a.reuss, b.reuss, 1e-13 * a.reuss);
      EXPECT_NEAR(a.lower, b.lower, 1e-13 * a.lower);
      EXPECT_NEAR(a.upper, b.upper, 1e-13 * a.upper);
      EXPECT_NEAR(a.voigt, b.voigt, 1e-13 * a.voigt);
    }
  }
}

}  // namespace
}  // namespace stroma::material
