// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Materials and laws of fibres by the names that they have in decks, for tests that run no deck.

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "stroma/material/Models.hpp"

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

}  // namespace stroma::test
