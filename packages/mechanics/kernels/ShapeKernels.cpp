// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/ShapeKernels.hpp"

#include <stdexcept>

namespace stroma::mechanics {

std::shared_ptr<const ShapeKernels> kernels_for(grid::ShapeFunctions shape_functions, bool flat) {
  switch (shape_functions) {
    case grid::ShapeFunctions::linear:
      return linear_kernels();
    case grid::ShapeFunctions::gimp:
      return gimp_kernels(flat);
    case grid::ShapeFunctions::cpdi:
      return cpdi_kernels(flat);
    case grid::ShapeFunctions::quadratic_b_spline:
      return quadratic_b_spline_kernels(flat);
    case grid::ShapeFunctions::cubic_b_spline:
      return cubic_b_spline_kernels(flat);
  }
  throw std::logic_error("unknown shape functions");
}

}  // namespace stroma::mechanics
