// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Shape functions that are products of functions of one coordinate each.

#include <Kokkos_Core.hpp>

#include "stroma/shape/Place.hpp"

namespace stroma::shape {

/// N_a(x) = product over the directions of N_(a_d)(x_d), a = ax + w (ay + w az).
///
/// \tparam Axis        width, knows_ends, has_domain, and evaluate(place, d, value, slope) with
///                     value(f) [-] and slope(f) = dN_f/dxi [-] of the functions along d
/// \tparam Dimensions  3; or 2 for plane strain, where nothing varies along z
template <class Axis, int Dimensions>
struct TensorProduct {
  static constexpr int width = Axis::width;
  static constexpr int dimensions = Dimensions;
  static constexpr int layers = Dimensions == 3 ? width : 1;
  static constexpr int nodes = width * width * layers;
  static constexpr bool knows_ends = Axis::knows_ends;
  static constexpr bool has_domain = Axis::has_domain;

  /// Values (a) [-] and gradients (j, a) = dN_a/dx_j [1/um].
  KOKKOS_INLINE_FUNCTION static void evaluate(const Place& place, double N[nodes],
                                              double gradient[3][nodes]) {
    double value[3][width], slope[3][width];
    for (int d = 0; d < Dimensions; ++d) {
      Axis::evaluate(place, d, value[d], slope[d]);
      for (int f = 0; f < width; ++f) slope[d][f] *= place.inverse_h[d];
    }
    if constexpr (Dimensions == 2) {
      value[2][0] = 1.0;
      slope[2][0] = 0.0;
    }
    for (int az = 0; az < layers; ++az)
      for (int ay = 0; ay < width; ++ay) {
        const double yz = value[1][ay] * value[2][az];
        const double dyz = slope[1][ay] * value[2][az];
        const double ydz = value[1][ay] * slope[2][az];
        for (int ax = 0; ax < width; ++ax) {
          const int a = ax + width * (ay + width * az);
          N[a] = value[0][ax] * yz;
          gradient[0][a] = slope[0][ax] * yz;
          gradient[1][a] = value[0][ax] * dyz;
          gradient[2][a] = value[0][ax] * ydz;
        }
      }
  }
};

}  // namespace stroma::shape
