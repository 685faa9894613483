// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The memory that a run takes, from counts alone: before anything of its size is allocated.

#include <array>
#include <cstdint>

#include "run/Deck.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Grid.hpp"

namespace stroma {

/// What there is on a rank. Real numbers: a deck may ask for more than integers hold.
struct Counts {
  double voxels;     ///< of its share of the image
  double particles;  ///< in its elements
  double nodes;      ///< that its elements touch
  double layers;     ///< of its elements along z
  double measured;   ///< numbers of images of displacements and velocities that it keeps
};

/// Bytes on a rank. The image is done with when particles are made, and they are when the balance
/// of momentum is, whose matrix has gone when tables are made, so that a run takes the most of the
/// four (docs/performance.md, "Memory").
struct MemoryEstimate {
  double image;           ///< intensities and labels
  double seeding;         ///< labels and particles, while they are sorted into their elements
  double particles;       ///< their state while steps are solved
  double results;         ///< what is evaluated at the particles to be written
  double tangent;         ///< the matrix
  double vectors;         ///< of unknowns
  double preconditioner;  ///< but for the factors of Direct
  double measured;        ///< what is kept of images of displacements and velocities

  double tables;  ///< of the last step, when tangent and preconditioner are gone

  double solving() const {
    return particles + measured + results + tangent + vectors + preconditioner;
  }
  double bytes() const;
};

/// What tables may take [bytes]: about what a solver needs the least of and has given back, the
/// stencil and its coarser levels.
/// \param nodes  that this rank's elements touch
inline double room_for_tables(double nodes) { return 650.0 * nodes; }

MemoryEstimate estimate_memory(const DeckParameters& parameters, const Counts& counts);

/// Numbers of images of displacements and velocities that a rank keeps (run/MeasuredFields.hpp), if
/// they have the specimen's voxels; of velocities an even share.
double measured_numbers(const DeckParameters& parameters, const std::array<std::int64_t, 3>& voxels,
                        const grid::Grid& body, int ranks);

/// The counts of an even share of the ranks.
/// \param voxels  of the image or its region
/// \param body    the grid over it
/// \param filled  fraction of the voxels that are not empty
Counts even_counts(const DeckParameters& parameters, const std::array<std::int64_t, 3>& voxels,
                   const grid::Grid& body, double filled, int ranks);

/// Refuses a run that the machine has too little memory for. Collective.
/// \throws base::InputError naming what there is too much of, what there is, and what to change
void require_memory(const base::Communicator& communicator, const DeckParameters& parameters,
                    const std::array<std::int64_t, 3>& voxels, const grid::Grid& body,
                    double filled);

}  // namespace stroma
