// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/material/Material.hpp"

#include <algorithm>
#include <cstddef>

namespace stroma::material {

deck::Section<MaterialsParameters> materials_section() {
  deck::Section<MaterialParameters> material("NAME", "One material; NAME is the user's.");
  material.required("Label", &MaterialParameters::label, deck::at_least(0),
                    "The label of the segmented image that is made of this material.");
  material.choice("Model", &MaterialParameters::model, {{"Neo-Hookean", Model::neo_hookean}},
                  "Neo-Hookean: W = mu/2 (J^(-2/3) tr C - 3) + U(J).");
  material.required("Shear Modulus [Pa]", &MaterialParameters::shear_modulus, deck::positive(),
                    "Shear modulus mu.");
  material.optional(
      "Poisson Ratio", &MaterialParameters::poisson_ratio, deck::strictly_between(-1.0, 0.5),
      "Poisson's ratio of small strain; K = 2 mu (1 + nu) / (3 (1 - 2 nu)). Either this or "
      "Bulk Modulus [Pa].");
  material.optional("Bulk Modulus [Pa]", &MaterialParameters::bulk_modulus, deck::positive(),
                    "Bulk modulus K, instead of Poisson Ratio.");
  material.choice(
      "Volumetric Energy", &MaterialParameters::volumetric_energy,
      {{"Logarithmic", VolumetricEnergy::logarithmic}, {"Quadratic", VolumetricEnergy::quadratic}},
      "U(J). Logarithmic: K/2 (ln J)^2. Quadratic: K/4 (J^2 - 1 - 2 ln J). The same in "
      "small strain.");
  material.optional("Density [kg/m^3]", &MaterialParameters::density, deck::positive(),
                    "Mass density, for forces per mass and for Deformation Gradient = Projected "
                    "Displacement; there, materials without it count as equally dense.");
  material.check([](const MaterialParameters& p, deck::Findings& findings) {
    if (p.poisson_ratio && p.bulk_modulus)
      findings.add("Bulk Modulus [Pa]", "given beside \"Poisson Ratio\"; give one of the two");
    if (!p.poisson_ratio && !p.bulk_modulus)
      findings.add("Poisson Ratio", "missing; give it, or \"Bulk Modulus [Pa]\"");
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

double bulk_modulus(double shear_modulus, double poisson_ratio) {
  return 2.0 * shear_modulus * (1.0 + poisson_ratio) / (3.0 * (1.0 - 2.0 * poisson_ratio));
}

double largest_poisson_ratio(const NamedMaterials& materials) {
  double largest = -1.0;
  for (const auto& [name, m] : materials) {
    const double K = m.bulk_modulus.value_or(0.0), mu = m.shear_modulus;
    const double nu = m.poisson_ratio.value_or((3.0 * K - 2.0 * mu) / (2.0 * (3.0 * K + mu)));
    largest = std::max(largest, nu);
  }
  return largest;
}

std::vector<NeoHookean> laws(const NamedMaterials& materials) {
  std::vector<NeoHookean> laws;
  for (const auto& named : materials) {
    const MaterialParameters& p = named.second;
    laws.push_back(
        {p.shear_modulus,
         p.bulk_modulus ? *p.bulk_modulus : bulk_modulus(p.shear_modulus, *p.poisson_ratio),
         p.volumetric_energy});
  }
  return laws;
}

std::map<std::int32_t, int> material_of_label(const NamedMaterials& materials) {
  std::map<std::int32_t, int> index;
  for (std::size_t m = 0; m < materials.size(); ++m)
    index[materials[m].second.label] = static_cast<int>(m);
  return index;
}

}  // namespace stroma::material
