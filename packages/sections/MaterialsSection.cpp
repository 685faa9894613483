// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/MaterialsSection.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stroma/base/Log.hpp"
#include "stroma/sections/DrivesSection.hpp"
#include "stroma/sections/FibersSection.hpp"
#include "stroma/sections/MaterialFieldsSection.hpp"
#include "stroma/sections/ModelNumbers.hpp"
#include "stroma/sections/ViscositySection.hpp"

namespace stroma::sections {

using namespace material;

namespace {

void declare_model(deck::Section<MaterialParameters>& material) {
  const auto known = all_of(models());
  material.choice("Model", &MaterialParameters::model, choices_among(known),
                  meanings_of(known) + ". Ibar1, Ibar2: invariants of J^(-2/3) C.");
  for (const SharedNumber& number : shared_numbers(known)) {
    const std::string described = "Of " + number.models + ". " + number.meaning;
    if (number.is_list)
      material.optional(number.name, &MaterialParameters::lists, admissible(number.admissible),
                        described);
    else
      material.optional(number.name, &MaterialParameters::numbers, admissible(number.admissible),
                        described);
  }
  material.optional(poisson_ratio_name, &MaterialParameters::numbers,
                    deck::strictly_between(-1.0, 0.5),
                    "Poisson's ratio nu of small strain, in place of a model's Bulk Modulus [Pa] "
                    "or Lame Modulus [Pa].");
  for (const char* name : {"Young", "E [Pa]"})
    material.substitute(name,
                        "of Young's modulus E and Poisson's ratio nu: Shear Modulus [Pa] = E / (2 "
                        "(1 + nu)), and Poisson Ratio");
}

/// What a model makes of the numbers that a material gives.
void check_model(const MaterialParameters& p, deck::Findings& findings) {
  const Model& model = model_of(p);
  const bool is_complete = check_numbers(model, "Model", p.numbers, p.lists, findings);
  if (!model.has_volumetric_energy && p.volumetric_energy != VolumetricEnergy::logarithmic)
    findings.add("Volumetric Energy", "Model = " + model.name + " has its own energy of volume");
  if (!is_complete || (model.takes_directions && !p.fibers)) return;
  const SmallStrainModuli moduli = model.law(p).small_strain();
  const auto refuse = [&](const char* which, double modulus) {
    if (!(modulus > 0.0))
      findings.add(model.numbers.front().name,
                   base::format("in small strain the material's %s modulus is %g Pa; admissible: "
                                "numbers that make it > 0",
                                which, modulus));
  };
  refuse("shear", moduli.shear);
  refuse("bulk", moduli.bulk);
}

/// Squares and products of numbers must stay within what a double holds.
void refuse_absurd_numbers(const MaterialParameters& p, deck::Findings& findings) {
  const auto check = [&](const std::string& where, double number) {
    constexpr double largest = 1e60;
    if (std::abs(number) > largest)
      findings.add(where, base::format("found %g, beyond what can be computed with; admissible: "
                                       "sizes up to %g",
                                       number, largest));
  };
  for (const auto& [name, number] : p.numbers) check(name, number);
  for (const auto& [name, list] : p.lists)
    for (const double number : list) check(name, number);
  if (p.active_stress) check("Active Stress|T0 [Pa]", p.active_stress->t0);
  if (!p.fibers) return;
  for (const auto& [family, fibers] : p.fibers->families)
    for (const auto& [name, number] : fibers.numbers)
      check("Fibers|" + family + "|" + name, number);
}

/// Fibres have laws of their own, unless the model asks for their directions alone.
void check_fibers(const MaterialParameters& p, deck::Findings& findings) {
  const Model& model = model_of(p);
  if (!p.fibers) {
    if (model.takes_directions)
      findings.add("Fibers",
                   "missing; Model = " + model.name + " takes the directions of families");
    return;
  }
  for (const auto& [name, family] : p.fibers->families) {
    const std::string where = "Fibers|" + name + "|";
    if (!model.takes_directions && !family.law) {
      std::string words;
      for (const FiberModel& law : fiber_models()) words += (words.empty() ? "" : ", ") + law.name;
      findings.add(where + "Law", "missing; admissible: " + words);
    }
    if (!model.takes_directions) continue;
    if (family.law || !family.numbers.empty())
      findings.add(where + (family.law ? "Law" : family.numbers.begin()->first),
                   "Model = " + model.name + " takes the directions of fibres alone");
    if (family.distribution != Distribution::single)
      findings.add(where + "Distribution", "admissible with Model = " + model.name +
                                               ": \"Single\"; Kappa disperses fibres");
    if (family.weigh_by_coherence)
      findings.add(where + "Coherence Weight", "Model = " + model.name +
                                                   " has one modulus for all its fibres; "
                                                   "admissible: false");
  }
}

}  // namespace

namespace {

/// A pressure has one drive, its own, and nothing beside it that bears load.
void check_pressure(const MaterialParameters& p, deck::Findings& findings) {
  if (!is_pressure(p)) {
    if (p.load_curve) findings.add("Load Curve", "is used with Model = Pressure only");
    return;
  }
  const auto refuse = [&](const char* name, bool is_there) {
    if (is_there) findings.add(name, "is not admissible with Model = Pressure");
  };
  refuse("Fibers", p.fibers.has_value());
  refuse("Viscosity", p.viscosity.has_value());
  refuse("Active Stress", p.active_stress.has_value());
  refuse("Growth", p.growth.has_value());
}

}  // namespace

deck::Section<MaterialsParameters> materials_section() {
  deck::Section<MaterialParameters> material("NAME", "One material; NAME is the user's.");
  material.required("Label", &MaterialParameters::label, deck::at_least(0),
                    "The label of the segmented image that is made of this material.");
  declare_model(material);
  material.choice(
      "Volumetric Energy", &MaterialParameters::volumetric_energy,
      {{"Logarithmic", VolumetricEnergy::logarithmic}, {"Quadratic", VolumetricEnergy::quadratic}},
      "U(J). Logarithmic: K/2 (ln J)^2. Quadratic: K/4 (J^2 - 1 - 2 ln J). The same in "
      "small strain.");
  material.optional(
      "Density [kg/m^3]", &MaterialParameters::density, deck::positive(),
      "Mass density, for Loading|Inertia, for forces per mass and for Deformation "
      "Gradient = Projected Displacement; there, materials without it count as equally dense.");
  material.optional(
      "Load Curve", &MaterialParameters::load_curve, deck::not_empty(),
      "Of Model = Pressure: the name of one of the Load Curves, by which the pressure "
      "is multiplied; without it, by the load factor.");
  material.section(fibers_section(), &MaterialParameters::fibers);
  material.section(viscosity_section(), &MaterialParameters::viscosity);
  material.section(active_stress_section(), &MaterialParameters::active_stress);
  material.section(growth_section(), &MaterialParameters::growth);
  material.section(material_fields_section(), &MaterialParameters::fields);
  material.check(refuse_absurd_numbers);
  material.check(check_model);
  material.check(check_fibers);
  material.check(check_drives);
  material.check([](const MaterialParameters& p, deck::Findings& findings) {
    if (!p.viscosity || !p.viscosity->is_deviatoric) return;
    const Model& model = model_of(p);
    if (!model.is_isochoric || (p.fibers && !model.takes_directions))
      findings.add("Viscosity|Applies To",
                   "\"Deviatoric\" asks for a law whose energies of shape and volume are apart, " +
                       (model.is_isochoric ? std::string("without Fibers of their own")
                                           : "which Model = " + model.name + " is not") +
                       "; admissible: \"All\"");
  });
  material.check(check_fields);
  material.check(check_pressure);

  deck::Section<MaterialsParameters> section("Materials",
                                             "One sublist for each material, named by the user.");
  section.named_sections(material, &MaterialsParameters::materials);
  section.check([](const MaterialsParameters& p, deck::Findings& findings) {
    if (p.materials.size() > 255) findings.add(p.materials.back().first, "more than 255 materials");
    std::map<int, std::string> owner;
    for (const auto& [name, parameters] : p.materials) {
      const auto [first, is_new] = owner.emplace(parameters.label, name);
      if (!is_new)
        findings.add(name, "has label " + std::to_string(parameters.label) + ", as \"" +
                               first->second + "\" has; each label belongs to one material");
    }
  });
  return section;
}

}  // namespace stroma::sections
