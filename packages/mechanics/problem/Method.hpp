// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The variants of the Material Point Method.

#include "stroma/shape/ShapeFunctions.hpp"

namespace stroma::mechanics {

/// The domain of a particle over which GIMP averages the hats: as seeded, or stretched by F.
enum class ParticleDomain { stretched, undeformed };
/// Whether the volume change of particles is their own or their element's (against locking).
enum class Dilatation { pointwise, element_mean };
/// Each step's deformation on top of the one before, or the paper's equations 1 and 2.
enum class DeformationGradient { incremental, projected_displacement };

/// By which variant of the method a body is solved.
struct Method {
  bool reset = false;  ///< the grid returns to its lattice after each step
  shape::ShapeFunctions shape_functions = shape::ShapeFunctions::linear;
  ParticleDomain particle_domain = ParticleDomain::stretched;
  Dilatation dilatation = Dilatation::pointwise;
  DeformationGradient deformation_gradient = DeformationGradient::incremental;
  /// Stiffness of the fictitious material in elements that are filled by less than half, as a
  /// fraction of the real one's [-]; 0: none.
  double stabilization = 0.0;
  /// Springs of conditions imposed by penalty that have no factor of their own are soft, and pull on
  /// until faces are where conditions want them (Springs): what solver::solve_step() sees to. Else
  /// they are stiff, for whoever solves otherwise.
  bool springs_pull_on = false;
};

}  // namespace stroma::mechanics
