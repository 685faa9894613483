// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Relaxation of a stress: the update against the convolution, and the tangent that goes with it.
/// Claims V-VISC-1 and V-VISC-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "LawChecks.hpp"

namespace stroma::material {
namespace {

using namespace test;
using tensor::identity;
using tensor::transpose;

Viscosity two_terms(bool is_deviatoric) {
  Viscosity viscosity;
  viscosity.terms = 2;
  viscosity.long_term = 0.8;
  viscosity.modulus[0] = 0.6;
  viscosity.modulus[1] = 0.3;
  viscosity.time[0] = 0.5;
  viscosity.time[1] = 5.0;
  viscosity.is_deviatoric = is_deviatoric;
  return viscosity;
}

/// S at the end of steps of these lengths, through which S_e is a function of time.
template <class Elastic>
double stress_after(const std::vector<double>& steps, const Elastic& elastic_at) {
  Viscosity viscosity = two_terms(false);
  double history[Viscosity::most_states] = {}, time = 0.0, stress = 0.0;
  for (const double dt : steps) {
    time += dt;
    viscosity.prepare(dt);
    Tensor3 S;
    S(0, 0) = elastic_at(time);
    stress = viscosity.factor * S(0, 0) + viscosity.memory(history)(0, 0);
    double next[Viscosity::most_states];
    viscosity.advance(history, S, next);
    std::copy(next, next + viscosity.states(), history);
  }
  return stress;
}

// V-VISC-1. S_e = r t gives S = r (G0 t + sum g_i t_i (1 - exp(-t / t_i))), in one step or many.
TEST(Viscosity, IsExactForAStressThatGrowsEvenly) {
  const double r = 7.0, t = 2.0;
  const double exact =
      r * (0.8 * t - 0.6 * 0.5 * std::expm1(-t / 0.5) - 0.3 * 5.0 * std::expm1(-t / 5.0));
  for (const auto& steps : {std::vector<double>{2.0}, {0.5, 1.5}, {1.0, 0.25, 0.75}})
    EXPECT_NEAR(stress_after(steps, [=](double s) { return r * s; }), exact, 1e-13 * exact);
}

// S_e = r t^2, whose convolution is r (G0 t^2 + sum 2 g_i t_i (t - t_i (1 - exp(-t / t_i)))), in ever
// shorter steps.
TEST(Viscosity, IsOfSecondOrderForAStressThatGrowsUnevenly) {
  const Viscosity viscosity = two_terms(false);
  const double r = 7.0, t = 2.0;
  double exact = 0.8 * t * t;
  for (int i = 0; i < viscosity.terms; ++i) {
    const double own = viscosity.time[i];
    exact += 2.0 * viscosity.modulus[i] * own * (t + own * std::expm1(-t / own));
  }
  exact *= r;
  const auto error = [&](int count) {
    const std::vector<double> steps(static_cast<std::size_t>(count), t / count);
    return std::abs(stress_after(steps, [=](double s) { return r * s * s; }) - exact);
  };
  EXPECT_LT(error(8), 0.01 * exact);
  for (const int count : {8, 16, 32})
    EXPECT_NEAR(std::log2(error(count) / error(2 * count)), 2.0, 0.05) << count;
}

TEST(Viscosity, OfASuddenLoadIsTheSumOfAllModuli) {
  Viscosity viscosity = two_terms(false);
  const auto factor = [&](double dt) {
    viscosity.prepare(dt);
    return viscosity.factor;
  };
  EXPECT_DOUBLE_EQ(factor(0.0), 1.7);
  EXPECT_NEAR(factor(1e-9), 1.7, 1e-8);
  EXPECT_NEAR(factor(1e9), 0.8, 1e-8);
}

// V-VISC-2. With a history of three stresses that are not those of H.
TEST(Viscosity, TangentIsTheDerivativeOfTheStress) {
  double history[18];
  for (int n = 0; n < 18; ++n) history[n] = 40.0 * std::sin(1.0 + 1.7 * n);
  const AnyLaw matrices[] = {CoupledNeoHookean{520.8, 700.0}, NeoHookean{520.8, 2430.4},
                             VerondaWestmann{{2430.4}, 100.0, 4.0}};
  for (const AnyLaw& matrix : matrices)
    for (const bool is_deviatoric : {false, true}) {
      if (is_deviatoric && matrix.matrix().is<CoupledNeoHookean>()) continue;
      AnyLaw law = matrix;
      law.set_viscosity(two_terms(is_deviatoric));
      law.recall(history, 0.7);
      const Tensor4 a = tangent(law, H).in_full();
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l) EXPECT_NEAR(a(i, j, k, l), a(k, l, i, j), 1e-11 * 2430.4);
      const double h = 1e-5, size = norm(stress_slope(law, h));
      EXPECT_LT(tangent_error(law, h), 1e-8 * size) << is_deviatoric;
      EXPECT_LT(norm(tangent(law, H).tau - kirchhoff_stress(law, H)), 1e-12 * size);
    }
}

// Turning the specimen turns the stress: the history refers to the undeformed body.
TEST(Viscosity, RotatesWithTheSpecimen) {
  double history[18];
  for (int n = 0; n < 18; ++n) history[n] = 40.0 * std::cos(2.0 + 1.3 * n);
  for (const bool is_deviatoric : {false, true}) {
    AnyLaw law = NeoHookean{520.8, 2430.4};
    law.set_viscosity(two_terms(is_deviatoric));
    law.recall(history, 0.7);
    const double c = std::cos(0.7), s = std::sin(0.7);
    const Tensor3 Q{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}, F = identity() + H;
    const Tensor3 tau = kirchhoff_stress(law, H);
    EXPECT_LT(norm(kirchhoff_stress(law, Q * F - identity()) - Q * tau * transpose(Q)),
              1e-12 * norm(tau));
  }
}

}  // namespace
}  // namespace stroma::material
