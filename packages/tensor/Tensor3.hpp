// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// 3 x 3 tensors for kernels: a plain value type, its algebra, and forms that keep the digits of
/// small strains.

#include <Kokkos_Core.hpp>
#include <cmath>

namespace stroma::tensor {

/// A 3 x 3 tensor, t(i, j). Aggregate: Tensor3 H{{{a, b, c}, {d, e, f}, {g, h, i}}}; Tensor3{} is
/// zero.
struct Tensor3 {
  double value[3][3] = {};

  KOKKOS_FORCEINLINE_FUNCTION double& operator()(int i, int j) { return value[i][j]; }
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int i, int j) const { return value[i][j]; }
};

KOKKOS_FORCEINLINE_FUNCTION Tensor3 identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }

/// A symmetric tensor by xx, yy, zz, xy, yz, zx.
KOKKOS_FORCEINLINE_FUNCTION Tensor3 symmetric(const double s[6]) {
  return {{{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}}};
}

/// u x u.
KOKKOS_FORCEINLINE_FUNCTION Tensor3 square_of(const double u[3]) {
  Tensor3 square;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) square(i, j) = u[i] * u[j];
  return square;
}

KOKKOS_FORCEINLINE_FUNCTION Tensor3 operator+(const Tensor3& a, const Tensor3& b) {
  Tensor3 sum;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum(i, j) = a(i, j) + b(i, j);
  return sum;
}

KOKKOS_FORCEINLINE_FUNCTION Tensor3 operator*(double s, const Tensor3& a) {
  Tensor3 scaled;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) scaled(i, j) = s * a(i, j);
  return scaled;
}

KOKKOS_FORCEINLINE_FUNCTION Tensor3 operator-(const Tensor3& a, const Tensor3& b) {
  return a + (-1.0) * b;
}

/// Product (a b)_ij = a_ik b_kj.
KOKKOS_FORCEINLINE_FUNCTION Tensor3 operator*(const Tensor3& a, const Tensor3& b) {
  Tensor3 product;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) product(i, j) += a(i, k) * b(k, j);
  return product;
}

KOKKOS_FORCEINLINE_FUNCTION Tensor3 transpose(const Tensor3& a) {
  return {{{a(0, 0), a(1, 0), a(2, 0)}, {a(0, 1), a(1, 1), a(2, 1)}, {a(0, 2), a(1, 2), a(2, 2)}}};
}

KOKKOS_FORCEINLINE_FUNCTION double trace(const Tensor3& a) { return a(0, 0) + a(1, 1) + a(2, 2); }

/// a : b = a_ij b_ij.
KOKKOS_FORCEINLINE_FUNCTION double contract(const Tensor3& a, const Tensor3& b) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += a(i, j) * b(i, j);
  return sum;
}

/// Cofactor matrix, cof(a) = det(a) a^-T; row i is the cross product of the other two rows.
KOKKOS_FORCEINLINE_FUNCTION Tensor3 cofactor(const Tensor3& a) {
  Tensor3 c;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      c(i, j) = a(i1, j1) * a(i2, j2) - a(i1, j2) * a(i2, j1);
    }
  }
  return c;
}

KOKKOS_FORCEINLINE_FUNCTION double det(const Tensor3& a) {
  const Tensor3 c = cofactor(a);
  return a(0, 0) * c(0, 0) + a(0, 1) * c(0, 1) + a(0, 2) * c(0, 2);
}

/// a^-1; entries are not finite if det a = 0.
KOKKOS_FORCEINLINE_FUNCTION Tensor3 inverse(const Tensor3& a) {
  return (1.0 / det(a)) * transpose(cofactor(a));
}

/// Second principal invariant II(a) = ((tr a)^2 - tr(a a)) / 2: the sum of the principal minors.
KOKKOS_FORCEINLINE_FUNCTION double second_invariant(const Tensor3& a) { return trace(cofactor(a)); }

/// J - 1 = det(I + H) - 1 = tr H + II(H) + det H, without cancellation for small H.
KOKKOS_FORCEINLINE_FUNCTION double det_minus_one(const Tensor3& H) {
  return trace(H) + second_invariant(H) + det(H);
}

/// b - I = H + H^T + H H^T for F = I + H, without cancellation for small H.
KOKKOS_FORCEINLINE_FUNCTION Tensor3 left_cauchy_green_minus_identity(const Tensor3& H) {
  return H + transpose(H) + H * transpose(H);
}

/// Deviator a - tr(a)/3 I.
KOKKOS_FORCEINLINE_FUNCTION Tensor3 deviator(const Tensor3& a) {
  Tensor3 d = a;
  const double mean = trace(a) / 3.0;
  for (int i = 0; i < 3; ++i) d(i, i) -= mean;
  return d;
}

/// Von Mises stress sqrt(3/2 s : s), s the deviator of a symmetric stress; in the stress's unit.
KOKKOS_FORCEINLINE_FUNCTION double von_mises(const Tensor3& stress) {
  const Tensor3 s = deviator(stress);
  return sqrt(1.5 * contract(s, s));
}

}  // namespace stroma::tensor
