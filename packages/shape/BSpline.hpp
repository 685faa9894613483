// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// B-splines with open knots, averaged over the domains of particles.

#include <cmath>

#include "stroma/shape/TensorProduct.hpp"

namespace stroma::shape {

/// B-splines N_I of degree p on open knots, one at each node of the lattice, averaged over a
/// particle's domain, a box of half edges l along the axes:
///
///     N_I(x)  = 1/(2 l) integral over [x - l, x + l] of N_I,
///     dN_I/dx = 1/(2 l) (N_I(x + l) - N_I(x - l)).
///
/// Where domains lie side by side, the sum of these gradients over the particles is the integral of
/// the splines' gradients over the body, wherever the knots are: a uniform stress is in equilibrium
/// with its tractions, as it is not when splines are evaluated at points. Hats (p = 1) averaged
/// like this are the generalised interpolation material point method's functions (GIMP).
///
/// Elements are centred at the knots (grid::Grid::centered) and see the p + 2 functions of the two
/// spans beside it; l is at most half an element. There are no functions beyond the ends of the
/// grid: there, the polynomials of the last span go on, and at the last knot one function is 1 and
/// the others 0.
///
/// l is that of the box with the same second moment along the axis as the particle's domain, a
/// parallelepiped of half edges r_k: l_d^2 = sum_k r_kd^2. A turn leaves it as it is, and shear
/// along one axis does not widen it along another.
///
/// Source: Piegl, Tiller, The NURBS Book (1997), section 2.2; Bardenhagen, Kober, CMES 5 (2004)
/// 477; docs/theory.md, eq. (5.1), (5.2).
template <int Degree>
struct BSplineAxis {
  static constexpr int width = Degree + 2;
  static constexpr bool knows_ends = true;
  static constexpr bool has_domain = true;

  KOKKOS_INLINE_FUNCTION static void evaluate(const Place& place, int d, double value[width],
                                              double slope[width]) {
    const auto& along = place.domain[d];
    const double edge = sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    const double wanted = edge * place.inverse_h[d];
    const double l = wanted > largest_half_domain ? largest_half_domain : wanted;
    const double begin = place.xi[d] - 0.5 - l, end = place.xi[d] - 0.5 + l;
    double lower[width], upper[width];
    at(place, d, begin, lower);
    at(place, d, end, upper);
    for (int f = 0; f < width; ++f) {
      value[f] = 0.0;
      slope[f] = (upper[f] - lower[f]) / (end - begin);
    }
    add_mean(place, d, begin, end < 0.0 ? end : 0.0, end - begin, value);
    add_mean(place, d, begin > 0.0 ? begin : 0.0, end, end - begin, value);
  }

  /// The splines' values at a point x [elements from the knot in the middle of the element].
  KOKKOS_INLINE_FUNCTION static void at(const Place& place, int d, double x, double value[width]) {
    const int knot = place.element[d], spans = place.elements[d] - 1;
    int span = x < 0.0 ? knot - 1 : knot;
    span = span < 0 ? 0 : (span < spans ? span : spans - 1);
    double of_span[Degree + 1];
    polynomials(span, spans, x + (knot - span), of_span);
    const int first = span - (knot - 1);  // 0 or 1
    for (int f = 0; f < width; ++f) {
      const int n = f - first;
      value[f] = n >= 0 && n <= Degree ? of_span[n] : 0.0;
    }
  }

 private:
  /// The Degree + 1 functions of a span at a distance s from its lower end, by the recurrence of
  /// Cox and de Boor; knots are clamp(i, 0, spans).
  KOKKOS_INLINE_FUNCTION static void polynomials(int span, int spans, double s,
                                                 double value[Degree + 1]) {
    const auto knot = [&](int i) {  // from the span's lower end
      return static_cast<double>((i < 0 ? 0 : (i > spans ? spans : i)) - span);
    };
    value[0] = 1.0;
    for (int degree = 1; degree <= Degree; ++degree) {
      double carried = 0.0;
      for (int f = 0; f < degree; ++f) {
        const double upper = knot(span + 1 + f), lower = knot(span + 1 + f - degree);
        const double part = value[f] / (upper - lower);
        value[f] = carried + (upper - s) * part;
        carried = (s - lower) * part;
      }
      value[degree] = carried;
    }
  }

  /// Adds 1/length times the integral over [from, to], which no knot divides, by Gauss's rule.
  KOKKOS_INLINE_FUNCTION static void add_mean(const Place& place, int d, double from, double to,
                                              double length, double value[width]) {
    if (!(to > from)) return;
    constexpr int points = Degree == 1 ? 1 : 2;
    constexpr double gauss = 0.57735026918962576;  // 1 / sqrt(3)
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    for (int q = 0; q < points; ++q) {
      double at_point[width];
      at(place, d, points == 1 ? middle : middle + (2 * q - 1) * gauss * half, at_point);
      for (int f = 0; f < width; ++f) value[f] += (to - from) / (points * length) * at_point[f];
    }
  }
  static_assert(Degree >= 1 && Degree <= 3, "two Gauss points integrate a cubic");
};

template <int Degree, int Dimensions>
using BSpline = TensorProduct<BSplineAxis<Degree>, Dimensions>;

/// The generalised interpolation material point method's functions.
template <int Dimensions>
using Gimp = BSpline<1, Dimensions>;

}  // namespace stroma::shape
