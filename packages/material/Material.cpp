// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/material/Material.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stroma/material/Models.hpp"

namespace stroma::material {
Compressibility compressibility(const NamedMaterials& materials) {
  Compressibility all{-1.0};
  for (const auto& [name, m] : materials) {
    const AnyMatrix law = model_of(m).law(m);
    const auto given = m.numbers.find(poisson_ratio_name);
    all.largest_poisson_ratio =
        std::max(all.largest_poisson_ratio,
                 given != m.numbers.end() ? given->second : law.small_strain().poisson_ratio());
    const bool volume_relaxes = m.viscosity && !m.viscosity->is_deviatoric;
    all.may_be_averaged = all.may_be_averaged && may_be_averaged(law) && !volume_relaxes;
  }
  return all;
}

DistributionParameters distribution_of(const FiberParameters& fibers) {
  DistributionParameters where;
  where.distribution = fibers.distribution;
  where.direction = fibers.direction.value_or(where.direction);
  where.axes = fibers.axes.value_or(where.axes);
  where.concentration = fibers.concentration.value_or(where.concentration);
  where.quadrature = fibers.quadrature.value_or(where.quadrature);
  return where;
}

namespace {

FiberFamily family_of(const FiberParameters& fibers, std::vector<FiberDirections>& kept) {
  const std::vector<FiberDirection> all = directions(distribution_of(fibers));
  const FiberDirections on_device("fiber directions", all.size());
  const auto on_host = Kokkos::create_mirror_view(on_device);
  std::copy(all.begin(), all.end(), on_host.data());
  Kokkos::deep_copy(on_device, on_host);
  kept.push_back(on_device);
  return {fiber_models()[static_cast<std::size_t>(*fibers.law)].law(fibers), on_device.data(),
          static_cast<int>(all.size())};
}

Viscosity viscosity_of(const ViscosityParameters& given) {
  Viscosity viscosity;
  viscosity.terms = static_cast<int>(given.moduli.size());
  viscosity.long_term = given.long_term;
  std::copy(given.moduli.begin(), given.moduli.end(), viscosity.modulus);
  std::copy(given.times.begin(), given.times.end(), viscosity.time);
  viscosity.is_deviatoric = given.is_deviatoric;
  return viscosity;
}

/// Sets a drive's direction, if there is one.
template <class Drive>
void point(Drive& drive, const std::optional<std::array<double, 3>>& direction) {
  if (!direction) return;
  const auto& d = *direction;
  const double length = std::hypot(d[0], d[1], d[2]);
  for (std::size_t i = 0; i < 3; ++i) drive.direction[i] = d[i] / length;
}

ActiveStress active_stress_of(const MaterialParameters& material) {
  ActiveStress active;
  active.t0 = material.active_stress->t0;
  active.kind = material.active_stress->kind;
  point(active, direction_of(material, material.active_stress->direction));
  return active;
}

Growth growth_of(const MaterialParameters& material) {
  Growth growth;
  growth.ratio = material.growth->ratio;
  growth.kind = material.growth->kind;
  point(growth, direction_of(material, material.growth->direction));
  return growth;
}

}  // namespace

std::optional<std::array<double, 3>> direction_of(const MaterialParameters& material,
                                                  const std::optional<std::array<double, 3>>& own) {
  if (own || !material.fibers) return own;
  for (const auto& family : material.fibers->families)
    if (family.second.distribution == Distribution::single) return family.second.direction;
  return std::nullopt;
}

MaterialLaws laws_of(const NamedMaterials& materials) {
  MaterialLaws all;
  for (const auto& [name, material] : materials) {
    AnyLaw law = model_of(material).law(material);
    if (material.fibers && !model_of(material).takes_directions)
      for (const auto& family : material.fibers->families)
        law.add(family_of(family.second, all.directions));
    if (material.viscosity) law.set_viscosity(viscosity_of(*material.viscosity));
    if (material.active_stress) law.set_active_stress(active_stress_of(material));
    if (material.growth) law.set_growth(growth_of(material));
    all.laws.push_back(law);
  }
  return all;
}

int states_of_materials(const NamedMaterials& materials) {
  int states = 0;
  for (const AnyLaw& law : laws_of(materials).laws) states = std::max(states, law.states_used());
  return states;
}

bool vary_in_stiffness(const NamedMaterials& materials) {
  return std::any_of(materials.begin(), materials.end(), [](const auto& named) {
    return named.second.fields && named.second.fields->of(VaryingNumber::shear_modulus);
  });
}

std::function<double(int, double)> shear_modulus_of(const NamedMaterials& materials) {
  std::vector<double> own;
  for (const auto& named : materials)
    own.push_back(model_of(named.second).law(named.second).small_strain().shear);
  return [materials, own](int material, double intensity) {
    const auto m = static_cast<std::size_t>(material);
    const auto& fields = materials[m].second.fields;
    const FieldParameters* field = fields ? fields->of(VaryingNumber::shear_modulus) : nullptr;
    return field ? field->at(intensity) : own[m];
  };
}

std::map<std::int32_t, int> material_of_label(const NamedMaterials& materials) {
  std::map<std::int32_t, int> index;
  for (std::size_t m = 0; m < materials.size(); ++m)
    index[materials[m].second.label] = static_cast<int>(m);
  return index;
}

}  // namespace stroma::material
