// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck section "Materials": what each label of the image is made of.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/deck/Section.hpp"
#include "stroma/material/NeoHookean.hpp"

namespace stroma::material {

enum class Model { neo_hookean };

struct MaterialParameters {
  int label = 0;
  Model model = Model::neo_hookean;
  double shear_modulus = 0.0;           ///< mu [Pa], > 0
  std::optional<double> poisson_ratio;  ///< nu, in (-1, 1/2); either this
  std::optional<double> bulk_modulus;   ///< or K [Pa], > 0
  VolumetricEnergy volumetric_energy = VolumetricEnergy::logarithmic;
  std::optional<double> density;  ///< rho [kg/m^3], > 0; where forces per mass act
};

/// Materials as the user named and ordered them. A material's place in the list is its index.
using NamedMaterials = std::vector<std::pair<std::string, MaterialParameters>>;

struct MaterialsParameters {
  NamedMaterials materials;
};

deck::Section<MaterialsParameters> materials_section();

/// K = 2 mu (1 + nu) / (3 (1 - 2 nu))  [Pa].
double bulk_modulus(double shear_modulus, double poisson_ratio);

/// The largest Poisson ratio of the materials, of at least one: as given, or (3 K - 2 mu) / (2 (3 K
/// + mu)).
double largest_poisson_ratio(const NamedMaterials& materials);

/// The law of each material, by index.
std::vector<NeoHookean> laws(const NamedMaterials& materials);

/// The index of the material of each label.
std::map<std::int32_t, int> material_of_label(const NamedMaterials& materials);

}  // namespace stroma::material
