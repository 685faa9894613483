// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A bar that is held at one end and slides in a channel: period, decay, order in time, energy.
/// Claims V-DYN-BAR, V-DYN-ORDER and V-DYN-ENERGY, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using mechanics::TimeScheme;
using Vector = std::array<double, 3>;

const double pi = std::acos(-1.0);
constexpr int elements = 16;
constexpr double mu = 500.0, K = 1000.0, rho = 1000.0;
constexpr double M = K + 4.0 / 3.0 * mu;  // [Pa]

/// A bar along x in a channel without friction, fixed at x = 0, that begins in its first mode with
/// the velocity v sin(pi x / 2 L).
test::Specimen bar(double v) {
  test::Specimen specimen;
  specimen.elements = {elements, 1, 1};
  specimen.spacing = {1.0, 1.0, 1.0};
  specimen.laws = {{mu, K}};
  specimen.density = {rho};
  specimen.conditions = {{"base", test::hold(Face::x_lower, "x")},
                         {"floor", test::hold(Face::y_lower, "y")},
                         {"ceiling", test::hold(Face::y_upper, "y")},
                         {"back", test::hold(Face::z_lower, "z")},
                         {"front", test::hold(Face::z_upper, "z")}};
  specimen.dynamics.emplace();
  specimen.dynamics->initial_velocity = [v](const Vector& X) {
    return Vector{v * std::sin(0.5 * pi * X[0] / elements), 0.0, 0.0};
  };
  return specimen;
}

/// Frequency of the first mode of the bar's elements [1/s], with lumped masses: 2 c / h sin(pi / 4 n);
/// and with the consistent mass, over sqrt(1 - 2/3 sin^2(pi / 4 n)).
double frequency(bool lumped) {
  const double c = std::sqrt(M / (1e-12 * rho)), sine = std::sin(0.25 * pi / elements);
  return 2.0 * c * sine / (lumped ? 1.0 : std::sqrt(1.0 - 2.0 / 3.0 * sine * sine));
}

/// Displacement of the bar's tip after each step.
std::vector<double> tip(const test::Specimen& specimen, int steps) {
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::world());
  std::vector<double> motion;
  solver::SolverParameters exact = test::to_rounding();
  exact.newton_tolerance = 1e-11;
  test::take_steps(body, steps, exact, [&](double, const grid::Vector& u) {
    double sum = 0.0;
    test::for_each_unknown(body.balance().halo(), u,
                           [&](const grid::Index3& node, int c, double value) {
                             if (node[0] == elements && c == 0) sum += 0.25 * value;
                           });
    motion.push_back(body.balance().halo().communicator().sum(sum));
  });
  return motion;
}

struct Mode {
  double frequency;  ///< [1/s]
  double decay;      ///< [1/s]
};

/// Frequency and decay of a motion x_n = e^(-d t) sin(w t + p), from the recurrence
/// x_(n+1) + q x_(n-1) = 2 r x_n that all of its points fulfil: least squares.
Mode mode_of(const std::vector<double>& x, double dt) {
  double a11 = 0.0, a12 = 0.0, a22 = 0.0, b1 = 0.0, b2 = 0.0;
  for (std::size_t n = 1; n + 1 < x.size(); ++n) {
    a11 += x[n] * x[n];
    a12 -= x[n] * x[n - 1];
    a22 += x[n - 1] * x[n - 1];
    b1 += x[n] * x[n + 1];
    b2 -= x[n - 1] * x[n + 1];
  }
  const double det = a11 * a22 - a12 * a12;
  const double trace = (b1 * a22 - b2 * a12) / det, product = (a11 * b2 - a12 * b1) / det;
  return {std::acos(0.5 * trace / std::sqrt(product)) / dt, -0.5 * std::log(product) / dt};
}

class Bar : public ::testing::TestWithParam<bool> {};

// The trapezoidal rule turns a frequency w into 2/dt atan(w dt/2), and damps nothing.
TEST_P(Bar, HasThePeriodOfItsElementsByTheTrapezoidalRule) {
  test::Specimen specimen = bar(1.0);
  specimen.dynamics->lumped = GetParam();
  const double w = frequency(GetParam());
  specimen.duration = 2.0 * 2.0 * pi / w;
  const double dt = specimen.duration / 60;
  const Mode found = mode_of(tip(specimen, 60), dt);
  EXPECT_NEAR(found.frequency, 2.0 / dt * std::atan(0.5 * w * dt), 1e-7 * w);
  EXPECT_NEAR(found.decay, 0.0, 1e-7 * w);
}

