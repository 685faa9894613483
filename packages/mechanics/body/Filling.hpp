// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How full of particles the elements of a rank are.

#include "stroma/grid/Halo.hpp"
#include "stroma/grid/Partition.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/particles/Particles.hpp"
#include "stroma/transfer/ElementLoop.hpp"
#include "stroma/transfer/ParticleDomains.hpp"

namespace stroma::mechanics {

/// A rank's part of a grid as kernels see it.
transfer::ElementBox element_box(const grid::Partition& partition, int rank);

/// (local element) the volume that an element lacks to being full, between the ends of the grid
/// [um^3]; 0 where particles fill it by the share or more, and where none lies in it. Particles have
/// their volume at the base configuration. On grids whose elements are centred at nodes, their faces
/// cut domains of particles, and each element gets its part of them, by the boxes around the domains
/// as deformed; else a particle counts for the element that it lies in. Collective.
/// \param halo       of the grid
/// \param box        this rank's part of it
/// \param particles  in its elements
/// \param domains    of the particles, where elements are centred at nodes
/// \param share      of an element that is enough
Kokkos::View<double*, grid::Device> missing_volume(
    const grid::Halo& halo, const transfer::ElementBox& box,
    const particles::Particles<grid::Device>& particles,
    const transfer::ParticleDomains<grid::Device>& domains, double share);

}  // namespace stroma::mechanics
