// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/grid/GridSection.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::grid {

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
  section.choice("Shape Functions", &GridParameters::shape_functions,
                 {{"Linear", ShapeFunctions::linear},
                  {"GIMP", ShapeFunctions::gimp},
                  {"CPDI", ShapeFunctions::cpdi},
                  {"Quadratic B-Spline", ShapeFunctions::quadratic_b_spline},
                  {"Cubic B-Spline", ShapeFunctions::cubic_b_spline}},
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
      {{"Automatic", Dilatation::automatic},
       {"Pointwise", Dilatation::pointwise},
       {"Element Mean", Dilatation::element_mean}},
      "The change of volume that a particle resists: its own, or the mean over the particles of "
      "its element. Element Mean keeps nearly incompressible materials from locking, which makes "
      "them far too stiff; B-splines lock little without it (docs/theory.md). Automatic: Element "
      "Mean for Linear, GIMP and CPDI where the Poisson ratio of any material is above 0.45, else, "
      "and with Deformation Gradient = Projected Displacement, Pointwise.");
  section.choice(
      "Deformation Gradient", &GridParameters::deformation_gradient,
      {{"Incremental", DeformationGradient::incremental},
       {"Projected Displacement", DeformationGradient::projected_displacement}},
      "Incremental: each step's deformation on top of the one before. Projected "
      "Displacement: the paper's equations 1 and 2, which put the particles' displacement "
      "on the grid anew in each step, and are wrong at free faces (docs/theory.md).");
  section.optional("Stabilization", &GridParameters::stabilization, deck::at_least(0.0),
                   "Stiffness, as a fraction of the real one, of a fictitious material in elements "
                   "that particles fill by less than half. It keeps nodes in place that the body "
                   "barely touches; 0: none. Without it: 0.01 with Reset, else 2e-5.");
  section.optional("Plane Strain", &GridParameters::plane_strain, deck::any(),
                   "u_z = 0 everywhere; the grid has one element through z.");
  section.check([](const GridParameters& p, deck::Findings& findings) {
    if (p.element_size && p.elements)
      findings.add("Elements", "given beside \"Element Size [um]\"; give one of the two");
    if (!p.element_size && !p.elements)
      findings.add("Element Size [um]",
                   "missing; give it, or Elements (their number along x, y, z)");
    if (p.dilatation == Dilatation::element_mean &&
        p.deformation_gradient == DeformationGradient::projected_displacement)
      findings.add("Dilatation",
                   "\"Element Mean\" needs Deformation Gradient = \"Incremental\": the projected "
                   "displacement knows no mean; admissible with it: \"Pointwise\"");
  });
  return section;
}

double stabilization(const GridParameters& parameters) {
  return parameters.stabilization.value_or(parameters.reset ? 0.01 : 2e-5);
}

namespace {

bool lock(ShapeFunctions shape_functions) {
  return shape_functions == ShapeFunctions::linear || shape_functions == ShapeFunctions::gimp ||
         shape_functions == ShapeFunctions::cpdi;
}

}  // namespace

Dilatation dilatation(const GridParameters& parameters, double largest_poisson_ratio) {
  if (parameters.dilatation != Dilatation::automatic) return parameters.dilatation;
  const bool needs_mean =
      lock(parameters.shape_functions) && largest_poisson_ratio > locking_poisson_ratio;
  return needs_mean && parameters.deformation_gradient == DeformationGradient::incremental
             ? Dilatation::element_mean
             : Dilatation::pointwise;
}

std::string describe_dilatation(const GridParameters& parameters, double largest_poisson_ratio) {
  const bool is_mean = dilatation(parameters, largest_poisson_ratio) == Dilatation::element_mean;
  std::string text = is_mean ? "Element Mean" : "Pointwise";
  if (parameters.dilatation == Dilatation::automatic)
    text += base::format(" (Automatic, for Poisson ratios up to %.6g)", largest_poisson_ratio);
  return text;
}

std::string locking_note(const GridParameters& parameters, double largest_poisson_ratio) {
  if (!lock(parameters.shape_functions) || largest_poisson_ratio < locking_poisson_ratio ||
      dilatation(parameters, largest_poisson_ratio) != Dilatation::pointwise)
    return "";
  const bool is_projected =
      parameters.deformation_gradient == DeformationGradient::projected_displacement;
  return base::format(
             "Grid|Dilatation = Pointwise lets these shape functions lock at a Poisson ratio of "
             "%.6g: the body is too stiff, the more so the nearer it is to 0.5; ",
             largest_poisson_ratio) +
         (is_projected ? "Deformation Gradient = Projected Displacement admits no other; "
                         "\"Incremental\" with \"Element Mean\", or B-splines, cure it"
                       : "\"Element Mean\", or B-splines, cure it");
}

Grid make_grid(const GridParameters& parameters, const std::array<double, 3>& length) {
  static const char* const axis[3] = {"x", "y", "z"};
  Grid grid;
  std::string mistakes;
  for (int d = 0; d < 3; ++d) {
    if (parameters.elements) {
      grid.elements[d] = (*parameters.elements)[d];
    } else {
      const double size = (*parameters.element_size)[d];
      const double count = length[d] / size;
      grid.elements[d] = std::max<std::int64_t>(1, std::llround(count));
      if (std::abs(count - static_cast<double>(grid.elements[d])) > 1e-6) {
        const double fewer = std::max(1.0, std::floor(count));
        mistakes += base::format(
            "\n"
            "Grid|Element Size [um]: %.10g um does not divide the specimen's %.10g um along %s "
            "(%.4f elements); admissible near it: %.10g um (%.0f elements) or %.10g um (%.0f "
            "elements), or use Grid|Elements",
            size, length[d], axis[d], count, length[d] / fewer, fewer, length[d] / (fewer + 1.0),
            fewer + 1.0);
      }
    }
    grid.spacing[d] = length[d] / static_cast<double>(grid.elements[d]);
  }
  if (!mistakes.empty()) throw base::InputError(mistakes.substr(1));
  if (parameters.plane_strain && grid.elements[2] != 1) {
    throw base::InputError(
        base::format("Grid|Plane Strain: true needs one element through z, but the grid has %lld; "
                     "admissible: an element size of %.10g um along z, or a Region of the image "
                     "one slice thick",
                     static_cast<long long>(grid.elements[2]), length[2]));
  }
  grid.flat = parameters.plane_strain;
  return grid;
}

}  // namespace stroma::grid
