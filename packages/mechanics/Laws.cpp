// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/Laws.hpp"

namespace stroma::mechanics {

Laws::Laws(const LawList& laws)
    : kernels([laws](grid::ShapeFunctions shape_functions, bool flat) {
        return stress_kernels(laws, shape_functions, flat);
      }) {
  for (const material::AnyLaw& law : laws.of_material) moduli.push_back(law.small_strain());
}

}  // namespace stroma::mechanics
