// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How full of particles the elements of a rank are.

#include "stroma/grid/Partition.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/particles/Particles.hpp"
#include "stroma/transfer/ElementLoop.hpp"

namespace stroma::mechanics {

/// A rank's part of a grid as kernels see it.
transfer::ElementBox element_box(const grid::Partition& partition, int rank);

/// (local element) the volume that an element lacks to being full, between the ends of the grid
/// [um^3]; 0 where particles fill it by a larger share, and where they do not touch it. Particles
/// have their volume at the base configuration.
Kokkos::View<double*, grid::Device> missing_volume(
    const transfer::ElementBox& box, const particles::Particles<grid::Device>& particles,
    double share = 0.5);

}  // namespace stroma::mechanics
