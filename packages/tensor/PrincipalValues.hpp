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

/// cos(acos(x) / 3) for x from 0 to 1: the root t from 0.86 to 1 of 4 t^3 - 3 t = x, by Newton's method
/// from a line that is within 0.005; its steps leave 3e-5, 2e-9, rounding.
KOKKOS_INLINE_FUNCTION double cosine_of_third(double x) {
  double t = 0.87 + 0.13 * x;
  for (int step = 0; step < 3; ++step) t = (8.0 * t * t * t + x) / (12.0 * t * t - 3.0);
  return t;
}

/// The unit vector that a symmetric tensor of rank two maps to zero: along the rows of its cofactors,
/// of which the longest has most digits.
KOKKOS_INLINE_FUNCTION void find_null_axis(const Tensor3& a, double (&n)[3]) {
  const Tensor3 rows = cofactor(a);
  double longest = -1.0;
  for (int r = 0; r < 3; ++r) {
    const double squared =
        rows(r, 0) * rows(r, 0) + rows(r, 1) * rows(r, 1) + rows(r, 2) * rows(r, 2);
    const bool is_longer = squared > longest;
    for (int i = 0; i < 3; ++i) n[i] = is_longer ? rows(r, i) : n[i];
    longest = is_longer ? squared : longest;
  }
  const double length = sqrt(longest);
  for (double& component : n) component /= length;
}

/// Principal values and axes of a symmetric tensor a, the values in a's unit; only the diagonal and
/// the entries above it are read.
///
/// Of its deviator s, the value farthest from the others,
///
///     eta = sign(J3) 2 sqrt(J2/3) cos(acos(|J3|/2 (3/J2)^(3/2)) / 3),   J2 = s:s/2,  J3 = det s,
///
/// and the axis n of it have the digits that the closed formulas of the others lose where these are
/// nearly equal. The others are those of the plane across n, which one rotation makes diagonal, by
///
///     tan t = sign(d) 2 s_uv / (|d| + sqrt(d^2 + 4 s_uv^2)),   d = s_vv - s_uu.
///
/// The error is a few eps ||a||, whether values are repeated or not. Entries that are not finite give
/// values that are not finite.
///
/// Source: Scherzinger & Dohrmann (2008), Comput Methods Appl Mech Eng 197:4007; u and v by Duff et
/// al. (2017), J Comput Graph Tech 6(1):1.
KOKKOS_INLINE_FUNCTION PrincipalAxes principal_axes(const Tensor3& a) {
  const double mean = (a(0, 0) + a(1, 1) + a(2, 2)) / 3.0;
  Tensor3 s;
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      s(i, j) = s(j, i) = a(i, j) - (i == j ? mean : 0.0);
      size += fabs(s(i, j));  // a NaN spreads
    }
  constexpr double nothing = 1e-300;
  if (size < nothing) return {{mean, mean, mean}, identity()};
  s = (1.0 / size) * s;

  const double j3 = det(s), root = sqrt(contract(s, s) / 6.0);
  const double cosine = fmin(fabs(j3) / (2.0 * root * root * root), 1.0);
  const double eta = copysign(2.0 * root * cosine_of_third(cosine), j3);
  double n[3] = {};
  find_null_axis(s - eta * identity(), n);

  const double sign = copysign(1.0, n[2]), f = -1.0 / (sign + n[2]);
  const double u[3] = {1.0 + sign * n[0] * n[0] * f, sign * n[0] * n[1] * f, -sign * n[0]};
  const double v[3] = {n[0] * n[1] * f, sign + n[1] * n[1] * f, -n[1]};
  double uu = 0.0, uv = 0.0, vv = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      uu += u[i] * s(i, j) * u[j];
      uv += u[i] * s(i, j) * v[j];
      vv += v[i] * s(i, j) * v[j];
    }
  const double apart = vv - uu, twice = copysign(2.0, apart) * uv;
  const double tangent = twice / (fabs(apart) + sqrt(apart * apart + twice * twice) + nothing);
  const double c = 1.0 / sqrt(tangent * tangent + 1.0), across = tangent * c;
  PrincipalAxes result{
      {mean + size * eta, mean + size * (uu - tangent * uv), mean + size * (vv + tangent * uv)},
      {}};
  for (int i = 0; i < 3; ++i) {
    result.axes(i, 0) = n[i];
    result.axes(i, 1) = c * u[i] - across * v[i];
    result.axes(i, 2) = across * u[i] + c * v[i];
  }
  return result;
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
