// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/KernelsOf.hpp"
#include "stroma/shape/Cpdi.hpp"

namespace stroma::mechanics {

std::shared_ptr<const ShapeKernels> cpdi_kernels(bool flat) {
  if (flat) return std::make_shared<KernelsOf<shape::Cpdi<2>>>();
  return std::make_shared<KernelsOf<shape::Cpdi<3>>>();
}

}  // namespace stroma::mechanics
