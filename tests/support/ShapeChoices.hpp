// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Every choice of shape functions, for tests that must hold for all of them.

#include <string>
#include <vector>

#include "support/Specimen.hpp"

namespace stroma::test {

/// One choice of shape functions, and of the domains that it averages over.
struct ShapeChoice {
  shape::ShapeFunctions shape_functions;
  mechanics::ParticleDomain particle_domain;
  std::string name;

  void apply_to(Specimen& specimen) const {
    specimen.shape_functions = shape_functions;
    specimen.particle_domain = particle_domain;
  }
};

inline std::vector<ShapeChoice> shape_choices() {
  using mechanics::ParticleDomain;
  using shape::ShapeFunctions;
  return {{ShapeFunctions::linear, ParticleDomain::stretched, "Linear"},
          {ShapeFunctions::gimp, ParticleDomain::stretched, "GIMP"},
          {ShapeFunctions::gimp, ParticleDomain::undeformed, "GIMP_Undeformed"},
          {ShapeFunctions::cpdi, ParticleDomain::stretched, "CPDI"},
          {ShapeFunctions::cpdi, ParticleDomain::undeformed, "CPDI_Undeformed"},
          {ShapeFunctions::quadratic_b_spline, ParticleDomain::stretched, "Quadratic_B_Spline"},
          {ShapeFunctions::cubic_b_spline, ParticleDomain::stretched, "Cubic_B_Spline"}};
}

/// Those that a particle can cross elements with and converge: smooth, on domains that stay side by
/// side.
inline std::vector<ShapeChoice> smooth_choices() {
  std::vector<ShapeChoice> choices;
  for (const ShapeChoice& choice : shape_choices())
    if (choice.shape_functions != shape::ShapeFunctions::linear &&
        choice.particle_domain == mechanics::ParticleDomain::stretched)
      choices.push_back(choice);
  return choices;
}

}  // namespace stroma::test
