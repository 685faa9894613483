// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/problem/Laws.hpp"

#include <algorithm>

namespace stroma::mechanics {

Laws::Laws(const LawList& laws)
    : kernels([laws](shape::ShapeFunctions shape_functions, bool flat) {
        return stress_kernels(laws, shape_functions, flat);
      }) {
  for (const material::AnyLaw& law : laws.of_material) moduli.push_back(law.small_strain());
}

double Laws::stiffest_modulus() const {
  double stiffest = 0.0;
  for (const material::SmallStrainModuli& of_one : range())
    stiffest = std::max(stiffest, of_one.uniaxial_strain());
  return stiffest;
}

}  // namespace stroma::mechanics
