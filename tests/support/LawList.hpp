// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Laws of a specimen's labels, from a material of a deck.

#include "stroma/mechanics/kernels/StressKernels.hpp"
#include "support/NamedMaterial.hpp"

namespace stroma::test {

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
