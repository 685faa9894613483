#pragma once

/// \file
/// The deck section "Grid", and the grid it describes over the body's box.

#include <array>
#include <optional>
#include <string>

#include "deck/Section.hpp"
#include "grid/Grid.hpp"

namespace stroma::grid {

enum class ShapeFunctions { linear, gimp, cpdi, quadratic_b_spline, cubic_b_spline };
/// The domain of a particle over which GIMP averages the hats: as seeded, or stretched by F.
enum class ParticleDomain { stretched, undeformed };
/// Whether the volume change of particles is their own or their element's (against locking).
enum class Dilatation { pointwise, element_mean };
enum class DeformationGradient { incremental, projected_displacement };

struct GridParameters {
  std::optional<std::array<double, 3>> element_size;  ///< [um], > 0
  std::optional<std::array<int, 3>> elements;         ///< instead of the size
  bool reset = false;
  ShapeFunctions shape_functions = ShapeFunctions::linear;
  ParticleDomain particle_domain = ParticleDomain::stretched;
  Dilatation dilatation = Dilatation::pointwise;
  DeformationGradient deformation_gradient = DeformationGradient::incremental;
  std::optional<double> stabilization;  ///< of the fictitious material [-], >= 0
  bool plane_strain = false;
};

deck::Section<GridParameters> grid_section();

/// Stiffness of the fictitious material [-]: as given, else 0.01 with reset and 0 without.
double stabilization(const GridParameters& parameters);

/// The grid that fills the body's box.
///
/// \param length  edges of the box [um], > 0
/// \throws base::InputError when the element size does not divide the box (to 1e-6 of an element);
///         when plane strain meets more than one element through z; the message names the nearest
///         sizes that fit
Grid make_grid(const GridParameters& parameters, const std::array<double, 3>& length);

}  // namespace stroma::grid
