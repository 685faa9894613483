// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Grid to particles: the displaced configuration becomes the base of the next step.

#include "stroma/transfer/MeanDilatation.hpp"

namespace stroma::transfer {

/// Moves the particles with their nodes, from the base configuration to the displaced one:
///
///     x_p += sum_I N_I U_I,   u_p += sum_I N_I U_I,   H_p = H_base + (f - I) + (f - I) H_base.
///
/// the latter with the element's mean dilatation where that is asked for.
/// Each particle is written by its own element alone: nothing is atomic. Source: docs/theory.md,
/// eq. (2.7); the paper's equations 10, 11.
template <class Shape, class Device>
struct Advance {
  ElementParticles<Shape, Device> elements;
  particles::Particles<Device> moved;  ///< position, base displacement and gradient are written

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    double u[3][Shape::nodes];
    elements.gather(elements.displacement, i, j, k, u);
    const auto& before = elements.particles;
    const MeanDilatation mean = mean_dilatation(elements, i, j, k);
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      const int p = point.p;
      const Tensor3 H = with_mean_dilatation(elements, mean, point);
      for (int c = 0; c < 3; ++c) {
        double change = 0.0;
        for (int a = 0; a < Shape::nodes; ++a) change += point.value[a] * u[c][a];
        moved.position(p, c) = before.position(p, c) + change;
        moved.base_displacement(p, c) =
            change +
            (before.base_displacement.extent(0) != 0 ? before.base_displacement(p, c) : 0.0);
        for (int d = 0; d < 3; ++d) moved.base_gradient(p, c, d) = H(c, d);
      }
    });
  }
};

}  // namespace stroma::transfer
