// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/StressKernelsOf.hpp"
#include "stroma/shape/BSpline.hpp"

namespace stroma::mechanics {

extern template class StressKernelsOf<shape::BSpline<2, 2>, material::AnyLaw>;
extern template class StressKernelsOf<shape::BSpline<2, 3>, material::AnyLaw>;

std::shared_ptr<const StressKernels> quadratic_b_spline_stress_kernels(const LawList& laws,
                                                                       bool flat) {
  if (flat) return stress_kernels_of<shape::BSpline<2, 2>>(laws);
  return stress_kernels_of<shape::BSpline<2, 3>>(laws);
}

}  // namespace stroma::mechanics
