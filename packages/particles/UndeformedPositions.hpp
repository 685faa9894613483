// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Where the particles were in the undeformed body.

#include <array>
#include <vector>

#include "stroma/grid/Types.hpp"
#include "stroma/particles/Particles.hpp"

namespace stroma::particles {

/// X of each particle of the rank [um], on the host (Particles::undeformed_position).
inline std::vector<std::array<double, 3>> undeformed_positions(
    const Particles<grid::Device>& particles) {
  const auto position =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.position);
  const auto moved =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.base_displacement);
  const bool has_moved = particles.base_gradient.extent(0) != 0;
  std::vector<std::array<double, 3>> X(static_cast<std::size_t>(particles.count()));
  for (int p = 0; p < particles.count(); ++p)
    for (int d = 0; d < 3; ++d)
      X[static_cast<std::size_t>(p)][static_cast<std::size_t>(d)] =
          position(p, d) - (has_moved ? moved(p, d) : 0.0);
  return X;
}

}  // namespace stroma::particles
