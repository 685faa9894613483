// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Linear viscosity in the sense of Prony, over any law.

#include "stroma/tensor/Tensor3.hpp"

namespace stroma::material {

using tensor::Tensor3;

/// Relaxation of a stress S_e that a law gives, S the second Piola-Kirchhoff stress of all of it or
/// of its deviatoric part,
///
///     S(t) = integral of G(t - s) dS_e/ds ds,   G(t) = G0 + sum_i g_i exp(-t / t_i).
///
/// A step of length dt in which S_e grows in proportion to time is integrated exactly:
///
///     H_i <- a_i H_i + b_i (S_e - S_e,old),   a_i = exp(-dt/t_i),   b_i = (1 - a_i) t_i/dt,
///     S = G0 S_e + sum_i g_i H_i = k S_e + Q,
///     k = G0 + sum_i g_i b_i,   Q = sum_i g_i (a_i H_i - b_i S_e,old),
///
/// of second order in dt otherwise. A particle remembers S_e,old and the H_i, six numbers each.
/// Source: Simo & Hughes (1998), section 10.3; Puso & Weiss (1998), J Biomech Eng 120:62.
struct Viscosity {
  static constexpr int most_terms = 6;
  static constexpr int most_states = 6 * (1 + most_terms);

  int terms = 0;                    ///< of the sum; 0: none
  double long_term = 1.0;           ///< G0 [-]; 1: the law is what is left in the end
  double modulus[most_terms] = {};  ///< g_i [-], >= 0
  double time[most_terms] = {};     ///< t_i [s], > 0
  bool is_deviatoric = false;

  double decay[most_terms] = {}, mean[most_terms] = {};  ///< a_i, b_i [-] of a step
  double factor = 1.0;                                   ///< k [-] of a step
  double prepared_for = -1.0;                            ///< the step's length [s]; < 0: none

  KOKKOS_INLINE_FUNCTION int states() const { return terms == 0 ? 0 : 6 * (1 + terms); }

  /// What follows from the length of a step alone: a_i, b_i and k; at dt = 0 k is the modulus of a
  /// sudden load, G0 + sum g_i.
  KOKKOS_INLINE_FUNCTION void prepare(double dt) {
    factor = long_term;
    for (int i = 0; i < terms; ++i) {
      decay[i] = exp(-dt / time[i]);
      mean[i] = mean_decay(dt / time[i]);
      factor += modulus[i] * mean[i];
    }
    prepared_for = dt;
  }
  /// Q, by the history of a particle. \pre prepare()
  KOKKOS_INLINE_FUNCTION Tensor3 memory(const double* history) const {
    double sum[6] = {};
    for (int i = 0; i < terms; ++i) {
      const double a = modulus[i] * decay[i], b = modulus[i] * mean[i];
      for (int c = 0; c < 6; ++c) sum[c] += a * history[6 * (1 + i) + c] - b * history[c];
    }
    return {{{sum[0], sum[3], sum[5]}, {sum[3], sum[1], sum[4]}, {sum[5], sum[4], sum[2]}}};
  }
  /// The history after a step that ends with S_e. \pre prepare()
  KOKKOS_INLINE_FUNCTION void advance(const double* history, const Tensor3& S, double* next) const {
    const double now[6] = {S(0, 0), S(1, 1), S(2, 2), S(0, 1), S(1, 2), S(2, 0)};
    for (int i = 0; i < terms; ++i)
      for (int c = 0; c < 6; ++c)
        next[6 * (1 + i) + c] =
            decay[i] * history[6 * (1 + i) + c] + mean[i] * (now[c] - history[c]);
    for (int c = 0; c < 6; ++c) next[c] = now[c];
  }

 private:
  /// (1 - exp(-x)) / x.
  KOKKOS_INLINE_FUNCTION static double mean_decay(double x) {
    return x > 0.0 ? -expm1(-x) / x : 1.0;
  }
};

}  // namespace stroma::material
