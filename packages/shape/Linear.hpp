// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Trilinear hat functions on a Cartesian element.

#include <Kokkos_Core.hpp>

#include "stroma/shape/Place.hpp"

namespace stroma::shape {

/// Trilinear hats: a particle's support is the eight nodes of its element. Local node
/// a = ax + 2 (ay + 2 az) with ax, ay, az in {0, 1}.
///
/// A shape function is a type with `width` (functions per direction that are not zero in an
/// element), `nodes` (their number; in plane strain of dimensions = 2 all lie in one layer),
/// whether it asks for the element's number or the point's domain, and evaluate(). Functions that a
/// particle does not touch get zeros, so that all particles of an element share one list of nodes,
/// and loops over it vectorise.
struct Linear {
  static constexpr int width = 2;
  static constexpr int dimensions = 3;
  static constexpr int nodes = 8;
  static constexpr bool knows_ends = false;
  static constexpr bool has_domain = false;

  /// Values and gradients of all nodes of the support.
  ///
  /// \param place     of the particle in its element
  /// \param N         values (a) [-]
  /// \param gradient  gradients (j, a) = dN_a/dx_j [1/um]; a runs fastest
  KOKKOS_FORCEINLINE_FUNCTION static void evaluate(const Place& place, double N[nodes],
                                                   double gradient[3][nodes]) {
    const auto& xi = place.xi;
    const auto& inverse_h = place.inverse_h;
    const double x[2] = {1.0 - xi[0], xi[0]};
    const double y[2] = {1.0 - xi[1], xi[1]};
    const double z[2] = {1.0 - xi[2], xi[2]};
    for (int a = 0; a < nodes; ++a) {
      const int ax = a & 1, ay = (a >> 1) & 1, az = a >> 2;
      N[a] = x[ax] * y[ay] * z[az];
      gradient[0][a] = (ax ? inverse_h[0] : -inverse_h[0]) * y[ay] * z[az];
      gradient[1][a] = (ay ? inverse_h[1] : -inverse_h[1]) * x[ax] * z[az];
      gradient[2][a] = (az ? inverse_h[2] : -inverse_h[2]) * x[ax] * y[ay];
    }
  }
};

}  // namespace stroma::shape
