// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The solid of Ogden.

#include "stroma/material/OfInvariants.hpp"
#include "stroma/tensor/PrincipalValues.hpp"

namespace stroma::material {

/// Isotropic hyperelastic solid, a sum of powers of the isochoric principal stretches,
///
///     W = sum_i C_i/M_i^2 (lbar1^M_i + lbar2^M_i + lbar3^M_i - 3) + U(J),   i = 1 to n.
///
/// One term with M = 2 is NeoHookean, mu = C/2. Source: Ogden (1972), Proc R Soc A 326:565;
/// uncoupled "Ogden" of FEBio.
struct Ogden : Uncoupled {
  int terms;    ///< n, 1 to 6
  double c[6];  ///< C_i [Pa], their sum > 0
  double m[6];  ///< M_i [-], not 0

  static const char* name() { return "Ogden"; }
  static const char* meaning() {
    return "W = sum C_i/M_i^2 (lbar1^M_i + lbar2^M_i + lbar3^M_i - 3) + U(J), mu = sum C_i / 2";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.numbers("C [Pa]", &Ogden::c, &Ogden::terms, Range::any(),
                       "Moduli C_1 to C_n of the powers of the isochoric stretches.");
    parameters.numbers("M", &Ogden::m, &Ogden::terms, Range::not_zero(),
                       "Exponents M_1 to M_n, as many as C [Pa].");
    declare_volume(parameters);
  }

  using Tangent = FullTangent;

  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const {
    double sum = 0.0;
    for (int i = 0; i < terms; ++i) sum += c[i];
    return {0.5 * sum, bulk_modulus};
  }

  /// With x_a = ln lbar_a, whose sum is 0:  sum_i C_i/M_i^2 sum_a (exp(M_i x_a) - 1 - M_i x_a).
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    const Stretches at(H, log1p(tensor::det_minus_one(H)));
    double sum = 0.0;
    for (int i = 0; i < terms; ++i)
      for (const double x : at.x) sum += c[i] / (m[i] * m[i]) * tensor::expm1_minus_x(m[i] * x);
    return sum + of_volume;
  }

  /// tau = sum_a (h_a - mean h) n_a x n_a + p I,  h_a = sum_i C_i/M_i (exp(M_i x_a) - 1).
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    const Stretches at(H, log_j);
    const Slopes h(*this, at);
    return at.tensor_of({h.value[0] - h.mean() + volume.pressure,
                         h.value[1] - h.mean() + volume.pressure,
                         h.value[2] - h.mean() + volume.pressure});
  }

  /// In the principal axes, with q = p - mean h, h'_a = sum_i C_i lbar_a^M_i,
  ///
  ///     c_aabb = h'_a (d_ab - 1/3) - (h'_b - mean h')/3 - 2 tau_a d_ab + M,
  ///     c_abab = (h_a - h_b) / ((lambda_a / lambda_b)^2 - 1) - h_b - q,
  ///
  /// the quotient by expm1 of the difference d of the log stretches: exact for equal ones.
  /// Source: Holzapfel (2000), section 6.6, equation (6.180).
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    const Stretches at(H, log_j);
    const Slopes h(*this, at);
    const double q = volume.pressure - h.mean();
    const double mean_rate = (h.rate[0] + h.rate[1] + h.rate[2]) / 3.0;
    FullTangent result;
    result.tau = at.tensor_of({h.value[0] + q, h.value[1] + q, h.value[2] + q});
    for (int a = 0; a < 3; ++a) {
      const Tensor3 aa = at.dyad(a, a);
      result.c.add_dyad(volume.modulus + (h.rate[a] + mean_rate) / 3.0 - 2.0 * (h.value[a] + q),
                        aa);
      for (int b = a + 1; b < 3; ++b) {
        result.c.add_dyads(volume.modulus - (h.rate[a] + h.rate[b] - mean_rate) / 3.0, aa,
                           at.dyad(b, b));
        const Tensor3 ab = at.dyad(a, b);
        result.c.add_dyad(divided_difference(at, a, b) - h.value[b] - q,
                          ab + tensor::transpose(ab));
      }
    }
    return result;
  }

 private:
  /// Principal axes of b, and the logarithms of the stretches, of relative accuracy.
  struct Stretches {
    Tensor3 axes;
    double log[3];  ///< ln lambda_a
    double x[3];    ///< ln lbar_a

    KOKKOS_INLINE_FUNCTION Stretches(const Tensor3& H, double log_j) {
      const tensor::PrincipalAxes e =
          tensor::principal_axes(tensor::left_cauchy_green_minus_identity(H));
      axes = e.axes;
      for (int a = 0; a < 3; ++a) {
        log[a] = 0.5 * log1p(e.value[a]);
        x[a] = log[a] - log_j / 3.0;
      }
    }
    /// n_a x n_b.
    KOKKOS_INLINE_FUNCTION Tensor3 dyad(int a, int b) const {
      Tensor3 result;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result(i, j) = axes(i, a) * axes(j, b);
      return result;
    }
    /// sum_a value_a n_a x n_a.
    KOKKOS_INLINE_FUNCTION Tensor3 tensor_of(const tensor::PrincipalValues& value) const {
      Tensor3 sum;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int a = 0; a < 3; ++a) sum(i, j) += value(a) * axes(i, a) * axes(j, a);
      return sum;
    }
  };

  /// h_a, and h'_a its derivative by x_a [Pa].
  struct Slopes {
    double value[3] = {}, rate[3] = {};

    KOKKOS_INLINE_FUNCTION Slopes(const Ogden& law, const Stretches& at) {
      for (int i = 0; i < law.terms; ++i)
        for (int a = 0; a < 3; ++a) {
          const double growth = expm1(law.m[i] * at.x[a]);
          value[a] += law.c[i] / law.m[i] * growth;
          rate[a] += law.c[i] * (1.0 + growth);
        }
    }
    KOKKOS_INLINE_FUNCTION double mean() const { return (value[0] + value[1] + value[2]) / 3.0; }
  };

  /// (h_a - h_b) / (exp(2 d) - 1), d = ln lambda_a - ln lambda_b.
  KOKKOS_INLINE_FUNCTION double divided_difference(const Stretches& at, int a, int b) const {
    const double d = at.log[a] - at.log[b], difference = expm1(2.0 * d);
    double sum = 0.0;
    for (int i = 0; i < terms; ++i)
      sum += c[i] / m[i] * exp(m[i] * at.x[b]) *
             (d == 0.0 ? 0.5 * m[i] : expm1(m[i] * d) / difference);
    return sum;
  }
};

}  // namespace stroma::material
