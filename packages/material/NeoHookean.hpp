// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The paper's neo-Hookean solid: energy, stress and tangent of one particle.

#include "stroma/tensor/SmallDifference.hpp"
#include "stroma/tensor/Tensor3.hpp"

namespace stroma::material {

using tensor::Tensor3;

/// Fourth-order tensor c(i,j,k,l), stored in full; the kernels' inner loops want no index tables.
struct Tensor4 {
  double value[3][3][3][3];

  KOKKOS_INLINE_FUNCTION double& operator()(int i, int j, int k, int l) {
    return value[i][j][k][l];
  }
  KOKKOS_INLINE_FUNCTION double operator()(int i, int j, int k, int l) const {
    return value[i][j][k][l];
  }
};

/// Stress and spatial tangent of an isotropic law whose tangent, all in [Pa], is
///
///     a_ijkl = vol d_ij d_kl + sym (d_ik d_jl + d_il d_jk) - 2/3 (s_ij d_kl + d_ij s_kl)
///              + d_ik tau_jl.
struct IsotropicTangent {
  Tensor3 tau;        ///< Kirchhoff stress
  Tensor3 s;          ///< a symmetric tensor; of NeoHookean, dev tau
  double volumetric;  ///< vol
  double symmetric;   ///< sym

  /// a_ijkl in full.
  KOKKOS_INLINE_FUNCTION Tensor4 in_full() const {
    Tensor4 a;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l) {
            const double ij = i == j, kl = k == l, ik = i == k, jl = j == l, il = i == l,
                         jk = j == k;
            a(i, j, k, l) = volumetric * ij * kl + symmetric * (ik * jl + il * jk) -
                            2.0 / 3.0 * (s(i, j) * kl + ij * s(k, l)) + ik * tau(j, l);
          }
    return a;
  }
};

/// Energy of a change of volume, as a function of x = ln J alone.
enum class VolumetricEnergy {
  logarithmic,  ///< U = K/2 (ln J)^2
  quadratic     ///< U = K/4 (J^2 - 1 - 2 ln J)
};

/// The part of stress and tangent that comes of the volume: p I, and p, M in IsotropicTangent.
struct VolumetricStress {
  double pressure;  ///< p [Pa], tension positive; of the law itself, dU/d ln J
  double modulus;   ///< M [Pa]; of the law itself, dp/d ln J
};

/// Isotropic hyperelastic solid with stored energy per reference volume
///
///     W = mu/2 (tr Cbar - 3) + U(J),   Cbar = J^(-2/3) F^T F,  J = det F.
///
/// All functions take the displacement gradient H = F - I, H(i,j) = du_i/dX_j [-], instead of F, so
/// that small strains keep full precision (docs/theory.md, "Digits of small strains"); those of the
/// volume take ln J for the same reason. Device code cannot throw: an inverted particle (J <= 0)
/// gives results that are not finite.
///
/// Source: the paper's equation (12); Simo & Hughes (1998), section 9.2 (quadratic U), 9.3
/// (isochoric part of the tangent). Symbols and units: docs/notation.md.
struct NeoHookean {
  double shear_modulus;  ///< mu [Pa], > 0
  double bulk_modulus;   ///< K [Pa], > 0
  VolumetricEnergy volumetric_energy = VolumetricEnergy::logarithmic;

  /// ln J [-]; not a number for J <= 0.
  KOKKOS_INLINE_FUNCTION static double log_jacobian(const Tensor3& H) {
    return log1p(tensor::det_minus_one(H));
  }

