// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What fills a lumen or a bead, and presses on its wall.

#include "stroma/material/NeoHookean.hpp"

namespace stroma::material {

/// The Cauchy stress -s p I, with s the factor of the material's load curve, which follows the
/// deformation: the energy of a pressure, -s p (J - 1). A very soft neo-Hookean solid with a Poisson
/// ratio of 0 beside it keeps the grid in place, for within a body of one pressure no force acts on
/// a node. As a matrix law it is that solid; AnyLaw adds the pressure, whose factor it knows.
struct Pressure {
  double pressure;       ///< p [Pa], positive presses on the wall
  double shear_modulus;  ///< of the solid, mu [Pa], > 0

  static const char* name() { return "Pressure"; }
  static const char* meaning() {
    return "sigma = -p I by a Load Curve, which follows the deformation, and a soft neo-Hookean solid";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("Pressure [Pa]", &Pressure::pressure, Range::any(),
                      "Pressure p at a factor of 1; positive presses on the wall.");
    parameters.number("Shear Modulus [Pa]", &Pressure::shear_modulus, Range::positive(),
                      "Of what fills the label, with a Poisson ratio of 0: it keeps the grid in "
                      "place; 1e-4 of the wall's is little enough.");
  }

  using Tangent = IsotropicTangent;

  KOKKOS_INLINE_FUNCTION NeoHookean solid() const {
    return {shear_modulus, 2.0 / 3.0 * shear_modulus};
  }
  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const { return solid().small_strain(); }
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    return solid().energy_of_volume(log_j);
  }
  KOKKOS_INLINE_FUNCTION VolumetricStress stress_of_volume(double log_j) const {
    return solid().stress_of_volume(log_j);
  }
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return solid().energy(H, of_volume);
  }
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    return solid().kirchhoff_stress(H, log_j, volume);
  }
  KOKKOS_INLINE_FUNCTION IsotropicTangent tangent(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    return solid().tangent(H, log_j, volume);
  }
};

}  // namespace stroma::material
