// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/StressKernels.hpp"

#include <stdexcept>

namespace stroma::mechanics {

std::shared_ptr<const StressKernels> stress_kernels(const LawList& laws,
                                                    shape::ShapeFunctions shape_functions,
                                                    bool flat) {
  switch (shape_functions) {
    case shape::ShapeFunctions::linear:
      return linear_stress_kernels(laws);
    case shape::ShapeFunctions::gimp:
      return gimp_stress_kernels(laws, flat);
    case shape::ShapeFunctions::cpdi:
      return cpdi_stress_kernels(laws, flat);
    case shape::ShapeFunctions::quadratic_b_spline:
      return quadratic_b_spline_stress_kernels(laws, flat);
    case shape::ShapeFunctions::cubic_b_spline:
      return cubic_b_spline_stress_kernels(laws, flat);
  }
  throw std::logic_error("unknown shape functions");
}

}  // namespace stroma::mechanics
