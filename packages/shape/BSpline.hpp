#pragma once

/// \file
/// B-splines with open knots.

#include "shape/TensorProduct.hpp"

namespace stroma::shape {

/// B-splines of a degree p on the knots t_i = clamp(i, 0, elements), by the recurrence of Cox and
/// de Boor. Element e sees p + 1 of them. They are p - 1 times continuously differentiable, so that
/// gradients do not jump where a particle enters another element; at both ends of the grid one
/// function is 1 and the others are 0, so that a face condition holds along the whole face.
///
/// Source: Piegl, Tiller, The NURBS Book (1997), section 2.2; docs/theory.md, eq. (T.33).
template <int Degree>
struct BSplineAxis {
  static constexpr int width = Degree + 1;
  static constexpr bool knows_ends = true;
  static constexpr bool has_domain = false;

  KOKKOS_INLINE_FUNCTION static void evaluate(const Place& place, int d, double value[width],
                                              double slope[width]) {
    const int e = place.element[d], n = place.elements[d];
    const auto knot = [&](int i) {  // from the element's lower end
      return static_cast<double>((i < 0 ? 0 : (i > n ? n : i)) - e);
    };
    double below[Degree];  // the functions of degree p - 1
    value[0] = 1.0;
    for (int degree = 1; degree <= Degree; ++degree) {
      if (degree == Degree)
        for (int f = 0; f < Degree; ++f) below[f] = value[f];
      double carried = 0.0;
      for (int f = 0; f < degree; ++f) {
        const double upper = knot(e + 1 + f), lower = knot(e + 1 + f - degree);
        const double part = value[f] / (upper - lower);
        value[f] = carried + (upper - place.xi[d]) * part;
        carried = (place.xi[d] - lower) * part;
      }
      value[degree] = carried;
    }
    double last = 0.0;
    for (int f = 0; f < Degree; ++f) {
      const double part = Degree * below[f] / (knot(e + 1 + f) - knot(e + 1 + f - Degree));
      slope[f] = last - part;
      last = part;
    }
    slope[Degree] = last;
  }
};

template <int Degree, int Dimensions>
using BSpline = TensorProduct<BSplineAxis<Degree>, Dimensions>;

}  // namespace stroma::shape
