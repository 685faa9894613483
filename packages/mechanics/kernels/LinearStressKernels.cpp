// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/StressKernelsOf.hpp"
#include "stroma/shape/Linear.hpp"

namespace stroma::mechanics {

extern template class StressKernelsOf<shape::Linear, material::AnyLaw>;

std::shared_ptr<const StressKernels> linear_stress_kernels(const LawList& laws) {
  return stress_kernels_of<shape::Linear>(laws);
}

}  // namespace stroma::mechanics
