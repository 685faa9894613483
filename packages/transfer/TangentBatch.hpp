// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A few points' parts of an element's tangent, collected and then summed together.

#include "stroma/material/Tangents.hpp"
#include "stroma/transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// Nodes whose entries one vector of the processor holds.
constexpr int lanes = 8;
/// Nodes of an element, filled up to whole vectors.
template <class Shape>
constexpr int padded_nodes = (Shape::nodes + lanes - 1) / lanes* lanes;

/// Collects points with their tangents and adds their blocks
///
///     K_ab(i,k) += V0 g_a,j a_ijkl g_b,l,      g = grad_x N,
///
/// to K(a, i, k, b) of an element, in the precision Real. One form for each kind of tangent.
template <class Shape, class Real, class Tangent>
struct TangentBatch;

/// The block of a point with an isotropic tangent is a sum of dyads of vectors,
///
///     K_ab = p_a (x) g_b + g_a (x) q_b + sym g_b (x) g_a + (g_a . t_b) I,
///     p = V0 (vol g - 2/3 s g),   q = -2/3 V0 s g,   t = V0 (sym g + tau g),   sym *= V0,
///
/// which takes 33 multiplications where the general contraction takes 54 and a table of 81 moduli.
template <class Shape, class Real>
struct TangentBatch<Shape, Real, material::IsotropicTangent> {
  static constexpr int n = Shape::nodes, padded = padded_nodes<Shape>;
  static constexpr int size = 8;

  int count = 0;
  // (point, component, node)
  Real g[size][3][padded], p[size][3][padded], q[size][3][padded], t[size][3][padded];
  Real symmetric[size];

  KOKKOS_FORCEINLINE_FUNCTION void add(const ParticlePoint<Shape>& point,
                                       const material::IsotropicTangent& a) {
    const int m = count++;
    const auto volume = static_cast<Real>(point.volume);
    const auto vol = static_cast<Real>(a.volumetric), sym = static_cast<Real>(a.symmetric);
    symmetric[m] = volume * sym;
    for (int c = 0; c < 3; ++c) {
      for (int b = 0; b < n; ++b) g[m][c][b] = static_cast<Real>(point.gradient[c][b]);
      for (int b = n; b < padded; ++b) g[m][c][b] = 0;
    }
    for (int c = 0; c < 3; ++c) {
      Real s[3], tau[3];
      for (int d = 0; d < 3; ++d) {
        s[d] = static_cast<Real>(-2.0 / 3.0 * a.s(c, d));
        tau[d] = static_cast<Real>(a.tau(c, d));
      }
      for (int b = 0; b < padded; ++b) {
        const Real sg = s[0] * g[m][0][b] + s[1] * g[m][1][b] + s[2] * g[m][2][b];
        const Real tau_g = tau[0] * g[m][0][b] + tau[1] * g[m][1][b] + tau[2] * g[m][2][b];
        p[m][c][b] = volume * (vol * g[m][c][b] + sg);
        q[m][c][b] = volume * sg;
        t[m][c][b] = volume * (sym * g[m][c][b] + tau_g);
      }
    }
  }

  /// K += the blocks of the particles collected, which are then forgotten.
  KOKKOS_INLINE_FUNCTION void add_blocks(Real (&K)[n][3][3][padded]) {
    for (int a = 0; a < n; ++a)
      for (int first = 0; first < padded; first += lanes) {
        Real sum[3][3][lanes];
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            for (int b = 0; b < lanes; ++b) sum[c][d][b] = K[a][c][d][first + b];
        for (int m = 0; m < count; ++m) {
          Real in_line[lanes];  // g_a . t_b
          for (int b = 0; b < lanes; ++b)
            in_line[b] = g[m][0][a] * t[m][0][first + b] + g[m][1][a] * t[m][1][first + b] +
                         g[m][2][a] * t[m][2][first + b];
          for (int c = 0; c < 3; ++c) {
            const Real pa = p[m][c][a], ga = g[m][c][a];
            for (int d = 0; d < 3; ++d) {
              const Real across = symmetric[m] * g[m][d][a];
              for (int b = 0; b < lanes; ++b)
                sum[c][d][b] +=
                    pa * g[m][d][first + b] + ga * q[m][d][first + b] + across * g[m][c][first + b];
            }
            for (int b = 0; b < lanes; ++b) sum[c][c][b] += in_line[b];
          }
        }
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            for (int b = 0; b < lanes; ++b) K[a][c][d][first + b] = sum[c][d][b];
      }
    count = 0;
  }
};

