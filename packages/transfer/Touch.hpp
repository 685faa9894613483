// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Which nodes the points of a body touch.

#include "stroma/transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// (element, word) Bit a % 64 of word a / 64: a particle of the element touches its node a.
template <class Device>
using TouchedNodes = Kokkos::View<std::uint64_t**, Kokkos::LayoutRight, Device>;

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
  TouchedNodes<Device> by_particles;  ///< written, of all elements; or empty: not wanted

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    constexpr int words = (Shape::nodes + 63) / 64;
    bool touches[Shape::nodes] = {};
    std::uint64_t particles_touch[words] = {};
    const auto look = [&](const ParticlePoint<Shape>& point) {
      if (point.p >= 0 && chosen.extent(0) != 0 && chosen(point.p) == 0) return;
      for (int a = 0; a < Shape::nodes; ++a) {
        double largest = fabs(point.value[a]);
        for (int d = 0; d < 3; ++d)
          largest = fmax(largest, fabs(point.gradient[d][a]) * elements.box.spacing[d]);
        if (!(largest > negligible)) continue;
        touches[a] = true;
        if (point.p >= 0) particles_touch[a / 64] |= std::uint64_t(1) << a % 64;
      }
    };
    if (with_fictitious_points)
      elements.for_each_point(i, j, k, bad, look);
    else
      elements.for_each_particle(i, j, k, bad, look);
    for (int a = 0; a < Shape::nodes; ++a)
      if (touches[a]) count(elements.node_of(i, j, k, a), 0) += 1.0;
    if (by_particles.extent(0) == 0) return;
    for (int w = 0; w < words; ++w)
      by_particles(elements.box.element(i, j, k), w) = particles_touch[w];
  }
};

}  // namespace stroma::transfer
