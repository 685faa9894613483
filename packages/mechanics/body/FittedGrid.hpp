// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The grid of a step: how its lattice lies under a body that has moved.

#include "stroma/base/Communicator.hpp"
#include "stroma/mechanics/problem/Problem.hpp"
#include "stroma/particles/Particles.hpp"

namespace stroma::mechanics {

/// The grid that a body is given when its grid is reset. Along each axis it has n elements of size
/// L/n between the body's ends, L apart, so that none is barely filled there. The number is that of
/// the step before while sizes stay within a quarter of the asked-for one, h/1.25 <= L/n <= 1.25 h;
/// else the nearest to L/h, but no more than in the undeformed body: more would have fewer particles
/// than integrate them, and are drawn out instead. The body ends
///
/// - at a face that nodes keep a plane (Problem::is_kept_plane): there;
/// - at another face: where the boxes end that its outermost particles stand for.
///
/// Faces with grips, all free ones of a body with inertia, and those whose Problem::outer_thickness
/// is not given are left out of that. Along an axis with such an end, nodes lie on the plane
/// opposite, if there is one, and elements have the asked-for size; without a plane the lattice is
/// that of the undeformed body, continued without end, of which the grid is the smallest part that
/// holds the particles. Collective.
///
/// \param communicator  of the ranks that share the body
/// \param problem       with the conditions, and the grid of the undeformed body
/// \param load          load factor of the configuration
/// \param last          the grid of the step before
/// \param particles     at the configuration
/// \throws base::RunError when two faces have met, or particles have got lost
grid::Grid fitted_grid(const base::Communicator& communicator, const Problem& problem, double load,
                       const grid::Grid& last, const particles::Particles<grid::Device>& particles);

}  // namespace stroma::mechanics
