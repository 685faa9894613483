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

  KOKKOS_FORCEINLINE_FUNCTION double& operator()(int i, int j, int k, int l) {
    return value[i][j][k][l];
  }
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int i, int j, int k, int l) const {
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
  KOKKOS_FORCEINLINE_FUNCTION static IsotropicTangent of_volume(double modulus) {
    return {{}, {}, modulus, 0.0};
  }

  /// a_ijkl in full.
  KOKKOS_FORCEINLINE_FUNCTION Tensor4 in_full() const {
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

/// A tensor of fourth order with both minor symmetries and the major one, c_ijkl = c_jikl = c_klij: 21
/// numbers, kept as a matrix whose rows fill a vector of the processor. Pairs of subscripts are
/// counted xx, yy, zz, xy, yz, zx.
struct Elasticity {
  static constexpr int pairs = 6, padded = 8;

  double value[pairs][padded] = {};  ///< (pair, pair)

  KOKKOS_FORCEINLINE_FUNCTION static constexpr int first(int pair) {
    return pair < 3 ? pair : pair - 3;
  }
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int second(int pair) {
    return pair < 3 ? pair : pair == 5 ? 0 : pair - 2;
  }
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int pair(int i, int j) {
    return i == j ? i : i + j == 1 ? 3 : i + j == 3 ? 4 : 5;
  }
  /// c_ijkl of pair(i, j) and pair(k, l).
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int ij, int kl) const { return value[ij][kl]; }

  /// f A x A, of a symmetric A.
  KOKKOS_FORCEINLINE_FUNCTION void add_dyad(double f, const Tensor3& A) {
    const Row a(A);
    for (int ij = 0; ij < pairs; ++ij)
      for (int kl = 0; kl < padded; ++kl) value[ij][kl] += f * a[ij] * a[kl];
  }
  /// f (A x B + B x A), of symmetric A and B.
  KOKKOS_FORCEINLINE_FUNCTION void add_dyads(double f, const Tensor3& A, const Tensor3& B) {
    const Row a(A), b(B);
    for (int ij = 0; ij < pairs; ++ij)
      for (int kl = 0; kl < padded; ++kl) value[ij][kl] += f * a[ij] * b[kl] + f * b[ij] * a[kl];
  }
  /// f A (.) A, (A (.) A)_ijkl = (A_ik A_jl + A_il A_jk) / 2, of a symmetric A.
  KOKKOS_FORCEINLINE_FUNCTION void add_square(double f, const Tensor3& A) {
    double by_first[3][padded] = {},
           by_second[3][padded] = {};  // A_ik and A_il of each pair (k, l)
    for (int i = 0; i < 3; ++i)
      for (int kl = 0; kl < pairs; ++kl) {
        by_first[i][kl] = A(i, first(kl));
        by_second[i][kl] = 0.5 * f * A(i, second(kl));
      }
    for (int ij = 0; ij < pairs; ++ij)
      for (int kl = 0; kl < padded; ++kl)
        value[ij][kl] += by_first[first(ij)][kl] * by_second[second(ij)][kl] +
                         by_second[first(ij)][kl] * by_first[second(ij)][kl];
  }
  /// vol I x I + 2 sym I4 - 2/3 (s x I + I x s): IsotropicTangent without its geometric part.
  KOKKOS_FORCEINLINE_FUNCTION void add_isotropic(double volumetric, double symmetric,
                                                 const Tensor3& s) {
    const Row b(s);
    constexpr double one[padded] = {1.0, 1.0, 1.0};
    for (int ij = 0; ij < pairs; ++ij)
      for (int kl = 0; kl < padded; ++kl)
        value[ij][kl] +=
            (volumetric * one[ij] - 2.0 / 3.0 * b[ij]) * one[kl] - 2.0 / 3.0 * one[ij] * b[kl];
    for (int ij = 0; ij < pairs; ++ij) value[ij][ij] += ij < 3 ? 2.0 * symmetric : symmetric;
  }
  KOKKOS_FORCEINLINE_FUNCTION void scale(double f) {
    for (auto& row : value)
      for (double& number : row) number *= f;
  }

 private:
  /// The six numbers of a symmetric tensor, and zeros.
  struct Row {
    double number[padded] = {};

    KOKKOS_FORCEINLINE_FUNCTION explicit Row(const Tensor3& A) {
      for (int ij = 0; ij < pairs; ++ij) number[ij] = A(first(ij), second(ij));
    }
    KOKKOS_FORCEINLINE_FUNCTION double operator[](int ij) const { return number[ij]; }
  };
};

/// Stress and spatial tangent of any law, all in [Pa]:
///
///     a_ijkl = c_ijkl + d_ik tau_jl.
struct FullTangent {
  Tensor3 tau;   ///< Kirchhoff stress
  Elasticity c;  ///< of the Kirchhoff stress, in space

  FullTangent() = default;
  KOKKOS_FORCEINLINE_FUNCTION FullTangent(const IsotropicTangent& isotropic) : tau(isotropic.tau) {
    c.add_isotropic(isotropic.volumetric, isotropic.symmetric, isotropic.s);
  }

  KOKKOS_FORCEINLINE_FUNCTION static FullTangent of_volume(double modulus) {
    return IsotropicTangent::of_volume(modulus);
  }
  /// a_ijkl in full.
  KOKKOS_FORCEINLINE_FUNCTION Tensor4 in_full() const {
    Tensor4 a;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            a(i, j, k, l) =
                c(Elasticity::pair(i, j), Elasticity::pair(k, l)) + (i == k) * tau(j, l);
    return a;
  }
};

}  // namespace stroma::material
