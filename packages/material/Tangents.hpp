// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Stress and spatial tangent of one particle, in two forms: isotropic, in a few numbers, and full.

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

/// Stress and spatial tangent of a law whose tangent, all in [Pa], is
///
///     a_ijkl = vol d_ij d_kl + sym (d_ik d_jl + d_il d_jk) - 2/3 (s_ij d_kl + d_ij s_kl)
///              + d_ik tau_jl.
struct IsotropicTangent {
  Tensor3 tau;        ///< Kirchhoff stress
  Tensor3 s;          ///< a symmetric tensor; of NeoHookean, dev tau
  double volumetric;  ///< vol
  double symmetric;   ///< sym

  /// That of a stress which changes with the volume alone: a_ijkl = modulus d_ij d_kl.
  KOKKOS_INLINE_FUNCTION static IsotropicTangent of_volume(double modulus) {
    return {{}, {}, modulus, 0.0};
  }

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

/// Stress and spatial tangent of any law, all in [Pa]:
///
///     a_ijkl = c_ijkl + d_ik tau_jl
///
/// with c the spatial elasticity tensor of the Kirchhoff stress; it has both minor symmetries.
struct FullTangent {
  Tensor3 tau;  ///< Kirchhoff stress
  Tensor4 a;    ///< geometric part included

  FullTangent() = default;
  KOKKOS_INLINE_FUNCTION FullTangent(const IsotropicTangent& isotropic)
      : tau(isotropic.tau), a(isotropic.in_full()) {}

  KOKKOS_INLINE_FUNCTION static FullTangent of_volume(double modulus) {
    return IsotropicTangent::of_volume(modulus);
  }
  KOKKOS_INLINE_FUNCTION Tensor4 in_full() const { return a; }
};

}  // namespace stroma::material
