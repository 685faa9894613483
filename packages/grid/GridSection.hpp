// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Grid", and the grid it describes over the body's box.

#include <array>
#include <optional>
#include <string>

#include "stroma/deck/Section.hpp"
#include "stroma/grid/Grid.hpp"

namespace stroma::grid {

enum class ShapeFunctions { linear, gimp, cpdi, quadratic_b_spline, cubic_b_spline };
/// The domain of a particle over which GIMP averages the hats: as seeded, or stretched by F.
enum class ParticleDomain { stretched, undeformed };
/// Whether the volume change of particles is their own or their element's (against locking);
/// automatic: as the shape functions and the materials need it, see dilatation().
enum class Dilatation { automatic, pointwise, element_mean };
enum class DeformationGradient { incremental, projected_displacement };

struct GridParameters {
  std::optional<std::array<double, 3>> element_size;  ///< [um], > 0
  std::optional<std::array<int, 3>> elements;         ///< instead of the size
  bool reset = false;
  ShapeFunctions shape_functions = ShapeFunctions::linear;
  ParticleDomain particle_domain = ParticleDomain::stretched;
  Dilatation dilatation = Dilatation::automatic;
  DeformationGradient deformation_gradient = DeformationGradient::incremental;
  std::optional<double> stabilization;  ///< of the fictitious material [-], >= 0
  bool plane_strain = false;
};

deck::Section<GridParameters> grid_section();

/// Stiffness of the fictitious material [-]: as given, else 0.01 with reset and 2e-5 without.
double stabilization(const GridParameters& parameters);

/// From this Poisson ratio on, hats, GIMP and CPDI lock noticeably without a mean dilatation.
constexpr double locking_poisson_ratio = 0.45;

/// The dilatation of a run: as given; for Automatic, Element Mean where shape functions lock and a
/// Poisson ratio is above 0.45, else Pointwise. The paper's projected displacement knows no mean.
Dilatation dilatation(const GridParameters& parameters, double largest_poisson_ratio);

/// The name of a run's dilatation, and why Automatic chose it.
std::string describe_dilatation(const GridParameters& parameters, double largest_poisson_ratio);

/// What to do about a run that locks; empty for one that does not.
std::string locking_note(const GridParameters& parameters, double largest_poisson_ratio);

/// The grid that fills the body's box.
///
/// \param parameters  the deck's
/// \param length      edges of the box [um], > 0
/// \throws base::InputError when the element size does not divide the box (to 1e-6 of an element);
///         when plane strain meets more than one element through z; the message names the nearest
///         sizes that fit
Grid make_grid(const GridParameters& parameters, const std::array<double, 3>& length);

}  // namespace stroma::grid
