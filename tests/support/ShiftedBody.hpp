// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A body that does not sit on its lattice as it was seeded.

#include "stroma/particles/Migration.hpp"
#include "support/Specimen.hpp"

namespace stroma::test {

/// The specimen's particles, moved by a distance [um] against the specimen's lattice, on the grid
/// that covers them there. The box of the conditions is that grid's.
inline mechanics::MovingBody shifted_body(const base::Communicator& communicator,
                                          const Specimen& specimen,
                                          const std::array<double, 3>& distance) {
  auto particles = specimen.particles(communicator);
  particles::make_movable(communicator, particles);
  for (int p = 0; p < particles.count(); ++p)
    for (int d = 0; d < 3; ++d) particles.position(p, d) += distance[static_cast<std::size_t>(d)];
  mechanics::Problem problem = specimen.problem();
  const particles::ParticleExtent extent = particles::extent_of(communicator, particles);
  problem.body = particles::covering_grid(extent, specimen.grid());
  const auto partition = particles::balanced_partition(
      communicator,
      particles::covering_grid(extent, grid::grid_for(specimen.shape_functions, specimen.grid())),
      particles);
  particles = particles::migrate(communicator, partition, particles);
  return {communicator, partition, particles, problem};
}

}  // namespace stroma::test