// Rayleigh's damping: the mode decays by (alpha + beta w^2) / 2, at the frequency
// sqrt(w^2 - decay^2), to the order of the step.
TEST_P(Bar, DecaysByRayleighsDamping) {
  const double w = frequency(GetParam());
  double before[2] = {};
  for (const int steps : {40, 80, 160}) {
    test::Specimen specimen = bar(1.0);
    specimen.dynamics->lumped = GetParam();
    specimen.dynamics->mass_damping = 0.1 * w;
    specimen.dynamics->stiffness_damping = 0.06 / w;
    specimen.duration = 2.0 * pi / w;
    const double decay = 0.5 * (0.1 + 0.06) * w;
    const Mode found = mode_of(tip(specimen, steps), specimen.duration / steps);
    const double errors[2] = {std::abs(found.frequency / std::sqrt(w * w - decay * decay) - 1.0),
                              std::abs(found.decay / decay - 1.0)};
    for (int n = 0; n < 2; ++n) {
      EXPECT_LT(errors[n], 40.0 / (steps * steps)) << n;
      if (before[n] > 0.0) {
        EXPECT_NEAR(before[n] / errors[n], 4.0, 0.1) << n;
      }
      before[n] = errors[n];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Masses, Bar, ::testing::Bool(),
                         [](const auto& one) { return one.param ? "Lumped" : "Consistent"; });

/// Of schemes that are in balance at different points of a step.
struct Scheme {
  std::string name;
  TimeScheme scheme;
  bool lumped;
};

class Schemes : public ::testing::TestWithParam<Scheme> {};

// Amplitudes of 10 %: halving the step divides the error by four.
TEST_P(Schemes, AreOfSecondOrderInTime) {
  const double w = frequency(true);
  std::vector<double> ends;
  for (const int steps : {40, 80, 160}) {
    test::Specimen specimen = bar(0.1 * elements * w);
    specimen.dynamics->scheme = GetParam().scheme;
    specimen.dynamics->lumped = GetParam().lumped;
    specimen.duration = 1.2 * pi / w;
    ends.push_back(tip(specimen, steps).back());
  }
  EXPECT_NEAR((ends[0] - ends[1]) / (ends[1] - ends[2]), 4.0, 0.4);
}

INSTANTIATE_TEST_SUITE_P(
    All, Schemes,
    ::testing::Values(Scheme{"Newmark", TimeScheme::newmark(0.25, 0.5), true},
                      Scheme{"Newmark_Consistent", TimeScheme::newmark(0.25, 0.5), false},
                      Scheme{"Midpoint", TimeScheme::generalised_alpha(1.0), true},
                      Scheme{"Alpha_09", TimeScheme::generalised_alpha(0.9), true},
                      Scheme{"Alpha_05_Consistent", TimeScheme::generalised_alpha(0.5), false},
                      Scheme{"Alpha_00", TimeScheme::generalised_alpha(0.0), true}),
    [](const auto& one) { return one.param.name; });

/// The largest departure of strain and kinetic energy from the energy at the begin, over it.
double energy_error(TimeScheme scheme, int steps, double periods) {
  const double w = frequency(true);
  test::Specimen specimen = bar(0.05 * elements * w);
  specimen.dynamics->scheme = scheme;
  specimen.duration = periods * 2.0 * pi / w;
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::world());
  const double at_start = body.balance().inertia()->kinetic_energy();
  double worst = 0.0;
  solver::SolverParameters exact = test::to_rounding();
  exact.newton_tolerance = 1e-11;
  test::take_steps(body, steps, exact, [&](double, const grid::Vector& u) {
    const auto fields = body.balance().body().particle_fields(u);
    double sum = 0.0;
    for (int p = 0; p < body.balance().body().particles().count(); ++p)
      sum += fields.energy(p) * body.balance().body().particles().volume(p);
    sum =
        body.balance().body().communicator().sum(sum) + body.balance().inertia()->kinetic_energy();
    worst = std::max(worst, std::abs(sum / at_start - 1.0));
  });
  return worst;
}

// Over 1,000 steps the energy stays within an error that is of the order of the step squared and
// does not grow; a spectral radius below one lets go of the energy of high frequencies alone.
TEST(Energy, IsKeptToTheSchemesOrder) {
  for (const TimeScheme& scheme :
       {TimeScheme::newmark(0.25, 0.5), TimeScheme::generalised_alpha(1.0)}) {
    const double coarse = energy_error(scheme, 1000, 25.0), few = energy_error(scheme, 100, 2.5),
                 fine = energy_error(scheme, 1000, 12.5);
    EXPECT_LT(coarse, 2e-2);
    EXPECT_LT(coarse, 1.6 * few);
    EXPECT_GT(coarse / fine, 2.5);
    std::printf("  energy within %.2e, with half the step %.2e\n", coarse, fine);
  }
}

}  // namespace
}  // namespace stroma
