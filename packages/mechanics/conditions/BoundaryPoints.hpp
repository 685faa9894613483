// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The points of the body's faces by which conditions are imposed by penalty.

#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/mechanics/conditions/BodyStatics.hpp"
#include "stroma/mechanics/problem/Problem.hpp"
#include "stroma/particles/Particles.hpp"
#include "stroma/transfer/BoundaryPoints.hpp"

namespace stroma::mechanics {

/// Boundary points, and where on the faces of the undeformed body they lie.
struct BoundaryPoints {
  transfer::BoundaryPointSet<grid::Device> points;
  std::vector<std::array<double, 3>> X;  ///< (point) [um]

  /// Lets the points' springs pull to where conditions want them at a load factor, within a straight
  /// step on its line, or beyond that [um], if not empty.
  void set_load(const Problem& problem, double load, const StraightStep& step = {},
                const std::vector<std::array<double, 3>>& beyond = {});
  /// The points, to be written.
  Kokkos::View<transfer::BoundaryPoint*, grid::Device> writable;
};

/// The boundary points of all conditions imposed by penalty: one for each particle of the outermost
/// layer along the condition's face (of each face, for Face::all), straight out from it on the
/// face, with the spring
///
///     k = epsilon V0 / s      [pN/um]
///
/// s the thickness of that layer, epsilon that of Problem::spring_stiffness(). Stiff springs in
/// series with the body lower a force by 1 / factor at most, whatever the grid. Source:
/// docs/theory.md, eq. (8.3). Collective.
///
/// \throws base::InputError when a face has no particle next to it, or when two conditions want
///         different displacements at the edge where their faces meet
BoundaryPoints boundary_points(const base::Communicator& communicator, const Problem& problem,
                               const particles::Particles<grid::Device>& particles);

/// The size of the diagonal entries that the springs bring to the tangent, epsilon times the face
/// of an element, the largest of all conditions [pN/um]; 0 without any.
double stiffest_springs(const Problem& problem);

/// Visits the components that the points hold, as the statics of the pieces see them. The node
/// numbers are no nodes'.
void visit_held_components(const BoundaryPoints& boundary, const Problem& problem,
                           const particles::Particles<grid::Device>& particles,
                           const Pieces& pieces, const HeldVisitor& visit);

}  // namespace stroma::mechanics
