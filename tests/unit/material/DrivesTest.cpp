// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Active stress and growth: what they are at rest, and the tangents that go with them. Claims
/// V-ACTIVE-1 and V-GROWTH-1, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "LawChecks.hpp"

namespace stroma::material {
namespace {

using namespace test;
using tensor::identity;
using tensor::transpose;

const double N[3] = {1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0};
const FiberDirection fiber{{0.6, 0.0, 0.8}, 1.0};

/// A coupled matrix with fibres and an uncoupled one, by which growth and contraction are tried.
std::vector<AnyLaw> matrices() {
  AnyLaw reinforced = CoupledNeoHookean{520.8, 700.0};
  reinforced.add({ExponentialPower{300.0, 2.0, 3.0}, &fiber, 1});
  return {reinforced, AnyLaw(VerondaWestmann{{2430.4}, 100.0, 4.0})};
}

Growth growing(Growth::Kind kind) {
  Growth growth{2.0, kind, {N[0], N[1], N[2]}};
  return growth;
}

constexpr Growth::Kind growths[] = {Growth::Kind::volume, Growth::Kind::fiber, Growth::Kind::area};
constexpr ActiveStress::Kind actives[] = {ActiveStress::Kind::isotropic, ActiveStress::Kind::fiber,
                                          ActiveStress::Kind::transverse};

/// F_g as it is written.
Tensor3 grown(Growth::Kind kind, double g) {
  const Tensor3 along = tensor::square_of(N), all = identity();
  if (kind == Growth::Kind::volume) return std::cbrt(g) * all;
  if (kind == Growth::Kind::fiber) return all + (g - 1.0) * along;
  return std::sqrt(g) * (all - along) + along;
}

/// Tangent against differences of the stress, and stress against those of the energy.
void expect_derivatives(const AnyLaw& law, bool has_energy) {
  const double h = 1e-5;
  EXPECT_LT(tangent_error(law, h), 1e-8 * norm(stress_slope(law, h)));
  const Tensor3 tau = kirchhoff_stress(law, H);
  EXPECT_LT(norm(tangent(law, H).tau - tau), 1e-12 * norm(tau));
  if (has_energy) {
    EXPECT_LT(stress_error(law, h), 1e-8 * norm(tau));
  }
}

// V-GROWTH-1.
TEST(Growth, StressAndTangentAreDerivatives) {
  for (AnyLaw law : matrices())
    for (const Growth::Kind kind : growths) {
      law.set_growth(growing(kind));
      law.drive({0.0, 0.7});
      expect_derivatives(law, true);
    }
}

TEST(Growth, OfAFreeBodyIsFreeOfStress) {
  for (AnyLaw law : matrices())
    for (const Growth::Kind kind : growths)
      for (const double factor : {1e-9, 0.3, 1.0, -0.4}) {
        law.set_growth(growing(kind));
        law.drive({0.0, factor});
        const double g = 1.0 + factor;
        const Tensor3 free = grown(kind, g) - identity();
        EXPECT_LT(norm(kirchhoff_stress(law, free)), 1e-12 * 2430.4) << factor;
        EXPECT_NEAR(tensor::det(grown(kind, g)), g, 1e-14);
        EXPECT_NEAR(energy(law, free), 0.0, 1e-12 * 2430.4);
      }
}

// A body that is held while it grows by g is squeezed as one that is compressed by g^(-1/3).
TEST(Growth, OfAHeldBodyIsPressure) {
  AnyLaw law = NeoHookean{520.8, 2430.4};
  law.set_growth(growing(Growth::Kind::volume));
  law.drive({0.0, 1.0});
  const Tensor3 sigma = cauchy_stress(law, Tensor3{});
  const double expected = -2.0 * 2430.4 * std::log(2.0);  // g U'(ln J_e), J_e = 1/2
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(sigma(i, j), i == j ? expected : 0.0, 1e-10);
}

// V-ACTIVE-1.
TEST(ActiveStress, IsItsTensionAtRest) {
  for (const ActiveStress::Kind kind : actives) {
    AnyLaw law = NeoHookean{520.8, 2430.4};
    law.set_active_stress({200.0, kind, {N[0], N[1], N[2]}});
    law.drive({0.5, 0.0});
    const Tensor3 tau = kirchhoff_stress(law, Tensor3{}), along = tensor::square_of(N);
    const Tensor3 expected = 100.0 * (kind == ActiveStress::Kind::isotropic ? identity()
                                      : kind == ActiveStress::Kind::fiber   ? along
                                                                            : identity() - along);
    EXPECT_LT(norm(tau - expected), 1e-12);
  }
}

TEST(ActiveStress, MovesWithTheBody) {
  for (const ActiveStress::Kind kind : actives) {
    AnyLaw law = NeoHookean{520.8, 2430.4}, passive = law;
    law.set_active_stress({200.0, kind, {N[0], N[1], N[2]}});
    law.drive({1.0, 0.0});
    const Tensor3 F = identity() + H, b = F * transpose(F);
    const Tensor3 n = F * tensor::square_of(N) * transpose(F);
    const Tensor3 expected = 200.0 * (kind == ActiveStress::Kind::isotropic ? b
                                      : kind == ActiveStress::Kind::fiber   ? n
                                                                            : b - n);
    EXPECT_LT(norm(kirchhoff_stress(law, H) - kirchhoff_stress(passive, H) - expected), 1e-11);
    expect_derivatives(law, false);
  }
}

TEST(ActiveStress, OfWhatGrowsAndRelaxesHasItsTangent) {
  double history[12];
  for (int n = 0; n < 12; ++n) history[n] = 40.0 * std::sin(1.0 + 1.7 * n);
  for (AnyLaw law : matrices()) {
    Viscosity viscosity;
    viscosity.terms = 1;
    viscosity.modulus[0] = 0.6;
    viscosity.time[0] = 0.5;
    law.set_viscosity(viscosity);
    law.set_growth(growing(Growth::Kind::area));
    law.set_active_stress({200.0, ActiveStress::Kind::fiber, {N[0], N[1], N[2]}});
    law.recall(history, 0.2);
    law.drive({0.4, 0.3});
    expect_derivatives(law, false);
  }
}

}  // namespace
}  // namespace stroma::material
