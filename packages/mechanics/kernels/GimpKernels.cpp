// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/KernelsOf.hpp"
#include "stroma/shape/BSpline.hpp"

namespace stroma::mechanics {

std::shared_ptr<const ShapeKernels> gimp_kernels(bool flat) {
  if (flat) return std::make_shared<KernelsOf<shape::Gimp<2>>>();
  return std::make_shared<KernelsOf<shape::Gimp<3>>>();
}

}  // namespace stroma::mechanics
