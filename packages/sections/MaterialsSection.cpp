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
  bool is_list;
};

std::vector<SharedNumber> shared_numbers() {
  std::vector<SharedNumber> all;
  for (const Model& model : models())
    for (const ModelNumber& number : model.numbers) {
      const auto same = std::find_if(all.begin(), all.end(), [&](const SharedNumber& other) {
        return other.name == number.name;
      });
      if (same == all.end()) {
        all.push_back(
            {number.name, model.name, number.meaning, number.admissible, number.longest > 0});
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
  if (!range.has_zero) return deck::number_that("other than 0", [](double x) { return x != 0.0; });
  if (range.upper < Range::infinity)
    return range.has_lower ? deck::between(range.lower, range.upper)
                           : deck::strictly_between(range.lower, range.upper);
  if (range.lower > -Range::infinity)
    return range.has_lower ? deck::at_least(range.lower) : deck::greater_than(range.lower);
  return deck::any();
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
  for (const SharedNumber& number : shared_numbers()) {
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
}

std::string found(double value, const ModelNumber& number) {
  return base::format("found %g; admissible: ", value) +
         admissible(number.admissible).describe(deck::detail::value_type<double>());
}

/// A number that the model asks for. \return whether it is there
bool check_number(const MaterialParameters& p, const ModelNumber& number,
                  deck::Findings& findings) {
  const auto given = p.numbers.find(number.name);
  const bool has_ratio = number.or_poisson_ratio && p.numbers.count(poisson_ratio_name) > 0;
  if (given == p.numbers.end()) {
    if (has_ratio) return true;
    const Model& model = model_of(p);
    findings.add(number.or_poisson_ratio ? poisson_ratio_name : number.name,
                 number.or_poisson_ratio
                     ? "missing; give it, or \"" + number.name + "\""
                     : "missing; Model = " + model.name + " takes " + model.listing());
    return false;
  }
  if (has_ratio)
    findings.add(number.name,
                 std::string("given beside \"") + poisson_ratio_name + "\"; give one of the two");
  if (!admissible(number.admissible).allows(given->second))
    findings.add(number.name, found(given->second, number));
  return true;
}

/// A list that the model asks for, as long as its others. \return whether it is there
bool check_list(const MaterialParameters& p, const ModelNumber& number,
                const std::vector<double>*& first, deck::Findings& findings) {
  const auto given = p.lists.find(number.name);
  if (given == p.lists.end()) {
    const Model& model = model_of(p);
    findings.add(number.name, "missing; Model = " + model.name + " takes " + model.listing());
    return false;
  }
  const std::vector<double>& list = given->second;
  for (const double value : list)
    if (!admissible(number.admissible).allows(value))
      findings.add(number.name, found(value, number));
  if (list.empty() || list.size() > static_cast<std::size_t>(number.longest)) {
    findings.add(number.name, base::format("found %zu numbers; admissible: 1 to %d of them",
                                           list.size(), number.longest));
    return false;
  }
  if (first == nullptr) first = &list;
  if (first->size() == list.size()) return true;
  findings.add(number.name,
               base::format("found %zu numbers; admissible: as many as the model's other list, %zu",
                            list.size(), first->size()));
  return false;
}

/// What a model makes of the numbers that a material gives.
void check_numbers(const MaterialParameters& p, deck::Findings& findings) {
  const Model& model = model_of(p);
  const auto refuse_foreign = [&](const auto& given) {
    for (const auto& [name, value] : given)
      if (!model.takes(name))
        findings.add(
            name, "is no parameter of Model = " + model.name + "; admissible: " + model.listing());
  };
  refuse_foreign(p.numbers);
  refuse_foreign(p.lists);
  bool is_complete = true;
  const std::vector<double>* first_list = nullptr;
  for (const ModelNumber& number : model.numbers) {
    const bool is_there = number.longest > 0 ? check_list(p, number, first_list, findings)
                                             : check_number(p, number, findings);
    is_complete = is_complete && is_there;
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
