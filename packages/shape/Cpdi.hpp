// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The convected particle domain interpolation's functions (CPDI).

#include "stroma/shape/BSpline.hpp"

namespace stroma::shape {

/// Hats, replaced in a particle's domain by what interpolates them between the domain's corners,
/// and averaged over it. The domain is a parallelepiped with the half edges r_k; its corners are
/// x_c = x + sum_k s_ck r_k, s_ck = +-1, and with d_k dual to r_k (d_k . r_l = delta_kl)
///
///     N_I = 1/C sum_c hat_I(x_c),   grad N_I = 1/C sum_c hat_I(x_c) sum_k s_ck d_k,   C = 2^dimensions.
///
/// Elements are centred at nodes and hats go on beyond the ends of the grid, as for GIMP; a domain
/// that reaches further than half an element along an axis is scaled down.
///
/// Source: Sadeghirad, Brannon, Burghardt, Int. J. Numer. Methods Engrg. 86 (2011) 1435;
/// docs/theory.md, eq. (5.3).
template <int Dimensions>
struct Cpdi {
  static constexpr int width = 3;
  static constexpr int dimensions = Dimensions;
  static constexpr int layers = Dimensions == 3 ? width : 1;
  static constexpr int nodes = width * width * layers;
  static constexpr bool knows_ends = true;
  static constexpr bool has_domain = true;

  KOKKOS_INLINE_FUNCTION static void evaluate(const Place& place, double N[nodes],
                                              double gradient[3][nodes]) {
    double r[3][3], dual[3][3];  // (half edge, direction) in elements; and its inverse
    half_edges(place, r);
    invert(r, dual);
    for (int a = 0; a < nodes; ++a) {
      N[a] = 0.0;
      for (int j = 0; j < 3; ++j) gradient[j][a] = 0.0;
    }
    constexpr int corners = 1 << Dimensions;
    for (int c = 0; c < corners; ++c) {
      double hat[3][width], weight[3] = {};
      for (int d = 0; d < Dimensions; ++d) {
        double x = place.xi[d] - 0.5;
        for (int k = 0; k < Dimensions; ++k) {
          const double sign = c >> k & 1 ? 1.0 : -1.0;
          x += sign * r[k][d];
          weight[d] += sign * dual[k][d] / corners;
        }
        BSplineAxis<1>::at(place, d, x, hat[d]);
      }
      if constexpr (Dimensions == 2) hat[2][0] = 1.0;
      for (int az = 0; az < layers; ++az)
        for (int ay = 0; ay < width; ++ay)
          for (int ax = 0; ax < width; ++ax) {
            const int a = ax + width * (ay + width * az);
            const double value = hat[0][ax] * hat[1][ay] * hat[2][az];
            N[a] += value / corners;
            for (int j = 0; j < Dimensions; ++j)
              gradient[j][a] += value * weight[j] * place.inverse_h[j];
          }
    }
  }

 private:
  KOKKOS_INLINE_FUNCTION static void half_edges(const Place& place, double r[3][3]) {
    double largest = 0.0;
    for (int d = 0; d < Dimensions; ++d) {
      double extent = 0.0;
      for (int k = 0; k < Dimensions; ++k) {
        r[k][d] = place.domain[d][k] * place.inverse_h[d];
        extent += r[k][d] < 0.0 ? -r[k][d] : r[k][d];
      }
      if (extent > largest) largest = extent;
    }
    if (!(largest > largest_half_domain)) return;
    for (int k = 0; k < Dimensions; ++k)
      for (int d = 0; d < Dimensions; ++d) r[k][d] *= largest_half_domain / largest;
  }

  /// dual(k, d) with sum_d dual(k, d) r(l, d) = delta_kl.
  KOKKOS_INLINE_FUNCTION static void invert(const double r[3][3], double dual[3][3]) {
    if constexpr (Dimensions == 2) {
      const double area = r[0][0] * r[1][1] - r[0][1] * r[1][0];
      dual[0][0] = r[1][1] / area;
      dual[0][1] = -r[1][0] / area;
      dual[1][0] = -r[0][1] / area;
      dual[1][1] = r[0][0] / area;
    } else {
      for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        for (int d = 0; d < 3; ++d)
          dual[k][d] =
              r[l][(d + 1) % 3] * r[m][(d + 2) % 3] - r[l][(d + 2) % 3] * r[m][(d + 1) % 3];
      }
      const double volume = r[0][0] * dual[0][0] + r[0][1] * dual[0][1] + r[0][2] * dual[0][2];
      for (int k = 0; k < 3; ++k)
        for (int d = 0; d < 3; ++d) dual[k][d] /= volume;
    }
  }
};

}  // namespace stroma::shape
