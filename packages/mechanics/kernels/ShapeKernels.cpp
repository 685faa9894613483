// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/ShapeKernels.hpp"

#include <stdexcept>

namespace stroma::mechanics {

std::shared_ptr<const ShapeKernels> kernels_for(shape::ShapeFunctions shape_functions, bool flat) {
  switch (shape_functions) {
    case shape::ShapeFunctions::linear:
      return linear_kernels();
    case shape::ShapeFunctions::gimp:
      return gimp_kernels(flat);
    case shape::ShapeFunctions::cpdi:
      return cpdi_kernels(flat);
    case shape::ShapeFunctions::quadratic_b_spline:
      return quadratic_b_spline_kernels(flat);
    case shape::ShapeFunctions::cubic_b_spline:
      return cubic_b_spline_kernels(flat);
  }
  throw std::logic_error("unknown shape functions");
}

}  // namespace stroma::mechanics
