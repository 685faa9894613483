// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the laws remember of a step that was accepted.

#include "stroma/transfer/MeanDilatation.hpp"

namespace stroma::transfer {

/// Replaces each particle's history by what its law makes of it at the displaced configuration
/// (Law::new_state). Fictitious points have none. Each particle is written by its own element
/// alone: nothing is atomic.
template <class Shape, class Law, class Device>
struct UpdateHistory {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const Law*, Device> law;  ///< (material)

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    const MeanDilatation mean = mean_dilatation(elements, i, j, k);
    LawAt<Law, Device> law_at(law, elements);
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      const double log_j = material::log_jacobian(point.H);
      double next[material::states_of<Law>] = {};
      law_at(point).new_state(
          point.H, log_j,
          mean.holds_for(point) ? log_mean_jacobian(elements, mean, point.p) : log_j, next);
      const auto numbers = static_cast<int>(elements.particles.history.extent(1));
      for (int n = 0; n < numbers; ++n) elements.particles.history(point.p, n) = next[n];
    });
  }
};

}  // namespace stroma::transfer
