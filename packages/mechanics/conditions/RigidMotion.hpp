// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Finds the rigid motions that the boundary conditions leave free, and holds them.

#include <functional>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/mechanics/conditions/RigidModes.hpp"

namespace stroma::mechanics {

/// A set of components of this rank's nodes: calls the visitor for each. No list is ever stored.
using NodeComponents = std::function<void(const std::function<void(const NodeComponent&)>& visit)>;

/// The components to hold at zero so that no rigid motion is free: as many as there are free
/// motions, so that holding them costs no stress. Translations are held at the node next to the
/// body's centre, rotations at nodes straight along an axis from it (so that a body that shrinks
/// sideways stays upright), and elsewhere only if the body has no such nodes.
///
/// The six rigid motions are restricted to the prescribed components; the null space of their Gram
/// matrix (eigenvalues below 1e-10 of its trace) is what is free. Collective; every rank gets the
/// whole list, of at most six.
///
/// \param communicator  of the ranks that share the body
/// \param prescribed    components already prescribed on this rank
/// \param free          components of this rank's nodes that could be held
std::vector<NodeComponent> free_rigid_motions(const base::Communicator& communicator,
                                              const NodeComponents& prescribed,
                                              const NodeComponents& free);

}  // namespace stroma::mechanics
