// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/BoundaryConditionsSection.hpp"

#include "stroma/sections/Directions.hpp"
#include "stroma/sections/Faces.hpp"
#include "stroma/sections/VectorImagesSection.hpp"
#include "stroma/tensor/Tensor3.hpp"

namespace stroma::sections {

using namespace mechanics;

deck::Section<BoundaryConditionsParameters> boundary_conditions_section() {
  deck::Section<BoundaryCondition> condition(
      "NAME", "One condition; NAME is the user's and appears in the results.");
  auto faces = single_faces();
  faces.emplace_back("all", Face::all);
  condition.required_choice(
      "Face", &BoundaryCondition::face, faces,
      "A face of the body's box, or all six. The body must reach a single one, unless "
      "it is held by a Grip.");
  condition.required(
      "Components", &BoundaryCondition::components, deck::not_empty(),
      "The displacement components it prescribes: a selection of xyz, such as y or xyz.");
  condition.optional("Displacement [um]", &BoundaryCondition::displacement, deck::any(),
                     "Displacement at full load, x, y, z. Without any of Displacement, Strain, "
                     "Displacement Gradient, Rotation and Displacement Images the components are "
                     "held at zero.");
  condition.optional(
      "Strain", &BoundaryCondition::strain, deck::any(),
      "Displacement along the outward normal at full load, as a fraction of the body's "
      "length there; the other components are held at zero.");
  condition.optional("Displacement Gradient", &BoundaryCondition::displacement_gradient,
                     deck::any(),
                     "Nine numbers G, row by row: u = G (X - lowest corner of the body's box).");
  condition.optional("Rotation [deg]", &BoundaryCondition::rotation, deck::any(),
                     "Angle at full load by which the face turns about Axis through Center, "
                     "right-handed; each point moves on its circle.");
  condition.optional("Axis", &BoundaryCondition::axis, deck::any(),
                     "Direction of the axis of Rotation [deg], of any length. Without it: the "
                     "face's axis (x, y or z).");
  condition.optional(
      "Center [um]", &BoundaryCondition::center, deck::any(),
      "A point on the axis of Rotation [deg], from the corner of the whole image, with "
      "Image|Region, too. Without it: the middle of the body's box.");
  condition.choice("Imposed By", &BoundaryCondition::imposed_by, ways_of_imposing(),
                   "Nodes: the nodes of the face are moved; with Grid|Reset, the face must stay a "
                   "plane across its axis (its normal displacement is prescribed, the same "
                   "everywhere on it, by this condition or another one), and the lattice follows "
                   "it. Grip: the particles within one element of the face at load 0 are moved, "
                   "with all nodes that they touch. Penalty: springs move points of the face that "
                   "ride beside the outermost particles; for every shape function, with Grid|Reset "
                   "and without. Without it: Nodes, or Penalty where these cannot.");
  condition.optional(
      "Penalty Factor", &BoundaryCondition::penalty_factor, deck::positive(),
      "Stiffness of the springs of Imposed By = Penalty: per area, Penalty Factor * (K + 4/3 mu) / "
      "length of the body along the face's normal. They lower the force by about 1 / Penalty "
      "Factor. Without it: softer springs, which pull on until the face is where it should be.");
  condition.optional(
      "Load Curve", &BoundaryCondition::load_curve, deck::not_empty(),
      "The name of one of the Load Curves, by which the value is multiplied; without "
      "it, by the load factor.");
  condition.section(
      vector_images_section(
          "Displacement Images",
          "Displacement at full load, in um, by images of its components, such as measured ones: at "
          "each point of the face between the centres of voxels, trilinear. Not with Grid|Reset.",
          " Of components that the condition does not prescribe nothing is read."),
      &BoundaryCondition::images);
  condition.check([](const BoundaryCondition& p, deck::Findings& findings) {
    for (std::size_t n = 0; n < p.components.size(); ++n) {
      const char c = p.components[n];
      if (c != 'x' && c != 'y' && c != 'z') {
        findings.add("Components", "\"" + p.components + "\": '" + std::string(1, c) +
                                       "' is not a component; admissible: a selection of xyz");
        break;
      }
      if (p.components.find(c, n + 1) != std::string::npos) {
        findings.add("Components", "\"" + p.components + "\": '" + std::string(1, c) +
                                       "' stands there twice; admissible: a selection of xyz");
        break;
      }
    }
    const int given = (p.displacement ? 1 : 0) + (p.strain ? 1 : 0) +
                      (p.displacement_gradient ? 1 : 0) + (p.rotation ? 1 : 0) + (p.images ? 1 : 0);
    if (given > 1)
      findings.add(
          p.images     ? "Displacement Images"
          : p.rotation ? "Rotation [deg]"
          : p.strain   ? "Strain"
                       : "Displacement Gradient",
          "more than one of \"Displacement [um]\", \"Strain\", \"Displacement Gradient\", "
          "\"Rotation [deg]\" and \"Displacement Images\" is given; admissible: one of them");
    if (p.axis && !p.rotation) findings.add("Axis", "is used with \"Rotation [deg]\" only");
    if (p.center && !p.rotation)
      findings.add("Center [um]", "is used with \"Rotation [deg]\" only");
    refuse_no_length("Axis", p.axis, findings);
    if (p.rotation && !p.axis && *p.face == Face::all)
      findings.add("Axis",
                   "missing: Face = all has no normal for \"Rotation [deg]\"; admissible: "
                   "three numbers, not all 0");
    if (p.strain && *p.face == Face::all)
      findings.add("Strain",
                   "has no direction on Face = all; admissible: a single face, or "
                   "\"Displacement Gradient\"");
    else if (p.strain && !p.prescribes(axis_of(*p.face)))
      findings.add("Strain", std::string("is along the face's normal, ") + "xyz"[axis_of(*p.face)] +
                                 ", which \"Components\" does not prescribe");
    if (p.displacement_gradient) {
      const auto& G = *p.displacement_gradient;
      const double j_minus_1 =
          tensor::det_minus_one({{{G[0], G[1], G[2]}, {G[3], G[4], G[5]}, {G[6], G[7], G[8]}}});
      if (!(1.0 + j_minus_1 > 0.0))
        findings.add("Displacement Gradient",
                     "turns the body inside out; admissible: det(I + G) > 0");
    }
    if (p.penalty_factor && p.imposed_by != ImposedBy::penalty)
      findings.add("Penalty Factor", "is used with Imposed By = Penalty only");
    if (p.strain && !(*p.strain > -1.0))
      findings.add(
          "Strain",
          "a body cannot be compressed by 100 % or more; admissible: > -1, a share, not in per cent");
  });

  deck::Section<BoundaryConditionsParameters> section(
      "Boundary Conditions",
      "One sublist for each condition, named by the user. Required, unless there is a Rig, or Loading|Inertia.");
  section.named_sections(condition, &BoundaryConditionsParameters::conditions, 0);
  return section;
}

}  // namespace stroma::sections
