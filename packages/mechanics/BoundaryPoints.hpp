// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The points of the body's faces by which conditions are imposed by penalty.

#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/mechanics/Problem.hpp"
#include "stroma/mechanics/Supports.hpp"
#include "stroma/particles/Particles.hpp"
#include "stroma/transfer/BoundaryPoints.hpp"

namespace stroma::mechanics {

/// The boundary points of all conditions imposed by penalty: one for each particle of the outermost
/// layer along the condition's face (of each face, for Face::all), straight out from it on the
/// face, with the spring
///
///     k = epsilon V0 / s,     epsilon = factor M / L       [pN/um]
///
/// s the thickness of that layer, L the body's length along its normal, and M the
/// largest K + 4/3 mu of the body's materials. Springs in series with the body lower a force by
/// 1 / factor at most, whatever the grid. Source: docs/theory.md, eq. (8.3). Collective.
///
/// \throws base::InputError when a face has no particle next to it, or when two conditions want
///         different displacements at the edge where their faces meet
transfer::BoundaryPointSet<grid::Device> boundary_points(
    const base::Communicator& communicator, const Problem& problem,
    const particles::Particles<grid::Device>& particles);

/// The largest modulus of a confined stretch, K + 4/3 mu, of the body's materials [Pa].
double stiffest_modulus(const Problem& problem);

/// The size of the diagonal entries that the springs bring to the tangent, epsilon times the face
/// of an element, the largest of all conditions [pN/um]; 0 without any.
double stiffest_springs(const Problem& problem);

/// The components that the points hold, as the statics of the pieces see them. The node numbers are
/// no nodes'. It refers to its arguments.
HeldComponents held_components(const transfer::BoundaryPointSet<grid::Device>& points,
                               const particles::Particles<grid::Device>& particles,
                               const Pieces& pieces);

}  // namespace stroma::mechanics
