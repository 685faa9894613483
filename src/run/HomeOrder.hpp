// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Results in the order in which particles were seeded, wherever they have moved.

#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/particles/Particles.hpp"
#include "stroma/transfer/GridToParticles.hpp"

namespace stroma {

/// The fields of particles that have moved across the grid, sent back to the ranks that seeded
/// them and put into the order of seeding (particles::home_of). Particles that never move have no
/// homes; their fields are returned as they are. Collective.
///
/// \param count  particles that this rank seeded
transfer::ParticleFields<grid::Device> in_home_order(
    const base::Communicator& communicator, const particles::Particles<grid::Device>& particles,
    const transfer::ParticleFields<grid::Device>& fields, int count);

}  // namespace stroma
