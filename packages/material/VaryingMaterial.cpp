// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/material/VaryingMaterial.hpp"

#include <algorithm>

#include "stroma/material/Models.hpp"

namespace stroma::material {
namespace {

/// "C [Pa]|1", counted as people do.
std::string entry_name(const std::string& list, std::size_t entry) {
  return list + "|" + std::to_string(entry + 1);
}

void add_list(std::vector<VaryingNumber>& all, const std::string& name, std::size_t length,
              const Range& admissible,
              const std::function<std::vector<double>&(MaterialParameters&)>& list) {
  for (std::size_t k = 0; k < length; ++k)
    all.push_back({entry_name(name, k), admissible,
                   [list, k](MaterialParameters& m) -> double& { return list(m)[k]; }});
}

}  // namespace

std::vector<VaryingNumber> numbers_that_may_vary(const MaterialParameters& material) {
  std::vector<VaryingNumber> all;
  const auto add_number = [&](const std::string& name, const Range& admissible) {
    if (material.numbers.count(name) > 0)
      all.push_back({name, admissible,
                     [name](MaterialParameters& m) -> double& { return m.numbers.at(name); }});
  };
  for (const ModelNumber& number : model_of(material).numbers) {
    add_number(number.name, number.admissible);
    const auto list = material.lists.find(number.name);
    if (list == material.lists.end()) continue;
    const std::string& name = number.name;
    if (number.longest > 0)
      add_list(all, name, list->second.size(), number.admissible,
               [name](MaterialParameters& m) -> std::vector<double>& { return m.lists.at(name); });
    else  // a list of another model
      all.push_back({name, number.admissible, [name](MaterialParameters& m) -> double& {
                       return m.lists.at(name).front();
                     }});
  }
  add_number(poisson_ratio_name, {-1.0, 0.5});
  if (material.fibers)
    for (std::size_t f = 0; f < material.fibers->families.size(); ++f) {
      const auto& [family, fibers] = material.fibers->families[f];
      if (!fibers.law) continue;
      for (const ModelNumber& number :
           fiber_models()[static_cast<std::size_t>(*fibers.law)].numbers)
        if (fibers.numbers.count(number.name) > 0)
          all.push_back({"Fibers|" + family + "|" + number.name, number.admissible,
                         [f, name = number.name](MaterialParameters& m) -> double& {
                           return m.fibers->families[f].second.numbers.at(name);
                         }});
    }
  if (material.viscosity) {
    add_list(all, "Viscosity|Moduli", material.viscosity->moduli.size(), Range::at_least(0.0),
             [](MaterialParameters& m) -> std::vector<double>& { return m.viscosity->moduli; });
    add_list(all, "Viscosity|Relaxation Times [s]", material.viscosity->times.size(),
             Range::positive(),
             [](MaterialParameters& m) -> std::vector<double>& { return m.viscosity->times; });
  }
  if (material.active_stress)
    all.push_back({"Active Stress|T0 [Pa]", Range::any(),
                   [](MaterialParameters& m) -> double& { return m.active_stress->t0; }});
  if (material.growth)
    all.push_back({"Growth|Ratio", Range::positive(),
                   [](MaterialParameters& m) -> double& { return m.growth->ratio; }});
  return all;
}

std::vector<double> numbers_of(AnyLaw law) {
  std::vector<double> numbers;
  law.for_each_number([&](const NumberName&, double& number) { numbers.push_back(number); });
  return numbers;
}

VaryingMaterial::VaryingMaterial(const MaterialParameters& material) : own_(material) {
  if (!material.fields) return;
  const std::vector<VaryingNumber> numbers = numbers_that_may_vary(material);
  for (const auto& named : material.fields->fields) {
    const auto found = std::find_if(numbers.begin(), numbers.end(), [&](const VaryingNumber& n) {
      return n.name == named.second.parameter;
    });
    number_.push_back(&found->in(own_));
  }
}

void VaryingMaterial::point(std::size_t family, const std::array<double, 3>& n, double share) {
  FiberParameters& fibers = own_.fibers->families[family].second;
  fibers.direction = n;
  fibers.share = share;
}

std::vector<const FieldImage*> images_of(const MaterialParameters& material) {
  std::vector<const FieldImage*> images;
  if (material.fields)
    for (const auto& field : material.fields->fields) images.push_back(&field.second);
  if (material.fibers)
    for (const auto& family : material.fibers->families) {
      const DirectionsFromImage& from = family.second;
      if (from.direction_from == DirectionsFromImage::Kind::structure_tensor)
        images.push_back(&from);
    }
  return images;
}

bool varies(const MaterialParameters& material) {
  if (material.fields && !material.fields->fields.empty()) return true;
  return material.fibers &&
         std::any_of(material.fibers->families.begin(), material.fibers->families.end(),
                     [](const auto& named) { return named.second.direction_from.has_value(); });
}

}  // namespace stroma::material
