// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a user says of the grid and of the method on it, and what follows.

#include <array>
#include <optional>
#include <string>

#include "stroma/grid/Grid.hpp"
#include "stroma/material/Material.hpp"
#include "stroma/mechanics/problem/Method.hpp"

namespace stroma::mechanics {

/// A dilatation, or that of method_of().
enum class DilatationChoice { automatic, pointwise, element_mean };

struct GridParameters {
  std::optional<std::array<double, 3>> element_size;  ///< [um], > 0
  std::optional<std::array<int, 3>> elements;         ///< instead of the size
  bool reset = false;
  shape::ShapeFunctions shape_functions = shape::ShapeFunctions::linear;
  ParticleDomain particle_domain = ParticleDomain::stretched;
  DilatationChoice dilatation = DilatationChoice::automatic;
  DeformationGradient deformation_gradient = DeformationGradient::incremental;
  std::optional<double> stabilization;  ///< of the fictitious material [-], >= 0
  bool plane_strain = false;
};

/// The method that was asked for. A stabilization that is not given is 0.01 with reset and 2e-5
/// without. The automatic dilatation is the element's mean where shape functions lock and a Poisson
/// ratio is above 0.45, else the particle's own; the paper's projected displacement knows no mean.
///
/// \param parameters  the user's
/// \param of_volume   how the materials resist a change of volume
Method method_of(const GridParameters& parameters, const material::Compressibility& of_volume);

/// From this Poisson ratio on, hats, GIMP and CPDI lock noticeably without a mean dilatation.
constexpr double locking_poisson_ratio = 0.45;

/// The name of a run's dilatation, and why it was chosen.
std::string describe_dilatation(const GridParameters& parameters,
                                const material::Compressibility& of_volume);

/// What to do about a run that locks; empty for one that does not.
std::string locking_note(const GridParameters& parameters,
                         const material::Compressibility& of_volume);

/// The grid that fills the body's box.
///
/// \param parameters  the deck's
/// \param length      edges of the box [um], > 0
/// \throws base::InputError when the element size does not divide the box (to 1e-6 of an element);
///         when plane strain meets more than one element through z; the message names the nearest
///         sizes that fit
grid::Grid make_grid(const GridParameters& parameters, const std::array<double, 3>& length);

}  // namespace stroma::mechanics
