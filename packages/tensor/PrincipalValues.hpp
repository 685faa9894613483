// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Principal values and axes of a symmetric 3 x 3 tensor.

#include <Kokkos_Core.hpp>
#include <cmath>

#include "stroma/tensor/Tensor3.hpp"

namespace stroma::tensor {

/// Three principal values, descending.
struct PrincipalValues {
  double value[3] = {};

  KOKKOS_INLINE_FUNCTION double operator()(int i) const { return value[i]; }
};

/// Principal values and axes, in no order: a = sum_n value(n) axis_n x axis_n, axes(i, n) the
/// component i of the unit vector axis_n.
struct PrincipalAxes {
  double value[3] = {};
  Tensor3 axes;
};

/// Principal values and axes of a symmetric tensor a, the values in a's unit; only the diagonal and
/// the entries above it are read.
///
/// Cyclic Jacobi rotations: each turns the plane (p, q) by the angle that makes a_pq zero,
///
///     tan t = sign(d) / (|d| + sqrt(d^2 + 1)),   d = (a_qq - a_pp) / (2 a_pq),
///
/// until no entry beside the diagonal counts. The error is a few eps ||a||, whether values are
/// repeated or not, where the closed formula with an arccosine loses half the digits. Entries that
/// are not finite give values that are not finite.
///
/// Source: Golub & Van Loan (2013), Matrix Computations, section 8.5.
KOKKOS_INLINE_FUNCTION PrincipalAxes principal_axes(Tensor3 a) {
  constexpr int max_sweeps = 12;  // convergence is quadratic; 4 or 5 sweeps are the rule
  constexpr double eps = 2.220446049250313e-16;
  const double size = sqrt(a(0, 0) * a(0, 0) + a(1, 1) * a(1, 1) + a(2, 2) * a(2, 2) +
                           2.0 * (a(0, 1) * a(0, 1) + a(0, 2) * a(0, 2) + a(1, 2) * a(1, 2)));
  Tensor3 axes = identity();
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    const double beside = fabs(a(0, 1)) + fabs(a(0, 2)) + fabs(a(1, 2));
    if (beside <= 0.1 * eps * size) break;  // a NaN goes on and spreads
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (a(p, q) == 0.0) continue;
        const int r = 3 - p - q;
        const double d = (a(q, q) - a(p, p)) / (2.0 * a(p, q));
        const double tangent = (d < 0.0 ? -1.0 : 1.0) / (fabs(d) + sqrt(d * d + 1.0));
        const double cosine = 1.0 / sqrt(tangent * tangent + 1.0);
        const double sine = tangent * cosine;

        a(p, p) -= tangent * a(p, q);
        a(q, q) += tangent * a(p, q);
        a(p, q) = 0.0;
        const auto turn = [=](double& of_p, double& of_q) {
          const double old_p = of_p;
          of_p = cosine * old_p - sine * of_q;
          of_q = sine * old_p + cosine * of_q;
        };
        turn((p < r) ? a(p, r) : a(r, p), (q < r) ? a(q, r) : a(r, q));
        for (int i = 0; i < 3; ++i) turn(axes(i, p), axes(i, q));
      }
    }
  }
  return {{a(0, 0), a(1, 1), a(2, 2)}, axes};
}

/// Principal values in descending order.
KOKKOS_INLINE_FUNCTION PrincipalValues principal_values(const Tensor3& a) {
  const PrincipalAxes found = principal_axes(a);
  PrincipalValues values{{found.value[0], found.value[1], found.value[2]}};
  for (const int i : {0, 1, 0}) {
    if (values.value[i] < values.value[i + 1]) {
      const double larger = values.value[i + 1];
      values.value[i + 1] = values.value[i];
      values.value[i] = larger;
    }
  }
  return values;
}

}  // namespace stroma::tensor
