// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/material/Material.hpp"

#include <algorithm>
#include <cstddef>

#include "stroma/material/Models.hpp"
#include "stroma/material/VaryingMaterial.hpp"

namespace stroma::material {

namespace {

constexpr std::array<double, 3> along_z{0.0, 0.0, 1.0};

/// One that particles turn is about z.
DistributionParameters distribution_of(const FiberParameters& fibers) {
  DistributionParameters where;
  where.distribution = fibers.distribution;
  where.direction = direction_in(fibers).value_or(where.direction);
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

/// \param directions_of  where the directions of a distribution are kept
template <class DirectionsOf>
AnyLaw law_of(const MaterialParameters& material, const DirectionsOf& directions_of) {
  AnyLaw law = model_of(material).law(material);
  if (material.fibers && !model_of(material).takes_directions)
    for (const auto& named : material.fibers->families) {
      const FiberParameters& given = named.second;
      FiberFamily family;
      family.law = fiber_models()[static_cast<std::size_t>(*given.law)].law(given);
      const std::array<double, 3> n = normalised(direction_in(given).value_or(along_z));
      std::copy(n.begin(), n.end(), family.own.n);
      family.own.weight = given.share;
      if (given.distribution != Distribution::single) {
        const FiberDirections directions = directions_of(given);
        family.directions = directions.data();
        family.count = static_cast<int>(directions.extent(0));
        family.are_turned = given.direction_from.has_value();
      }
      law.add(family);
    }
  if (material.viscosity) law.set_viscosity(viscosity_of(*material.viscosity));
  if (material.active_stress) law.set_active_stress(active_stress_of(material));
  if (material.growth) law.set_growth(growth_of(material));
  return law;
}

/// Of the matrix; to the deck's last digit where it says so.
double poisson_ratio_of(const MaterialParameters& material) {
  const auto given = material.numbers.find(poisson_ratio_name);
  return given != material.numbers.end()
             ? given->second
             : law_at_rest(material).matrix().small_strain().poisson_ratio();
}

}  // namespace

AnyLaw law_at_rest(const MaterialParameters& material) {
  return law_of(material, [](const FiberParameters&) { return FiberDirections(); });
}

Compressibility compressibility(const NamedMaterials& materials) {
  Compressibility all{-1.0};
  for (const auto& named : materials) {
    const MaterialParameters& material = named.second;
    all.may_be_averaged = all.may_be_averaged && law_at_rest(material).may_be_averaged();
    all.largest_poisson_ratio = std::max(all.largest_poisson_ratio, poisson_ratio_of(material));
    if (!material.fields) continue;
    for (const VaryingNumber& number : numbers_that_may_vary(material))
      for (const auto& field : material.fields->fields)
        if (field.second.parameter == number.name)
          for (const double value : field.second.values) {
            MaterialParameters other = material;
            number.in(other) = value;
            all.largest_poisson_ratio =
                std::max(all.largest_poisson_ratio, poisson_ratio_of(other));
          }
  }
  return all;
}

std::optional<std::array<double, 3>> direction_in(const FiberParameters& family) {
  if (family.direction || !family.direction_from) return family.direction;
  return along_z;
}

std::optional<std::array<double, 3>> direction_of(const MaterialParameters& material,
                                                  const std::optional<std::array<double, 3>>& own) {
  if (own || !material.fibers) return own;
  for (const auto& family : material.fibers->families)
    if (family.second.distribution == Distribution::single) return direction_in(family.second);
  return std::nullopt;
}

bool is_pressure(const MaterialParameters& material) {
  return model_of(material).name == Pressure::name();
}

bool is_neo_hookean_alone(const MaterialParameters& material) {
  return model_of(material).name == NeoHookean::name() && !material.fibers && !material.viscosity &&
         !material.active_stress && !material.growth && !material.fields;
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

int numbers_of_particles(const NamedMaterials& materials) {
  int most = 0;
  for (const auto& named : materials) {
    const MaterialParameters& m = named.second;
    int numbers = 0;
    if (m.fields)  // each with the modulus that follows by Poisson's ratio
      numbers += 2 * static_cast<int>(m.fields->fields.size());
    if (m.fibers)
      for (const auto& family : m.fibers->families)
        if (family.second.direction_from) numbers += 4;
    most = std::max(most, numbers);
  }
  return most;
}

bool vary(const NamedMaterials& materials) {
  return std::any_of(materials.begin(), materials.end(),
                     [](const auto& named) { return varies(named.second); });
}

bool read_the_specimens_image(const NamedMaterials& materials) {
  return std::any_of(materials.begin(), materials.end(), [](const auto& named) {
    const std::vector<const FieldImage*> images = images_of(named.second);
    return std::any_of(images.begin(), images.end(),
                       [](const FieldImage* image) { return image->is_the_specimens(); });
  });
}

std::map<std::int32_t, int> material_of_label(const NamedMaterials& materials) {
  std::map<std::int32_t, int> index;
  for (std::size_t m = 0; m < materials.size(); ++m)
    index[materials[m].second.label] = static_cast<int>(m);
  return index;
}

}  // namespace stroma::material
