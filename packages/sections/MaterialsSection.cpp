// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/MaterialsSection.hpp"

#include <algorithm>
#include <cstddef>

#include "stroma/base/Log.hpp"
#include "stroma/material/Models.hpp"
#include "stroma/sections/MaterialFieldsSection.hpp"

namespace stroma::sections {

using namespace material;

namespace {

/// One declaration of each number, whichever models have it.
struct SharedNumber {
  std::string name, models, meaning;
  Range admissible;
};

std::vector<SharedNumber> shared_numbers() {
  std::vector<SharedNumber> all;
  for (const Model& model : models())
    for (const ModelNumber& number : model.numbers) {
      const auto same = std::find_if(all.begin(), all.end(), [&](const SharedNumber& other) {
        return other.name == number.name;
      });
      if (same == all.end()) {
        all.push_back({number.name, model.name, number.meaning, number.admissible});
        continue;
      }
      same->models += ", " + model.name;
      if (same->meaning.find(number.meaning) == std::string::npos)
        same->meaning += " " + model.name + ": " + number.meaning;
      if (!(same->admissible == number.admissible)) same->admissible = Range::any();
    }
  return all;
}

deck::Admissible admissible(const Range& range) {
  return range == Range::positive() ? deck::positive()
         : range == Range::any()    ? deck::any()
                                    : deck::strictly_between(range.lower, range.upper);
}

void declare_model(deck::Section<MaterialParameters>& material) {
  std::vector<std::pair<std::string, int>> names;
  std::string meaning;
  for (const Model& model : models()) {
    names.emplace_back(model.name, static_cast<int>(names.size()));
    meaning += (meaning.empty() ? "" : ". ") + model.name + ": " + model.meaning;
  }
  material.choice("Model", &MaterialParameters::model, names,
                  meaning + ". Ibar1, Ibar2: invariants of J^(-2/3) C.");
  for (const SharedNumber& number : shared_numbers())
    material.optional(number.name, &MaterialParameters::numbers, admissible(number.admissible),
                      "Of " + number.models + ". " + number.meaning);
  material.optional(poisson_ratio_name, &MaterialParameters::numbers,
                    deck::strictly_between(-1.0, 0.5),
                    "Poisson's ratio nu of small strain, in place of a model's Bulk Modulus [Pa] "
                    "or Lame Modulus [Pa].");
}

/// What a model makes of the numbers that a material gives.
void check_numbers(const MaterialParameters& p, deck::Findings& findings) {
  const Model& model = model_of(p);
  bool is_complete = true;
  for (const auto& [name, value] : p.numbers)
    if (!model.takes(name))
      findings.add(name,
                   "is no parameter of Model = " + model.name + "; admissible: " + model.listing());
  const bool has_ratio = p.numbers.count(poisson_ratio_name) > 0;
  for (const ModelNumber& number : model.numbers) {
    const auto given = p.numbers.find(number.name);
    const bool is_given = given != p.numbers.end();
    if (is_given && number.or_poisson_ratio && has_ratio)
      findings.add(number.name,
                   std::string("given beside \"") + poisson_ratio_name + "\"; give one of the two");
    if (!is_given && !(number.or_poisson_ratio && has_ratio)) {
      is_complete = false;
      findings.add(number.or_poisson_ratio ? poisson_ratio_name : number.name,
                   number.or_poisson_ratio
                       ? "missing; give it, or \"" + number.name + "\""
                       : "missing; Model = " + model.name + " takes " + model.listing());
    }
    const deck::Admissible rule = admissible(number.admissible);
    if (is_given && !rule.allows(given->second))
      findings.add(number.name, base::format("found %g; admissible: ", given->second) +
                                    rule.describe(deck::detail::value_type<double>()));
  }
  if (!model.has_volumetric_energy && p.volumetric_energy != VolumetricEnergy::logarithmic)
    findings.add("Volumetric Energy", "Model = " + model.name + " has its own energy of volume");
  if (!is_complete) return;
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
  material.optional("Density [kg/m^3]", &MaterialParameters::density, deck::positive(),
                    "Mass density, for forces per mass and for Deformation Gradient = Projected "
                    "Displacement; there, materials without it count as equally dense.");
  material.section(material_fields_section(), &MaterialParameters::fields);
  material.check(check_numbers);
  material.check([](const MaterialParameters& p, deck::Findings& findings) {
    if (!p.fields || model_of(p).may_vary_in_stiffness) return;
    for (const auto& [name, field] : p.fields->fields)
      if (field.number == VaryingNumber::shear_modulus)
        findings.add("Fields|" + name, std::string(name_of(field.number)) +
                                           " is no parameter of Model = " + model_of(p).name);
  });

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
