// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/ExternalForces.hpp"

#include <algorithm>
#include <cstddef>

namespace stroma::mechanics {

deck::Section<ExternalForcesParameters> external_forces_section() {
  deck::Section<ExternalForce> force("NAME", "One force; NAME is the user's.");
  force.optional("Body Force [pN/um^3]", &ExternalForce::body_force, deck::any(),
                 "Force per volume of the undeformed body at full load, x, y, z.");
  force.optional(
      "Acceleration [m/s^2]", &ExternalForce::acceleration, deck::any(),
      "Force per mass at full load, x, y, z, such as gravity's 0, -9.81, 0. Every material "
      "needs its Density [kg/m^3] then.");
  force.optional(
      "Traction [Pa]", &ExternalForce::traction, deck::any(),
      "Force per area of the undeformed Face at full load, x, y, z; it keeps its direction. "
      "It acts at the points of the face beside the outermost particles.");
  force.choice("Face", &ExternalForce::face,
               {{"x-", Face::x_lower},
                {"x+", Face::x_upper},
                {"y-", Face::y_lower},
                {"y+", Face::y_upper},
                {"z-", Face::z_lower},
                {"z+", Face::z_upper}},
               "The face of the body's box on which a Traction acts.");
  force.check([](const ExternalForce& p, deck::Findings& findings) {
    const int given = (p.body_force ? 1 : 0) + (p.acceleration ? 1 : 0) + (p.traction ? 1 : 0);
    if (given != 1)
      findings.add("", std::string(given == 0 ? "none" : "more than one") +
                           " of \"Body Force [pN/um^3]\", \"Acceleration [m/s^2]\" and \"Traction "
                           "[Pa]\" is given; admissible: one of them");
    if (p.traction && !p.face)
      findings.add("Face", "missing; \"Traction [Pa]\" acts on a face of the body's box");
    if (!p.traction && p.face) findings.add("Face", "is used with \"Traction [Pa]\" only");
  });

  deck::Section<ExternalForcesParameters> section(
      "External Forces", "Dead forces on the particles, one sublist each, named by the user.");
  section.named_sections(force, &ExternalForcesParameters::forces, 0);
  return section;
}

std::vector<transfer::VolumeForce> volume_forces(const NamedForces& forces, const grid::Grid& body,
                                                 const std::array<double, 3>& outer_thickness) {
  std::vector<transfer::VolumeForce> all;
  for (const auto& named : forces) {
    const ExternalForce& force = named.second;
    transfer::VolumeForce one{{0.0, 0.0, 0.0}, force.acceleration.has_value(), -1, 0.0, 0.0};
    double scale = 1.0;
    if (force.acceleration) scale = 1e-6;  // kg/m^3 um^3 m/s^2 = 1e-18 N = 1e-6 pN
    if (force.traction) {
      const int axis = axis_of(*force.face);
      const auto d = static_cast<std::size_t>(axis);
      one.axis = axis;
      one.face = body.origin[d] + (is_upper(*force.face) ? body.length(axis) : 0.0);
      one.thickness = outer_thickness[d];
      scale = 1.0 / outer_thickness[d];
    }
    const auto& vector = force.body_force     ? *force.body_force
                         : force.acceleration ? *force.acceleration
                                              : *force.traction;
    for (std::size_t c = 0; c < 3; ++c) one.per_volume[c] = scale * vector[c];
    all.push_back(one);
  }
  return all;
}

}  // namespace stroma::mechanics
