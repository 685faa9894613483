// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/KernelsOf.hpp"
#include "stroma/shape/BSpline.hpp"

namespace stroma::mechanics {

std::shared_ptr<const ShapeKernels> quadratic_b_spline_kernels(bool flat) {
  if (flat) return std::make_shared<KernelsOf<shape::BSpline<2, 2>>>();
  return std::make_shared<KernelsOf<shape::BSpline<2, 3>>>();
}

}  // namespace stroma::mechanics
