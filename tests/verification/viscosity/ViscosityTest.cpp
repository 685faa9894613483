// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A sheared block and a pulled bar that relax, against the convolution. Claim V-VISC-3, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using material::AnyLaw;
using tensor::Tensor3;

constexpr double duration = 3.0;  // [s]
// H after 1 s, held from then on: simple shear, and a bar that is pulled, whose sides are held.
const Tensor3 shear{{{0, 0.6, 0}, {}, {}}}, extension{{{}, {0, 0.6, 0}, {}}};
const material::NeoHookean gel{520.8, 2430.4};

material::Viscosity two_terms(bool is_deviatoric) {
  material::Viscosity viscosity;
  viscosity.terms = 2;
  viscosity.modulus[0] = 0.6;
  viscosity.modulus[1] = 0.3;
  viscosity.time[0] = 0.5;
  viscosity.time[1] = 5.0;
  viscosity.is_deviatoric = is_deviatoric;
  return viscosity;
}

mechanics::MovingBody body_under(const Tensor3& H, bool is_deviatoric, bool reset) {
  test::Specimen specimen;
  specimen.elements = {2, 6, 2};
  specimen.reset = reset;
  mechanics::BoundaryCondition all;
  all.face = mechanics::Face::all;
  all.components = "xyz";
  all.imposed_by = reset ? mechanics::ImposedBy::grip : mechanics::ImposedBy::nodes;
  all.displacement_gradient = {H(0, 0), H(0, 1), H(0, 2), H(1, 0), H(1, 1),
                               H(1, 2), H(2, 0), H(2, 1), H(2, 2)};
  all.curve = mechanics::load_curve({{0.0, 1.0}, {0.0, 1.0}}, duration);
  specimen.conditions = {{"all", all}};
  AnyLaw law = gel;
  law.set_viscosity(two_terms(is_deviatoric));
  mechanics::Problem problem = specimen.problem();
  problem.laws = mechanics::LawList{{law, law}};
  problem.duration = duration;
  return {world(), specimen.partition(world()), specimen.particles(world()), problem};
}

/// S_e: of all stress, or of its deviatoric part.
Tensor3 elastic(const Tensor3& H, bool is_deviatoric) {
  const Tensor3 tau = material::kirchhoff_stress(gel, H);
  const Tensor3 back = tensor::inverse(tensor::identity() + H);
  return back * (is_deviatoric ? tensor::deviator(tau) : tau) * tensor::transpose(back);
}

/// The Cauchy stress at a time of at least 1 s: the integral over the ramp by Simpson's rule. Of the
/// deviatoric part alone where H keeps the volume.
Tensor3 exact(const Tensor3& H, double time, bool is_deviatoric) {
  const auto relaxation = [](double t) {
    return 1.0 + 0.6 * std::exp(-t / 0.5) + 0.3 * std::exp(-t / 5.0);
  };
  const int pieces = 2000;
  const double ds = 1.0 / pieces, h = 1e-5;
  Tensor3 S;
  for (int k = 0; k <= pieces; ++k) {
    const double s = k * ds, weight = k == 0 || k == pieces ? 1.0 : 2.0 + 2.0 * (k % 2);
    const Tensor3 rate =
        (0.5 / h) * (elastic((s + h) * H, is_deviatoric) - elastic((s - h) * H, is_deviatoric));
    S = S + (weight * ds / 3.0 * relaxation(time - s)) * rate;
  }
  const Tensor3 F = tensor::identity() + H;
  const Tensor3 stress = (1.0 / tensor::det(F)) * (F * S * tensor::transpose(F));
  return is_deviatoric ? tensor::deviator(stress) : stress;
}

/// Largest error of the particles' stresses at 1 s and at the end, of the largest stress.
double error_of(mechanics::MovingBody body, const Tensor3& H, int steps_a_second,
                bool is_deviatoric) {
  double worst = 0.0;
  test::take_steps(
      body, 3 * steps_a_second, test::to_rounding(), [&](double load, const grid::Vector& u) {
        const double time = load * duration;
        if (std::abs(time - 1.0) > 1e-9 && load < 1.0) return;
        const Tensor3 expected = exact(H, time, is_deviatoric);
        const double size = std::sqrt(tensor::contract(expected, expected));
        const auto fields = body.balance().body().particle_fields(u);
        const int at[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
        for (int p = 0; p < body.balance().body().particles().count(); ++p)
          for (int c = 0; c < 6; ++c)
            worst = std::max(worst,
                             std::abs(fields.stress(p, c) - expected(at[c][0], at[c][1])) / size);
      });
  return world().max(worst);
}

/// Of second order in the step.
void expect_order_two(const Tensor3& H, bool is_deviatoric, bool reset) {
  SCOPED_TRACE(std::string(is_deviatoric ? "deviatoric" : "all") + (reset ? ", reset" : ""));
  const auto error = [&](int steps_a_second) {
    return error_of(body_under(H, is_deviatoric, reset), H, steps_a_second, is_deviatoric);
  };
  const double coarse = error(4), fine = error(8), finest = error(16);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.15);
  EXPECT_NEAR(std::log2(fine / finest), 2.0, 0.1);
  EXPECT_LT(finest, 1e-3);
  std::printf("  errors %.1e, %.1e, %.1e\n", coarse, fine, finest);
}

// V-VISC-3.
TEST(Viscosity, RelaxesAsTheConvolutionSays) {
  for (const bool is_deviatoric : {false, true})
    for (const bool reset : {false, true}) expect_order_two(shear, is_deviatoric, reset);
}

TEST(Viscosity, OfAUniformBarRelaxesAsTheConvolutionSays) {
  for (const bool reset : {false, true}) expect_order_two(extension, false, reset);
}

}  // namespace
}  // namespace stroma
