// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/KernelsOf.hpp"
#include "stroma/shape/Linear.hpp"

namespace stroma::mechanics {

std::shared_ptr<const ShapeKernels> linear_kernels() {
  return std::make_shared<KernelsOf<shape::Linear>>();
}

}  // namespace stroma::mechanics
