// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the kernels ask of a constitutive law, and what follows from it for any law.
///
/// A law is a plain struct whose stored energy per reference volume is a sum
///
///     W = W1(F) + U(J),   J = det F,
///
/// of an energy of volume U and of all else, W1. Mean dilatation, which averages the change of
/// volume over an element, averages U's alone: what resists a change of volume much more than a
/// change of shape belongs into U. W1 of most laws is isochoric, a function of J^(-2/3) F^T F. Where
/// it is not, mean dilatation with a grid that is reset changes W1 a little from step to step: a
/// step leaves F (Jt/J)^(1/3) to the next, whose W1 is another.
///
/// Functions take the displacement gradient H = F - I, H(i,j) = du_i/dX_j [-], instead of F, so
/// that small strains keep full precision (docs/theory.md, "Digits of small strains"); those of the
/// volume take ln J for the same reason. Device code cannot throw: an inverted particle (J <= 0)
/// gives results that are not finite. A law `L` has
///
///     using Tangent = ...;  // IsotropicTangent or FullTangent
///     // Its shear modulus must not need the bulk modulus, which may follow from it.
///     SmallStrainModuli small_strain() const;
///     // U, and its first two derivatives by ln J [Pa]
///     double energy_of_volume(double log_j) const;
///     VolumetricStress stress_of_volume(double log_j) const;
///     // W1 + U, tau, and tau with the tangent [Pa], with the volume's part given
///     double energy(const Tensor3& H, double energy_of_volume) const;
///     Tensor3 kirchhoff_stress(const Tensor3& H, double log_j, const VolumetricStress&) const;
///     Tangent tangent(const Tensor3& H, double log_j, const VolumetricStress&) const;
///     // only of a law whose numbers may differ from particle to particle: from now on those of a
///     // particle, a row of Particles::own_numbers
///     void take(const double* own);
///     // only of a law whose W1 changes with the volume
///     static constexpr bool is_isochoric = false;
///     // only of a law without an energy of volume, U = 0, which admits no mean dilatation
///     static constexpr bool has_energy_of_volume = false;
///     // only of a law that remembers: its numbers of history and those that a particle has by now,
///     // of the last accepted step and zeros before the first; energies and stresses may read them
///     static constexpr int states = ...;
///     double state[states] = {};
///     double time_step = 0.0;  // [s], if it needs it: of the step that states are to be those after
///     // what a step makes of them once it is accepted; ln J of the particle, and of its volume as
///     // energies of volume take it (the same, but for mean dilatation)
///     void new_state(const Tensor3& H, double log_j, double log_of_volume, double* next) const;
///     // in the deck; a law of an application's own goes without
///     static const char* name();
///     static const char* meaning();
///     template <class Parameters> static void declare(Parameters&);  // LawParameters.hpp
///
/// all but the last three for host and device (KOKKOS_INLINE_FUNCTION). Kirchhoff stress
/// tau = J sigma; the spatial tangent a is that of d(tau F^-T) = (a : D) F^-T for dF = D F: what a
/// residual sum_p V0 tau grad N differentiates to. The volume's part is given, for it may be that
/// of an element's mean; it adds p I to tau and M I x I - 2 p I4 to c, I4 the symmetric identity.
/// docs/extending.md adds one step by step.

#include <type_traits>
#include <utility>

#include "stroma/material/Tangents.hpp"
#include "stroma/material/VolumetricEnergy.hpp"

namespace stroma::material {

/// Of small strain, where every law here is isotropic or has an isotropic matrix [Pa].
struct SmallStrainModuli {
  double shear;  ///< mu
  double bulk;   ///< K

  /// Of uniaxial strain, M = K + 4/3 mu [Pa].
  KOKKOS_INLINE_FUNCTION double uniaxial_strain() const { return bulk + 4.0 / 3.0 * shear; }
  /// nu = (3 K - 2 mu) / (2 (3 K + mu)) [-].
  KOKKOS_INLINE_FUNCTION double poisson_ratio() const {
    return (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear));
  }
};

/// Numbers of history of a particle that obeys a law; 0 where the law does not say.
template <class Law, class = void>
constexpr int states_of = 0;
template <class Law>
constexpr int states_of<Law, std::void_t<decltype(Law::states)>> = Law::states;

/// Whether a law has take().
template <class Law, class = void>
constexpr bool takes_numbers = false;
template <class Law>
constexpr bool takes_numbers<
    Law, std::void_t<decltype(std::declval<Law&>().take(std::declval<const double*>()))>> = true;

/// Numbers that a law takes from a particle: as many as it says by own_numbers(), or one.
template <class Law>
int numbers_taken(const Law&) {
  return takes_numbers<Law> ? 1 : 0;
}

/// Whether a law has an energy of volume U, which mean dilatation may average: it has, unless it
/// says `static constexpr bool has_energy_of_volume = false`.
template <class Law, class = void>
constexpr bool has_energy_of_volume = true;
template <class Law>
constexpr bool has_energy_of_volume<Law, std::void_t<decltype(Law::has_energy_of_volume)>> =
    Law::has_energy_of_volume;

