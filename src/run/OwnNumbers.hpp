// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Numbers and directions that differ from particle to particle: from the deck and its images to
/// Particles::own_numbers, and back to variables that are shown.

#include <string>
#include <vector>

#include "run/FieldImages.hpp"

namespace stroma {

/// What particles were given.
struct OwnNumbers {
  /// (material) which numbers of its law, as material::AnyLaw::let_vary() takes them.
  std::vector<std::vector<int>> which;
  /// The softest and stiffest of the particles of each material, one after the other.
  std::vector<material::SmallStrainModuli> extremes;
  std::vector<std::string> ranges;  ///< a line for each field: its least, greatest and mean value
  std::vector<std::string> notes;   ///< what is odd about them
};

/// Gives particles their own numbers. Collective.
/// \param images     where they come from
/// \param materials  the deck's
/// \param particles  as seeded
/// \throws base::InputError as FieldImages, and when a particle's law would be no admissible one
OwnNumbers give_own_numbers(const base::Communicator& communicator, FieldImages& images,
                            const material::NamedMaterials& materials,
                            particles::Particles<grid::Device>& particles);

/// A number of the laws that varies, as particles.e shows it.
struct ShownNumber {
  std::string name, unit;  ///< "shear_modulus", "Pa"
  std::vector<int>
      place;  ///< (material) in the order of AnyLaw::for_each_number(); -1: it has none
};

/// Each number that varies in some material; of others it is their own, or 0.
std::vector<ShownNumber> shown_numbers(const material::NamedMaterials& materials,
                                       const std::vector<std::vector<int>>& which);

}  // namespace stroma