  /// U [Pa] at x = ln J; the quadratic one is K/4 (exp(2 x) - 1 - 2 x). Accurate to rounding for
  /// small x.
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    return volumetric_energy == VolumetricEnergy::logarithmic
               ? 0.5 * bulk_modulus * log_j * log_j
               : 0.25 * bulk_modulus * tensor::expm1_minus_x(2.0 * log_j);
  }

  /// The first two derivatives of U by ln J [Pa]: K ln J and K, or K/2 (J^2 - 1) and K J^2.
  KOKKOS_INLINE_FUNCTION VolumetricStress volumetric_stress(double log_j) const {
    if (volumetric_energy == VolumetricEnergy::logarithmic)
      return {bulk_modulus * log_j, bulk_modulus};
    const double growth = expm1(2.0 * log_j);
    return {0.5 * bulk_modulus * growth, bulk_modulus * (1.0 + growth)};
  }

  /// Stored energy W [Pa] = [aJ/um^3]. Of second order in H and accurate to rounding there:
  ///
  ///     tr Cbar - 3 = e tr(b - I) + H:H - 2 II - 2 III + 2 (j - ln J) + 3 (e - x),
  ///
  /// with j = J - 1, x = -2/3 ln J, e = exp(x) - 1, II and III the invariants of H.
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H) const {
    const double j = tensor::det_minus_one(H);
    const double log_j = log1p(j);
    const double x = -2.0 / 3.0 * log_j;
    const double isochoric = expm1(x) * tensor::trace(tensor::left_cauchy_green_minus_identity(H)) +
                             tensor::contract(H, H) - 2.0 * tensor::second_invariant(H) -
                             2.0 * tensor::det(H) + 2.0 * tensor::x_minus_log1p(j) +
                             3.0 * tensor::expm1_minus_x(x);
    return 0.5 * shear_modulus * isochoric + energy_of_volume(log_j);
  }

  /// Kirchhoff stress tau = J sigma, 3 x 3 symmetric [Pa]:
  ///
  ///     tau = mu J^(-2/3) dev(b) + p I,   b = F F^T,  dev(b) = dev(b - I),  p = dU/d ln J.
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H) const {
    const double log_j = log_jacobian(H);
    return kirchhoff_stress(H, log_j, volumetric_stress(log_j));
  }

  /// The same with the volume's part given; log_j = ln det(I + H).
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    Tensor3 tau = (shear_modulus * exp(-2.0 / 3.0 * log_j)) *
                  tensor::deviator(tensor::left_cauchy_green_minus_identity(H));
    for (int i = 0; i < 3; ++i) tau(i, i) += volume.pressure;
    return tau;
  }

  /// Cauchy stress sigma = tau / J [Pa], tension positive.
  KOKKOS_INLINE_FUNCTION Tensor3 cauchy_stress(const Tensor3& H) const {
    return (1.0 / (1.0 + tensor::det_minus_one(H))) * kirchhoff_stress(H);
  }

  /// Spatial tangent a [Pa] of the Kirchhoff stress power:
  ///
  ///     a_ijkl = c_ijkl + delta_ik tau_jl,
  ///     c = 2 m (I4 - 1/3 I x I) - 2/3 (s x I + I x s) + M I x I - 2 p I4,
  ///
  /// with s = dev tau, m = mu/3 J^(-2/3) tr b, p and M the first two derivatives of U by ln J, I4
  /// the symmetric identity: vol = M - 2/3 m, sym = m - p. Then d(tau F^-T) = (a : D) F^-T for
  /// dF = D F: what a residual sum_p V0 tau grad N differentiates to.
  KOKKOS_INLINE_FUNCTION IsotropicTangent isotropic_tangent(const Tensor3& H) const {
    const double log_j = log_jacobian(H);
    return isotropic_tangent(H, log_j, volumetric_stress(log_j));
  }

  /// The same with the volume's part given; log_j = ln det(I + H).
  KOKKOS_INLINE_FUNCTION IsotropicTangent isotropic_tangent(const Tensor3& H, double log_j,
                                                            const VolumetricStress& volume) const {
    const double factor = shear_modulus * exp(-2.0 / 3.0 * log_j);
    const Tensor3 b_minus_identity = tensor::left_cauchy_green_minus_identity(H);
    IsotropicTangent t;
    t.s = factor * tensor::deviator(b_minus_identity);
    t.tau = t.s;
    for (int i = 0; i < 3; ++i) t.tau(i, i) += volume.pressure;
    const double m = factor * (1.0 + tensor::trace(b_minus_identity) / 3.0);
    t.volumetric = volume.modulus - 2.0 / 3.0 * m;
    t.symmetric = m - volume.pressure;
    return t;
  }
};

}  // namespace stroma::material
