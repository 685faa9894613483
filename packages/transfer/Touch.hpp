#pragma once

/// \file
/// Which nodes the points of a body touch.

#include "transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// Adds 1 at each node of an element that one of its points touches: of the particles that are
/// chosen, and of the fictitious points. A node is touched where the function or its gradient, in
/// elements, is more than rounding can make of zero. Launch with for_each_element().
template <class Shape, class Device>
struct Touch {
  static constexpr double negligible = 1e-9;

  ElementParticles<Shape, Device> elements;
  Kokkos::View<const std::uint8_t*, Device> chosen;  ///< (particle) not 0: counts; empty: all do
  bool with_fictitious_points;
  Kokkos::View<double* [3], Kokkos::LayoutRight, Device> count;  ///< (touched node, 0), added to

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    bool touches[Shape::nodes] = {};
    const auto look = [&](const ParticlePoint<Shape>& point) {
      if (point.p >= 0 && chosen.extent(0) != 0 && chosen(point.p) == 0) return;
      for (int a = 0; a < Shape::nodes; ++a) {
        double largest = fabs(point.value[a]);
        for (int d = 0; d < 3; ++d)
          largest = fmax(largest, fabs(point.gradient[d][a]) * elements.box.spacing[d]);
        touches[a] = touches[a] || largest > negligible;
      }
    };
    if (with_fictitious_points)
      elements.for_each_point(i, j, k, bad, look);
    else
      elements.for_each_particle(i, j, k, bad, look);
    for (int a = 0; a < Shape::nodes; ++a)
      if (touches[a]) count(elements.node_of(i, j, k, a), 0) += 1.0;
  }
};

}  // namespace stroma::transfer
