// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/GridSection.hpp"

namespace stroma::sections {

using namespace mechanics;

deck::Section<GridParameters> grid_section() {
  deck::Section<GridParameters> section(
      "Grid", "The structured background grid; it fills the box of the specimen.");
  section.optional(
      "Element Size [um]", &GridParameters::element_size, deck::positive(),
      "Size of an element along x, y, z. It must divide the edges of the box. Either this "
      "or Elements.");
  section.optional("Elements", &GridParameters::elements, deck::at_least(1),
                   "Number of elements along x, y, z, instead of their size.");
  section.optional(
      "Reset", &GridParameters::reset, deck::any(),
      "true: the grid returns to its Cartesian shape after each load step and particles move "
      "across it (the standard Material Point Method). false: it convects with the particles.");
  std::vector<std::pair<std::string, shape::ShapeFunctions>> kinds;
  for (const shape::ShapeKind& kind : shape::shape_kinds) kinds.emplace_back(kind.name, kind.kind);
  section.choice("Shape Functions", &GridParameters::shape_functions, kinds,
                 "Interpolation between particles and nodes. Linear: hats, whose gradients jump "
                 "where a particle enters another element. GIMP: hats averaged over a box around "
                 "each particle. CPDI: the same over a parallelepiped that deforms with the "
                 "particle. B-splines: smooth functions, averaged as GIMP does. With Reset, all "
                 "but Linear are free of the crossing artefact; the wider they are, the more "
                 "they cost (docs/performance.md).");
  section.choice(
      "Particle Domain", &GridParameters::particle_domain,
      {{"Stretched", ParticleDomain::stretched}, {"Undeformed", ParticleDomain::undeformed}},
      "Of all but Linear, with Reset: the domain of a particle follows its deformation "
      "gradient, or stays as it was seeded.");
  section.choice(
      "Dilatation", &GridParameters::dilatation,
      {{"Automatic", DilatationChoice::automatic},
       {"Pointwise", DilatationChoice::pointwise},
       {"Element Mean", DilatationChoice::element_mean}},
      "The change of volume that a particle resists: its own, or the mean over the particles of "
      "its element. Element Mean keeps nearly incompressible materials from locking, which makes "
      "them far too stiff (with GIMP and CPDI on few elements a part of that is left); B-splines "
      "lock little without it (docs/theory.md). Automatic: Element "
      "Mean for Linear, GIMP and CPDI where the Poisson ratio of any material is above 0.45, else, "
      "with Deformation Gradient = Projected Displacement, and beside a law without an energy "
      "of volume, Pointwise.");
  section.choice(
      "Deformation Gradient", &GridParameters::deformation_gradient,
      {{"Incremental", DeformationGradient::incremental},
       {"Projected Displacement", DeformationGradient::projected_displacement}},
      "Incremental: each step's deformation on top of the one before. Projected "
      "Displacement: the paper's equations 1 and 2, which put the particles' displacement "
      "on the grid anew in each step, and are wrong at free faces (docs/theory.md).");
  section.optional(
      "Stabilization", &GridParameters::stabilization, deck::at_least(0.0),
      "Stiffness, as a fraction of the real one, of a fictitious material in elements "
      "that particles fill by less than half. It keeps nodes in place that the body "
      "barely touches; 0: none. Without it: 0.01 with Reset, else 2e-5, but less, down to 2e-6, "
      "where the body's linear answer to the first step says that it would add more than "
      "3e-4 to the stiffness, and more, up to 1e-4, where the first step fails and it "
      "would add less. With inertia 2e-5.");
  section.optional("Plane Strain", &GridParameters::plane_strain, deck::any(),
                   "u_z = 0 everywhere; the grid has one element through z.");
  section.check([](const GridParameters& p, deck::Findings& findings) {
    if (p.element_size && p.elements)
      findings.add("Elements", "given beside \"Element Size [um]\"; give one of the two");
    if (!p.element_size && !p.elements)
      findings.add("Element Size [um]",
                   "missing; give it, or Elements (their number along x, y, z)");
    if (p.dilatation == DilatationChoice::element_mean &&
        p.deformation_gradient == DeformationGradient::projected_displacement)
      findings.add("Dilatation",
                   "\"Element Mean\" needs Deformation Gradient = \"Incremental\": the projected "
                   "displacement knows no mean; admissible with it: \"Pointwise\"");
  });
  return section;
}

}  // namespace stroma::sections
