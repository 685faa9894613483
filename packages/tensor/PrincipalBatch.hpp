// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Principal values of eight symmetric tensors at once.

#include <algorithm>
#include <cmath>

#include "stroma/tensor/Tensor3.hpp"

namespace stroma::tensor {

/// Eight symmetric tensors; zeros at first.
struct SymmetricBatch {
  static constexpr int size = 8;
  double entry[6][size] = {};  ///< (xx yy zz xy yz zx) (tensor)

  void set(int n, const Tensor3& a) {
    const double values[6] = {a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(1, 2), a(2, 0)};
    for (int c = 0; c < 6; ++c) entry[c][n] = values[c];
  }
};

/// One rotation of all eight, which makes the entries o = a_pq vanish,
///
///     tan t = sign(d) 2 o / (|d| + sqrt(d^2 + 4 o^2)),   d = q - p.
///
/// Without branches, so that it becomes vector instructions where math functions set no errno.
///
/// \param p, q    entries a_pp, a_qq
/// \param o       entries a_pq
/// \param rp, rq  entries a_rp, a_rq of the third axis r
inline void rotate(double* p, double* q, double* o, double* rp, double* rq) {
  for (int n = 0; n < SymmetricBatch::size; ++n) {
    const double apart = q[n] - p[n], twice = apart < 0.0 ? -2.0 * o[n] : 2.0 * o[n];
    const double tangent =
        twice / (std::fabs(apart) + std::sqrt(apart * apart + twice * twice) + 1e-300);
    const double cosine = 1.0 / std::sqrt(tangent * tangent + 1.0), sine = tangent * cosine;
    p[n] -= tangent * o[n];
    q[n] += tangent * o[n];
    o[n] = 0.0;
    const double old = rp[n];
    rp[n] = cosine * old - sine * rq[n];
    rq[n] = sine * old + cosine * rq[n];
  }
}

/// The entries on the diagonal become the principal values, descending, by cyclic Jacobi rotations,
/// until no entry beside it counts in any of the tensors: an error of a few eps ||a||.
inline void find_principal_values(SymmetricBatch& batch) {
  constexpr int max_sweeps = 12;
  constexpr double eps = 2.220446049250313e-16;
  auto& a = batch.entry;
  double least[SymmetricBatch::size];  // that counts
  for (int n = 0; n < SymmetricBatch::size; ++n)
    least[n] = 0.1 * eps *
               std::sqrt(a[0][n] * a[0][n] + a[1][n] * a[1][n] + a[2][n] * a[2][n] +
                         2.0 * (a[3][n] * a[3][n] + a[4][n] * a[4][n] + a[5][n] * a[5][n]));
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    int open = 0;
    for (int n = 0; n < SymmetricBatch::size; ++n)
      open += std::fabs(a[3][n]) + std::fabs(a[4][n]) + std::fabs(a[5][n]) > least[n] ? 1 : 0;
    if (open == 0) break;
    rotate(a[0], a[1], a[3], a[5], a[4]);
    rotate(a[0], a[2], a[5], a[3], a[4]);
    rotate(a[1], a[2], a[4], a[3], a[5]);
  }
  for (const int i : {0, 1, 0})
    for (int n = 0; n < SymmetricBatch::size; ++n) {
      const double larger = std::max(a[i][n], a[i + 1][n]);
      a[i + 1][n] = std::min(a[i][n], a[i + 1][n]);
      a[i][n] = larger;
    }
}

}  // namespace stroma::tensor
