// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The domains that particles stand for.

#include <Kokkos_Core.hpp>
#include <cstdint>

namespace stroma::transfer {

/// The domains of particles in the undeformed body: boxes centred at them. Where voxels are cut at
/// the faces of elements their sizes differ, but only from layer to layer along each axis, and a
/// particle's number tells its layers: id = i + layers[0] (j + layers[1] k).
template <class Device>
struct ParticleDomains {
  double half_edge[3] = {0.0, 0.0, 0.0};  ///< of every particle, unless they differ [um]
  std::int64_t layers[3] = {1, 1, 1};     ///< of particles along each axis, empty ones too
  /// (layer) half the edge across it, of the layers along x, then y, then z [um]; empty: all alike.
  Kokkos::View<const double*, Device> of_layer = {};

  /// Half the edges of the domain of particle p [um].
  KOKKOS_INLINE_FUNCTION void half_edges(const Kokkos::View<std::int64_t*, Device>& id, int p,
                                         double edges[3]) const {
    if (of_layer.extent(0) == 0) {
      for (int d = 0; d < 3; ++d) edges[d] = half_edge[d];
      return;
    }
    std::int64_t rest = id(p), first = 0;
    for (int d = 0; d < 3; ++d) {
      edges[d] = of_layer(first + rest % layers[d]);
      rest /= layers[d];
      first += layers[d];
    }
  }
};

}  // namespace stroma::transfer
