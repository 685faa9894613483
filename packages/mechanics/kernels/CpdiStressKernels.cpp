// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/StressKernelsOf.hpp"
#include "stroma/shape/Cpdi.hpp"

namespace stroma::mechanics {

extern template class StressKernelsOf<shape::Cpdi<2>, material::AnyLaw>;
extern template class StressKernelsOf<shape::Cpdi<3>, material::AnyLaw>;

std::shared_ptr<const StressKernels> cpdi_stress_kernels(const LawList& laws, bool flat) {
  if (flat) return stress_kernels_of<shape::Cpdi<2>>(laws);
  return stress_kernels_of<shape::Cpdi<3>>(laws);
}

}  // namespace stroma::mechanics
