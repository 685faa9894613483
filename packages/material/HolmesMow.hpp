// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The solid of Holmes and Mow.

#include "stroma/material/LawParameters.hpp"

namespace stroma::material {

/// Isotropic hyperelastic solid that stiffens exponentially in tension and in compression,
///
///     W = H/(4 beta) (exp(Q) - 1),   H = lambda + 2 mu,
///     Q = beta/H ((2 mu - lambda)(I1 - 3) + lambda (I2 - 3) - 2 H ln J),
///
/// with the invariants of b = F F^T. Shape and volume are not apart: U = 0.
/// Source: Holmes & Mow (1990), J Biomech 23:1145 (of cartilage); "Holmes-Mow" of FEBio.
struct HolmesMow {
  double shear_modulus;  ///< mu [Pa], > 0
  double lame_modulus;   ///< lambda [Pa], > -2/3 mu
  double exponent;       ///< beta [-], > 0

  static constexpr bool has_energy_of_volume = false;
  static constexpr bool is_isochoric = false;

  static const char* name() { return "Holmes-Mow"; }
  static const char* meaning() {
    return "W = H/(4 Beta) (e^Q - 1), H = lambda + 2 mu, Q = Beta/H ((2 mu - lambda)(I1 - 3) + "
           "lambda (I2 - 3) - 2 H ln J)";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("Shear Modulus [Pa]", &HolmesMow::shear_modulus, Range::positive(),
                      "Shear modulus mu of small strain.");
    declare_lame_modulus(parameters, &HolmesMow::lame_modulus);
    parameters.number("Beta", &HolmesMow::exponent, Range::positive(),
                      "Factor beta of the exponent.");
  }

  using Tangent = FullTangent;

  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const {
    return {shear_modulus, lame_modulus + 2.0 / 3.0 * shear_modulus};
  }
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double) const { return 0.0; }
  KOKKOS_INLINE_FUNCTION VolumetricStress stress_of_volume(double) const { return {0.0, 0.0}; }

  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return (lame_modulus + 2.0 * shear_modulus) / (4.0 * exponent) * expm1(q(H)) + of_volume;
  }

  /// With e = b - I:  tau = exp(Q)/2 (2 mu e + lambda (tr(e) I + tr(e) e - e^2)) + p I.
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double,
                                                  const VolumetricStress& volume) const {
    const Tensor3 e = tensor::left_cauchy_green_minus_identity(H);
    const double lambda = lame_modulus, t = tensor::trace(e), factor = 0.5 * exp(q(H));
    Tensor3 tau = factor * ((2.0 * shear_modulus + lambda * t) * e - lambda * (e * e));
    for (int i = 0; i < 3; ++i) tau(i, i) += factor * lambda * t + volume.pressure;
    return tau;
  }

  /// c = exp(Q) (lambda (b x b - b (.) b) + H I4) + 4 beta/H exp(-Q) s x s + M I x I - 2 p I4,
  ///
  /// s = tau - p I, (b (.) b)_ijkl = (b_ik b_jl + b_il b_jk) / 2.
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    const Tensor3 s = kirchhoff_stress(H, log_j, {0.0, 0.0});
    const Tensor3 b = tensor::identity() + tensor::left_cauchy_green_minus_identity(H);
    const double lambda = lame_modulus, modulus = lambda + 2.0 * shear_modulus;
    const double factor = exp(q(H)), of_s = 4.0 * exponent / (modulus * factor);
    FullTangent result;
    result.tau = s;
    for (int i = 0; i < 3; ++i) result.tau(i, i) += volume.pressure;
    result.c.add_isotropic(volume.modulus, 0.5 * factor * modulus - volume.pressure, {});
    result.c.add_dyad(factor * lambda, b);
    result.c.add_square(-factor * lambda, b);
    result.c.add_dyad(of_s, s);
    return result;
  }

 private:
  /// Q = beta (tr e - 2 ln J + lambda/(2 H) ((tr e)^2 - e:e)), of second order in the strain:
  /// tr e - 2 ln J = H:H - 2 II - 2 III + 2 (j - ln J), with j = J - 1 and the invariants of H.
  KOKKOS_INLINE_FUNCTION double q(const Tensor3& H) const {
    const Tensor3 e = tensor::left_cauchy_green_minus_identity(H);
    const double lambda = lame_modulus, t = tensor::trace(e);
    return exponent *
           (tensor::contract(H, H) - 2.0 * tensor::second_invariant(H) - 2.0 * tensor::det(H) +
            2.0 * tensor::x_minus_log1p(tensor::det_minus_one(H)) +
            0.5 * lambda / (lambda + 2.0 * shear_modulus) * (t * t - tensor::contract(e, e)));
  }
};

}  // namespace stroma::material
