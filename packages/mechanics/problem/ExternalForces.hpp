// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What acts on the body besides its supports.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/grid/Grid.hpp"
#include "stroma/mechanics/problem/BoundaryConditions.hpp"
#include "stroma/transfer/ExternalForce.hpp"

namespace stroma::mechanics {

/// One dead force, which keeps its direction and refers to the undeformed body. Exactly one of the
/// three is given. It grows with the load factor, or by a curve.
struct ExternalForce {
  std::optional<std::array<double, 3>> body_force;    ///< per volume [pN/um^3]
  std::optional<std::array<double, 3>> acceleration;  ///< per mass [m/s^2]
  std::optional<std::array<double, 3>> traction;      ///< per area of a face [Pa]
  std::optional<Face> face;                           ///< of the traction; a single face
  std::optional<std::string> load_curve;              ///< the deck's name of `curve`
  LoadCurve curve = {};                               ///< the factor of the force
};

using NamedForces = std::vector<std::pair<std::string, ExternalForce>>;

struct ExternalForcesParameters {
  NamedForces forces;
};

/// The forces as kernels want them, at full load. A traction acts at points of the face beside the
/// outermost layer of particles: t per area is t / s per volume, s the layer's thickness.
///
/// \param forces           the deck's, by name
/// \param body             the grid at load 0, which fills the body's box
/// \param outer_thickness  of the layers of particles next to the faces across each axis [um]
/// \throws std::logic_error  a traction on Face::all
std::vector<transfer::VolumeForce> volume_forces(const NamedForces& forces, const grid::Grid& body,
                                                 const std::array<double, 3>& outer_thickness);

}  // namespace stroma::mechanics
