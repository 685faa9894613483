// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/ExternalForcesSection.hpp"

#include "stroma/sections/Faces.hpp"

namespace stroma::sections {

using namespace mechanics;

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
      "It acts at the points of the face beside the outermost particles, and so on as much of the "
      "face as the body reaches.");
  force.choice("Face", &ExternalForce::face, single_faces(),
               "The face of the body's box on which a Traction acts.");
  force.optional(
      "Load Curve", &ExternalForce::load_curve, deck::not_empty(),
      "The name of one of the Load Curves, by which the force is multiplied; without it, "
      "by the load factor.");
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

}  // namespace stroma::sections
