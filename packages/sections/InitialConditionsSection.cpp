// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/InitialConditionsSection.hpp"

#include "stroma/sections/VectorImagesSection.hpp"

namespace stroma::sections {

using namespace mechanics;

deck::Section<InitialConditionsParameters> initial_conditions_section() {
  deck::Section<InitialCondition> condition("NAME", "One motion; NAME is the user's.");
  condition.optional("Velocity [um/s]", &InitialCondition::velocity, deck::any(),
                     "Of the whole body, x, y, z.");
  condition.optional(
      "Velocity Gradient [1/s]", &InitialCondition::velocity_gradient, deck::any(),
      "Nine numbers L, row by row: v = L (X - Center). A spin w about z is {0, -w, 0, "
      "w, 0, 0, 0, 0, 0}.");
  condition.optional(
      "Center [um]", &InitialCondition::center, deck::any(),
      "The point that Velocity Gradient [1/s] leaves at rest, from the corner of the whole image, "
      "with Image|Region, too. Without it: the middle of the body's box.");
  condition.section(vector_images_section(
                        "Velocity Images",
                        "Velocity in um/s by images of its components: at each point of the body "
                        "between the centres of voxels, trilinear."),
                    &InitialCondition::images);
  condition.check([](const InitialCondition& p, deck::Findings& findings) {
    if (!p.velocity && !p.velocity_gradient && !p.images)
      findings.add("Velocity [um/s]",
                   "missing; give it, or Velocity Gradient [1/s], or Velocity Images, or several");
    if (p.center && !p.velocity_gradient)
      findings.add("Center [um]", "is used with Velocity Gradient [1/s] only");
  });
  deck::Section<InitialConditionsParameters> section(
      "Initial Conditions",
      "How a body with Loading|Inertia moves when the load begins, one sublist each, named by the "
      "user; they add up. Without any it is at rest. What conditions prescribe moves as they say.");
  section.named_sections(condition, &InitialConditionsParameters::conditions, 0);
  return section;
}

}  // namespace stroma::sections
