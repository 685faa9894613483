// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The laws as the deck sees them: names, parameters, and how a material's numbers make one.

#include <functional>
#include <string>
#include <vector>

#include "stroma/material/Material.hpp"

namespace stroma::material {

/// One number of a model, or one list of numbers.
struct ModelNumber {
  std::string name, meaning;
  Range admissible;
  bool or_poisson_ratio;  ///< "Poisson Ratio" may stand in its place
  int longest = 0;        ///< of a list, the most numbers that it may have; 0: no list
};

/// A name that the deck gives a law, and the numbers that go with it.
struct NamedNumbers {
  std::string name, meaning;
  std::vector<ModelNumber> numbers;

  bool takes_poisson_ratio() const;
  bool takes(const std::string& number) const;
  /// "Shear Modulus [Pa], Bulk Modulus [Pa] or Poisson Ratio".
  std::string listing() const;
};

/// One admissible value of `Model`.
struct Model : NamedNumbers {
  bool has_volumetric_energy = false;
  bool takes_directions = false;  ///< of Fibers it takes the directions, and no laws
  bool is_isochoric = true;       ///< W1 does not change with the volume
  /// The law with a material's numbers, all of which must be there.
  std::function<AnyMatrix(const MaterialParameters&)> law;
};

/// One admissible value of `Fibers|FAMILY|Law`.
struct FiberModel : NamedNumbers {
  std::function<AnyFiberLaw(const FiberParameters&)> law;
};

/// All of them, in the order of the list of laws.
const std::vector<Model>& models();
const std::vector<FiberModel>& fiber_models();
/// The one that a material names.
const Model& model_of(const MaterialParameters& material);

inline constexpr const char* poisson_ratio_name = "Poisson Ratio";

}  // namespace stroma::material