/// Whether W1 does not change with the volume: it does not, unless the law says `static constexpr
/// bool is_isochoric = false`.
template <class Law, class = void>
constexpr bool is_isochoric = true;
template <class Law>
constexpr bool is_isochoric<Law, std::void_t<decltype(Law::is_isochoric)>> = Law::is_isochoric;

/// Those that a law needs; no more than states_of<Law>.
template <class Law>
int states_used(const Law&) {
  return states_of<Law>;
}

/// Whether a law has a time_step.
template <class Law, class = void>
constexpr bool knows_time = false;
template <class Law>
constexpr bool knows_time<Law, std::void_t<decltype(std::declval<Law&>().time_step)>> = true;

/// Gives a law the history of a particle, states_of<Law> numbers, and the length of the step [s].
template <class Law>
KOKKOS_INLINE_FUNCTION void recall(Law& law, const double* history, double time_step) {
  if constexpr (states_of < Law >> 0)
    for (int n = 0; n < states_of<Law>; ++n) law.state[n] = history[n];
  if constexpr (knows_time<Law>) law.time_step = time_step;
}

/// K = 2 mu (1 + nu) / (3 (1 - 2 nu))  [Pa].
inline double bulk_modulus(double shear_modulus, double poisson_ratio) {
  return 2.0 * shear_modulus * (1.0 + poisson_ratio) / (3.0 * (1.0 - 2.0 * poisson_ratio));
}

/// ln J [-]; not a number for J <= 0.
KOKKOS_INLINE_FUNCTION double log_jacobian(const Tensor3& H) {
  return log1p(tensor::det_minus_one(H));
}

/// Stored energy W [Pa] = [aJ/um^3]; of second order in H and accurate to rounding there.
template <class Law>
KOKKOS_INLINE_FUNCTION double energy(const Law& law, const Tensor3& H) {
  return law.energy(H, law.energy_of_volume(log_jacobian(H)));
}

/// Kirchhoff stress tau = J sigma, 3 x 3 symmetric [Pa].
template <class Law>
KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Law& law, const Tensor3& H) {
  const double log_j = log_jacobian(H);
  return law.kirchhoff_stress(H, log_j, law.stress_of_volume(log_j));
}

/// Cauchy stress sigma = tau / J [Pa], tension positive.
template <class Law>
KOKKOS_INLINE_FUNCTION Tensor3 cauchy_stress(const Law& law, const Tensor3& H) {
  return (1.0 / (1.0 + tensor::det_minus_one(H))) * kirchhoff_stress(law, H);
}

/// Stress and spatial tangent [Pa].
template <class Law>
KOKKOS_INLINE_FUNCTION typename Law::Tangent tangent(const Law& law, const Tensor3& H) {
  const double log_j = log_jacobian(H);
  return law.tangent(H, log_j, law.stress_of_volume(log_j));
}

/// Ibar1 - 3 = J^(-2/3) tr b - 3 [-], of second order in H and accurate to rounding there:
///
///     e tr(b - I) + H:H - 2 II - 2 III + 2 (j - ln J) + 3 (e - x),
///
/// with j = J - 1, x = -2/3 ln J, e = exp(x) - 1, II and III the invariants of H.
///
/// \param H,b_minus_identity,x,e  the displacement gradient F - I, and what follows from it
KOKKOS_INLINE_FUNCTION double isochoric_first_invariant_minus_3(const Tensor3& H,
                                                                const Tensor3& b_minus_identity,
                                                                double x, double e) {
  return e * tensor::trace(b_minus_identity) + tensor::contract(H, H) -
         2.0 * tensor::second_invariant(H) - 2.0 * tensor::det(H) +
         2.0 * tensor::x_minus_log1p(tensor::det_minus_one(H)) + 3.0 * tensor::expm1_minus_x(x);
}
KOKKOS_INLINE_FUNCTION double isochoric_first_invariant_minus_3(const Tensor3& H) {
  const double x = -2.0 / 3.0 * log_jacobian(H);
  return isochoric_first_invariant_minus_3(H, tensor::left_cauchy_green_minus_identity(H), x,
                                           expm1(x));
}

/// Ibar2 - 3 = J^(-4/3) ((tr b)^2 - tr b^2) / 2 - 3 [-], of second order in H and accurate to
/// rounding there: with t = tr(b - I), q = (t^2 - (b - I):(b - I)) / 2, x = -4/3 ln J,
///
///     e (2 t + q) + q + 2 H:H - 4 II - 4 III + 4 (j - ln J) + 3 (e - x).
KOKKOS_INLINE_FUNCTION double isochoric_second_invariant_minus_3(const Tensor3& H) {
  const double j = tensor::det_minus_one(H);
  const double x = -4.0 / 3.0 * log1p(j);
  const Tensor3 b_minus_identity = tensor::left_cauchy_green_minus_identity(H);
  const double t = tensor::trace(b_minus_identity);
  const double q = 0.5 * (t * t - tensor::contract(b_minus_identity, b_minus_identity));
  return expm1(x) * (2.0 * t + q) + q + 2.0 * tensor::contract(H, H) -
         4.0 * tensor::second_invariant(H) - 4.0 * tensor::det(H) + 4.0 * tensor::x_minus_log1p(j) +
         3.0 * tensor::expm1_minus_x(x);
}

}  // namespace stroma::material
