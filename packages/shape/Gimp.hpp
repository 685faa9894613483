#pragma once

/// \file
/// The generalised interpolation material point method's functions (GIMP).

#include <cmath>

#include "shape/TensorProduct.hpp"

namespace stroma::shape {

/// Hats averaged over a particle's domain, a box of half edges l along the axes:
///
///     N_I(x) = 1/(2 l) integral over [x - l, x + l] of hat_I,   dN_I/dx = (hat_I(x + l) - hat_I(x
///     - l)) / (2 l).
///
/// Elements are centred at nodes (grid::Grid::centered), and see the node in the middle and its two
/// neighbours. l is that of the box with the same second moment along the axis as the particle's
/// domain, a parallelepiped of half edges r_k: l_d^2 = sum_k r_kd^2; at most half an element. A
/// turn leaves it as it is, and shear along one axis does not widen it along another.
///
/// Source: Bardenhagen, Kober, CMES 5 (2004) 477; docs/theory.md, eq. (T.34).
struct GimpAxis {
  static constexpr int width = 3;
  static constexpr bool knows_ends = false;
  static constexpr bool has_domain = true;

  KOKKOS_INLINE_FUNCTION static void evaluate(const Place& place, int d, double value[width],
                                              double slope[width]) {
    const auto& along = place.domain[d];
    const double edge = sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    const double wanted = edge * place.inverse_h[d];
    const double l = wanted > largest_half_domain ? largest_half_domain : wanted;
    for (int f = 0; f < width; ++f) {
      const double x = place.xi[d] - 0.5 - (f - 1);  // from the node, in elements
      value[f] = (hat_integral(x + l) - hat_integral(x - l)) / (2.0 * l);
      slope[f] = (hat(x + l) - hat(x - l)) / (2.0 * l);
    }
  }

  KOKKOS_INLINE_FUNCTION static double hat(double x) {
    const double distance = x < 0.0 ? -x : x;
    return distance < 1.0 ? 1.0 - distance : 0.0;
  }
  /// Of hat, from minus infinity to x.
  KOKKOS_INLINE_FUNCTION static double hat_integral(double x) {
    if (x <= -1.0) return 0.0;
    if (x >= 1.0) return 1.0;
    return x < 0.0 ? 0.5 * (1.0 + x) * (1.0 + x) : 1.0 - 0.5 * (1.0 - x) * (1.0 - x);
  }
};

template <int Dimensions>
using Gimp = TensorProduct<GimpAxis, Dimensions>;

}  // namespace stroma::shape
