// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/material/Material.hpp"

#include <algorithm>
#include <cstddef>

#include "stroma/material/Models.hpp"

namespace stroma::material {

namespace {

DistributionParameters distribution_of(const FiberParameters& fibers) {
  DistributionParameters where;
  where.distribution = fibers.distribution;
  where.direction = fibers.direction.value_or(where.direction);
  where.axes = fibers.axes.value_or(where.axes);
  where.concentration = fibers.concentration.value_or(where.concentration);
  where.quadrature = fibers.quadrature.value_or(where.quadrature);
  return where;
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
  const auto n = normalised(*direction);
  std::copy(n.begin(), n.end(), drive.direction);
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

/// \param directions_of  where the directions of a family are kept
template <class DirectionsOf>
AnyLaw law_of(const MaterialParameters& material, const DirectionsOf& directions_of) {
  AnyLaw law = model_of(material).law(material);
  if (material.fibers && !model_of(material).takes_directions)
    for (const auto& [name, family] : material.fibers->families) {
      const FiberDirections directions = directions_of(family);
      law.add({fiber_models()[static_cast<std::size_t>(*family.law)].law(family), directions.data(),
               static_cast<int>(directions.extent(0))});
    }
  if (material.viscosity) law.set_viscosity(viscosity_of(*material.viscosity));
  if (material.active_stress) law.set_active_stress(active_stress_of(material));
  if (material.growth) law.set_growth(growth_of(material));
  return law;
}

/// Without directions of fibres: enough for all but stress.
AnyLaw law_at_rest(const MaterialParameters& material) {
  return law_of(material, [](const FiberParameters&) { return FiberDirections(); });
}

}  // namespace

Compressibility compressibility(const NamedMaterials& materials) {
  Compressibility all{-1.0};
  for (const auto& [name, m] : materials) {
    const AnyLaw law = law_at_rest(m);
    const auto given = m.numbers.find(poisson_ratio_name);
    all.largest_poisson_ratio = std::max(
        all.largest_poisson_ratio,
        given != m.numbers.end() ? given->second : law.matrix().small_strain().poisson_ratio());
    all.may_be_averaged = all.may_be_averaged && law.may_be_averaged();
  }
  return all;
}

std::optional<std::array<double, 3>> direction_of(const MaterialParameters& material,
                                                  const std::optional<std::array<double, 3>>& own) {
  if (own || !material.fibers) return own;
  for (const auto& family : material.fibers->families)
    if (family.second.distribution == Distribution::single) return family.second.direction;
  return std::nullopt;
}

MaterialLaws laws_of(const NamedMaterials& materials) {
  MaterialLaws all;
  for (const auto& named : materials)
    all.laws.push_back(law_of(named.second, [&](const FiberParameters& family) {
      const std::vector<FiberDirection> list = directions(distribution_of(family));
      const FiberDirections on_device("fiber directions", list.size());
      const auto on_host = Kokkos::create_mirror_view(on_device);
      std::copy(list.begin(), list.end(), on_host.data());
      Kokkos::deep_copy(on_device, on_host);
      return all.directions.emplace_back(on_device);
    }));
  return all;
}

std::vector<SmallStrainModuli> moduli_of(const NamedMaterials& materials) {
  std::vector<SmallStrainModuli> moduli;
  for (const auto& named : materials) moduli.push_back(law_at_rest(named.second).small_strain());
  return moduli;
}

int states_of_materials(const NamedMaterials& materials) {
  int states = 0;
  for (const auto& named : materials)
    states = std::max(states, law_at_rest(named.second).states_used());
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
    own.push_back(law_at_rest(named.second).matrix().small_strain().shear);
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
