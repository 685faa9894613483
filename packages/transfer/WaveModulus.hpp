// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Where particles have lost ellipticity.

#include "stroma/material/FiberDirections.hpp"
#include "stroma/tensor/PrincipalValues.hpp"
#include "stroma/transfer/MeanDilatation.hpp"

namespace stroma::transfer {

/// A plane wave across n, and its modulus [Pa].
struct PlaneWave {
  double n[3];
  double modulus;
};

/// The softest wave across n,
///
///     min over m of  m_i Q_ik m_k,   Q_ik = n_j c_ijkl n_l + (n . tau n) d_ik   (acoustic tensor).
KOKKOS_INLINE_FUNCTION double softest_across(const material::FullTangent& tangent,
                                             const double (&n)[3]) {
  using material::Elasticity;
  double along = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) along += n[i] * tangent.tau(i, j) * n[j];
  Tensor3 Q;
  for (int i = 0; i < 3; ++i)
    for (int k = i; k < 3; ++k) {
      if (i == k) Q(i, k) = along;
      for (int j = 0; j < 3; ++j)
        for (int l = 0; l < 3; ++l)
          Q(i, k) += n[j] * tangent.c(Elasticity::pair(i, j), Elasticity::pair(k, l)) * n[l];
    }
  return tensor::principal_values(Q)(2);
}

/// Whether a quick and sufficient condition says that no plane wave has a negative modulus: that
///
///     c + t (2 I - 1 x 1),   t <= the least principal value of tau,
///
/// is not indefinite on symmetric tensors. For with e the symmetric part of m x n, m and n of unit
/// length, is m . Q m = e : c : e + n . tau n, and 1 = 2 e : e - (tr e)^2. A pressure cancels in it.
KOKKOS_INLINE_FUNCTION bool is_surely_elliptic(const material::FullTangent& tangent) {
  constexpr int pairs = material::Elasticity::pairs;
  constexpr double rounding = 1e-13;
  double t = 0.0;  // by Gershgorin's discs
  for (int i = 0; i < 3; ++i) {
    const double lower =
        tangent.tau(i, i) - fabs(tangent.tau(i, (i + 1) % 3)) - fabs(tangent.tau(i, (i + 2) % 3));
    if (i == 0 || lower < t) t = lower;
  }
  double a[pairs][pairs], size = fabs(t);
  for (int r = 0; r < pairs; ++r)
    for (int s = 0; s < pairs; ++s) {
      const double shift = r == s ? t : r < 3 && s < 3 ? -t : 0.0;
      a[r][s] = tangent.c(r, s) + shift;
      if (r == s) size += fabs(tangent.c(r, s));
    }
  for (int p = 0; p < pairs; ++p) {  // Cholesky's elimination
    const double pivot = a[p][p];
    if (!(pivot >= -rounding * size)) return false;
    const bool vanishes = pivot <= rounding * size;
    for (int r = p + 1; r < pairs; ++r) {
      if (vanishes && !(fabs(a[r][p]) <= rounding * size)) return false;
      if (vanishes) continue;
      const double factor = a[r][p] / pivot;
      for (int s = p + 1; s <= r; ++s) a[r][s] -= factor * a[s][p];
    }
  }
  return true;
}

/// The softest plane wave: of those across the directions given, and from there downhill.
KOKKOS_INLINE_FUNCTION PlaneWave softest_wave(const material::FullTangent& tangent,
                                              const material::FiberDirection* directions,
                                              int count) {
  PlaneWave softest{};
  for (int d = 0; d < count; ++d) {
    const double modulus = softest_across(tangent, directions[d].n);
    if (d > 0 && modulus >= softest.modulus) continue;
    for (int i = 0; i < 3; ++i) softest.n[i] = directions[d].n[i];
    softest.modulus = modulus;
  }
  constexpr int halvings = 11;
  double step = 0.2;  // angle [rad], at last 1e-4
  for (int halving = 0; halving < halvings; ++halving, step *= 0.5)
    for (int axis = 0; axis < 3; ++axis)
      for (const double sense : {step, -step}) {
        PlaneWave next = softest;
        next.n[axis] += sense;
        const double length =
            sqrt(next.n[0] * next.n[0] + next.n[1] * next.n[1] + next.n[2] * next.n[2]);
        for (double& n : next.n) n /= length;
        next.modulus = softest_across(tangent, next.n);
        if (next.modulus < softest.modulus) softest = next;
      }
  return softest;
}

/// Whether an element is among one in `share`, drawn by its number in the grid: on any ranks the same.
KOKKOS_INLINE_FUNCTION bool is_drawn(const ElementBox& box, int i, int j, int k, int share) {
  std::uint64_t number = static_cast<std::uint64_t>(box.first[2] + k);
  number = number * static_cast<std::uint64_t>(box.all[1]) +
           static_cast<std::uint64_t>(box.first[1] + j);
  number = number * static_cast<std::uint64_t>(box.all[0]) +
           static_cast<std::uint64_t>(box.first[0] + i);
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // Fibonacci's hash
  return (number * golden >> 32) % static_cast<std::uint64_t>(share) == 0;
}

/// The least modulus of a plane wave through each particle [Pa],
///
///     min over n, m of  m_i Q_ik m_k,   Q_ik = n_j a_ijkl n_l   (acoustic tensor, Kirchhoff),
///
/// where it is negative by more than rounding: there the tangent is not elliptic, a band across n
/// softens, and strains localise in it, on any grid in as few elements as they can. Infinite for all
/// others of the elements drawn, also where the tangent is not finite. Launch as InternalForce.
/// Source: J. Rice, in Theoretical and Applied Mechanics (1976) 207; Ogden (1984), section 6.2.7.
template <class Shape, class Law, class Device>
struct WaveModulus {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const Law*, Device> law;
  Kokkos::View<const material::FiberDirection*, Device> directions;  ///< n to begin with
  int share;                                                         ///< one element in so many
  Kokkos::View<double*, Device> least;                               ///< (particle) set
  Kokkos::View<double* [3], Device> across;  ///< (particle) n where it is negative, or empty

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    if (!is_drawn(elements.box, i, j, k, share)) return;
    LawAt<Law, Device> law_at(law, elements);
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      const Law& material = law_at(point);
      const double log_j = log1p(tensor::det_minus_one(point.H));
      const material::FullTangent tangent =
          material.tangent(point.H, log_j, material.stress_of_volume(log_j));
      least(point.p) = Kokkos::Experimental::infinity<double>::value;
      if (is_surely_elliptic(tangent)) return;
      const PlaneWave softest =
          softest_wave(tangent, directions.data(), static_cast<int>(directions.extent(0)));
      constexpr double rounding = 1e-12;
      if (!(softest.modulus < -rounding * fabs(tangent.c(0, 0)))) return;
      least(point.p) = softest.modulus;
      if (across.extent(0) > 0)
        for (int c = 0; c < 3; ++c) across(point.p, c) = softest.n[c];
    });
  }
};

}  // namespace stroma::transfer
