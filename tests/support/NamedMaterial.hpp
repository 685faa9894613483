// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Materials and laws of fibres by the names that they have in decks, for tests that run no deck.

#include <array>
#include <map>
#include <stdexcept>
#include <string>

#include "stroma/material/Models.hpp"
#include "stroma/mechanics/kernels/StressKernels.hpp"

namespace stroma::test {

/// The place of a law in the deck's list of them.
template <class Models>
int place_of(const std::string& name, const Models& models) {
  for (std::size_t n = 0; n < models.size(); ++n)
    if (models[n].name == name) return static_cast<int>(n);
  throw std::runtime_error("no law " + name);
}

inline material::MaterialParameters material_of(
    const std::string& model, const std::map<std::string, double>& numbers,
    const std::map<std::string, std::vector<double>>& lists = {}) {
  material::MaterialParameters material;
  material.model = place_of(model, material::models());
  material.numbers = numbers;
  material.lists = lists;
  return material;
}

/// A family in one direction; the caller may change where it points.
inline material::FiberParameters fibers_of(const std::string& law,
                                           const std::map<std::string, double>& numbers,
                                           const std::array<double, 3>& direction) {
  material::FiberParameters family;
  family.law = place_of(law, material::fiber_models());
  family.numbers = numbers;
  family.direction = direction;
  return family;
}

/// The law of a material, `count` times, with the directions of its fibres.
inline mechanics::LawList law_list(const material::MaterialParameters& material,
                                   std::size_t count) {
  material::NamedMaterials all;
  for (std::size_t n = 0; n < count; ++n) all.emplace_back("law " + std::to_string(n), material);
  const material::MaterialLaws made = material::laws_of(all);
  mechanics::LawList list;
  list.of_material = made.laws;
  list.directions = made.directions;
  return list;
}

}  // namespace stroma::test