/// The general contraction, in two steps: B_b(ij, k) = V0 c_ijkl g_b,l and t_b = V0 tau g_b once a
/// point, which leaves 30 multiplications for a block,
///
///     K_ab(i, k) += g_a,j B_b(ij, k) + d_ik (g_a . t_b).
template <class Shape, class Real>
struct TangentBatch<Shape, Real, material::FullTangent> {
  static constexpr int n = Shape::nodes, padded = padded_nodes<Shape>;
  static constexpr int size = n <= lanes ? 8 : 2;  // within the cache nearest to the processor

  int count = 0;
  Real g[size][3][n];          // (point, j, node)
  Real t[size][3][padded];     // (point, j, node)
  Real B[size][6][3][padded];  // (point, ij, k, node)

  KOKKOS_FORCEINLINE_FUNCTION void add(const ParticlePoint<Shape>& point,
                                       const material::FullTangent& tangent) {
    using material::Elasticity;
    const int m = count++;
    Real gradient[3][padded];
    for (int c = 0; c < 3; ++c) {
      for (int b = 0; b < n; ++b) g[m][c][b] = static_cast<Real>(point.gradient[c][b]);
      for (int b = 0; b < padded; ++b)
        gradient[c][b] = b < n ? static_cast<Real>(point.volume * point.gradient[c][b]) : Real(0);
    }
    const auto product = [&](const Real(&x)[3], Real(&result)[padded]) {
      for (int b = 0; b < padded; ++b)
        result[b] = x[0] * gradient[0][b] + x[1] * gradient[1][b] + x[2] * gradient[2][b];
    };
    for (int j = 0; j < 3; ++j) {
      Real row[3];
      for (int l = 0; l < 3; ++l) row[l] = static_cast<Real>(tangent.tau(j, l));
      product(row, t[m][j]);
    }
    for (int ij = 0; ij < 6; ++ij)
      for (int k = 0; k < 3; ++k) {
        Real row[3];
        for (int l = 0; l < 3; ++l)
          row[l] = static_cast<Real>(tangent.c(ij, Elasticity::pair(k, l)));
        product(row, B[m][ij][k]);
      }
  }

  /// K += the blocks of the points collected, which are then forgotten.
  KOKKOS_INLINE_FUNCTION void add_blocks(Real (&K)[n][3][3][padded]) {
    using material::Elasticity;
    for (int a = 0; a < n; ++a)
      for (int first = 0; first < padded; first += lanes) {
        Real sum[3][3][lanes];
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < 3; ++k)
            for (int b = 0; b < lanes; ++b) sum[i][k][b] = K[a][i][k][first + b];
        for (int m = 0; m < count; ++m) {
          const Real x = g[m][0][a], y = g[m][1][a], z = g[m][2][a];
          Real in_line[lanes];  // g_a . t_b
          for (int b = 0; b < lanes; ++b)
            in_line[b] = x * t[m][0][first + b] + y * t[m][1][first + b] + z * t[m][2][first + b];
          for (int k = 0; k < 3; ++k) {
            const Real(&xx)[padded] = B[m][0][k], (&yy)[padded] = B[m][1][k],
                  (&zz)[padded] = B[m][2][k], (&xy)[padded] = B[m][3][k],
                  (&yz)[padded] = B[m][4][k], (&zx)[padded] = B[m][5][k];
            for (int b = 0; b < lanes; ++b)
              sum[0][k][b] += x * xx[first + b] + y * xy[first + b] + z * zx[first + b];
            for (int b = 0; b < lanes; ++b)
              sum[1][k][b] += x * xy[first + b] + y * yy[first + b] + z * yz[first + b];
            for (int b = 0; b < lanes; ++b)
              sum[2][k][b] += x * zx[first + b] + y * yz[first + b] + z * zz[first + b];
            for (int b = 0; b < lanes; ++b) sum[k][k][b] += in_line[b];
          }
        }
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < 3; ++k)
            for (int b = 0; b < lanes; ++b) K[a][i][k][first + b] = sum[i][k][b];
      }
    count = 0;
  }
};

}  // namespace stroma::transfer
