// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Motion with inertia: the scheme by which it goes through time, masses, damping, and how it begins.

#include <Kokkos_Macros.hpp>
#include <array>
#include <functional>

namespace stroma::mechanics {

/// A scheme of Newmark's family. Over a step dt, with d = u_1 - u_0,
///
///     a_1 = (d - dt v_0 - dt^2 (1/2 - beta) a_0) / (beta dt^2),
///     v_1 = v_0 + dt ((1 - gamma) a_0 + gamma a_1),
///
/// and momentum is in balance at one point of the step: with the accelerations
/// (1 - alpha_m) a_1 + alpha_m a_0, and displacement, velocity and load (1 - alpha_f) of the way from
/// the begin to the end. Source: docs/theory.md, eq. (11.3) to (11.5).
struct TimeScheme {
  double beta = 0.25, gamma = 0.5;
  double alpha_m = 0.0, alpha_f = 0.0;

  /// Newmark's: in balance at the end of the step. 1/4, 1/2 is the trapezoidal rule, of order 2 and
  /// without dissipation.
  static TimeScheme newmark(double beta, double gamma) { return {beta, gamma, 0.0, 0.0}; }
  /// Generalised alpha (Chung and Hulbert, J. Appl. Mech. 60 (1993) 371), of order 2.
  /// \param radius  spectral radius of the highest frequencies, 0 to 1: what a step leaves of them;
  ///                1 is the midpoint rule
  static TimeScheme generalised_alpha(double radius) {
    const double alpha_m = (2.0 * radius - 1.0) / (radius + 1.0), alpha_f = radius / (radius + 1.0);
    const double more = 1.0 - alpha_m + alpha_f;
    return {0.25 * more * more, 0.5 - alpha_m + alpha_f, alpha_m, alpha_f};
  }

  /// a_1 of a displacement d over a step.
  KOKKOS_INLINE_FUNCTION double acceleration(double dt, double d, double v, double a) const {
    return (d - dt * v - dt * dt * (0.5 - beta) * a) / (beta * dt * dt);
  }
  /// v_1 from both accelerations.
  KOKKOS_INLINE_FUNCTION double velocity(double dt, double v, double a, double a_1) const {
    return v + dt * ((1.0 - gamma) * a + gamma * a_1);
  }
  /// The velocity that enters the balance, of those at the begin and at the end.
  KOKKOS_INLINE_FUNCTION double velocity_at_balance(double v, double v_1) const {
    return (1.0 - alpha_f) * v_1 + alpha_f * v;
  }
  KOKKOS_INLINE_FUNCTION double acceleration_at_balance(double a, double a_1) const {
    return (1.0 - alpha_m) * a_1 + alpha_m * a;
  }
  /// Of the derivative of the balance's velocity by its displacement [1/s].
  double velocity_rate(double dt) const { return gamma / (beta * dt); }
  /// Of its acceleration [1/s^2].
  double acceleration_rate(double dt) const {
    return (1.0 - alpha_m) / ((1.0 - alpha_f) * beta * dt * dt);
  }
};

/// What a body in motion has beside its forces.
struct Dynamics {
  TimeScheme scheme = {};
  /// Masses at nodes, m_I = sum_p rho V0 N_I, in the place of the consistent matrix
  /// M_IJ = sum_p rho V0 N_I N_J.
  bool lumped = true;
  /// Rayleigh's damping, C = mass_damping M + stiffness_damping K with K at the displacement.
  double mass_damping = 0.0;       ///< [1/s]
  double stiffness_damping = 0.0;  ///< [s]
  /// Velocity at the beginning [um/s] of a point X of the undeformed body [um]; empty: rest.
  std::function<std::array<double, 3>(const std::array<double, 3>& X)> initial_velocity = {};
};

}  // namespace stroma::mechanics
