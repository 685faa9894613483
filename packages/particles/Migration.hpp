// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles on the move: the grid that they fill, and their way to the owners of their elements.

#include <array>

#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Partition.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/particles/Fields.hpp"

namespace stroma::particles {

/// Numbers of a particle in a field that some rank's particles have; 0 where nobody's have it. A
/// rank without particles does not know. Collective.
template <class View>
std::size_t numbers_anywhere(const base::Communicator& communicator, const Field& field,
                             const View& view) {
  const bool has_it = field.presence == Presence::always || view.extent(0) > 0;
  return static_cast<std::size_t>(
      communicator.max(has_it ? static_cast<std::int64_t>(numbers_of(view)) : 0));
}

/// Makes room for all that moves: base displacement and gradient (zero), and home, which numbers
/// the particles of each rank as they stand now (Exchange.hpp).
void make_movable(const base::Communicator& communicator, Particles<grid::Device>& particles);

/// Between which places along each axis the particles of all ranks lie [um].
struct ParticleExtent {
  std::array<double, 3> lowest, highest;
};
/// Of the particles, x, or with a half edge r > 0 [um] of the boxes that they stand for, which
/// deform with them: x_d -+ sum over e of |F_de| r_e. Collective.
ParticleExtent extent_of(const base::Communicator& communicator,
                         const Particles<grid::Device>& particles,
                         const std::array<double, 3>& half_edge = {});

/// \throws base::RunError when particles are spread so far, over 64 times the elements of `body`,
///         that one must have got lost
void require_together(const ParticleExtent& extent, const grid::Grid& body);

/// For each axis, whether a grid's lower and upper end stay where they are.
using FixedEnds = std::array<std::array<bool, 2>, 3>;

/// The smallest box of elements of a lattice that holds particles of an extent. The lattice is that
/// of `body`, continued without end in each direction; so the grid follows the body wherever it
/// goes, but for ends that are fixed. A particle on the face between two elements belongs to the
/// upper one. Plane strain keeps its one layer; of elements that are centred at knots there are two
/// at least.
///
/// \throws base::RunError as require_together()
grid::Grid covering_grid(const ParticleExtent& extent, const grid::Grid& body,
                         const FixedEnds& fixed = {});

/// Boxes of elements with about equal numbers of particles. Collective.
/// \throws base::RunError when the grid has become too small for so many ranks
grid::Partition balanced_partition(const base::Communicator& communicator, const grid::Grid& grid,
                                   const Particles<grid::Device>& particles);

/// Sends each particle to the owner of its element and sorts them there by element, and by id
/// within an element, so that the order does not depend on the ranks. Collective.
///
/// \throws base::RunError when a particle was lost on the way
Particles<grid::Device> migrate(const base::Communicator& communicator,
                                const grid::Partition& partition,
                                const Particles<grid::Device>& particles);

}  // namespace stroma::particles
