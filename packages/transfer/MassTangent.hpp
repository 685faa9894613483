// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles to grid: the consistent mass matrix.

#include "stroma/transfer/Tangent.hpp"

namespace stroma::transfer {

/// Adds the consistent mass of each element's particles to the rows of its nodes:
///
///     M_IcJc = s sum_p rho V0 N_I N_J       for each component c
///
/// with s what makes a tangent of it. Launch with for_each_element(). Source: docs/theory.md, eq.
/// (11.2).
template <class Shape, class Device, class Rows>
struct MassTangent {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const double*, Device> density;  ///< (material) s rho
  Rows rows;

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    using Blocks = ElementBlocks<Shape, Rows>;
    using Real = typename Blocks::Real;
    const int element = elements.box.element(i, j, k);
    const auto& begin = elements.particles.element_begin;
    if (begin(element) == begin(element + 1)) return;
    Blocks blocks;
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      const double mass = point.volume * density(point.material);
      for (int a = 0; a < Shape::nodes; ++a)
        for (int b = 0; b < Shape::nodes; ++b) {
          const Real m = static_cast<Real>(mass * point.value[a] * point.value[b]);
          for (int c = 0; c < 3; ++c) blocks.K[a][c][c][b] += m;
        }
    });
    blocks.add_to(rows, elements, i, j, k);
  }
};

}  // namespace stroma::transfer
