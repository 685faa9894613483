// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/mechanics/problem/GridParameters.hpp"

namespace stroma::mechanics {

grid::Grid make_grid(const GridParameters& parameters, const std::array<double, 3>& length) {
  static const char* const axis[3] = {"x", "y", "z"};
  grid::Grid grid;
  std::string mistakes;
  for (int d = 0; d < 3; ++d) {
    if (parameters.elements) {
      grid.elements[d] = (*parameters.elements)[d];
    } else {
      const double size = (*parameters.element_size)[d];
      const double count = length[d] / size;
      grid.elements[d] = std::max<std::int64_t>(1, std::llround(count));
      if (std::abs(count - static_cast<double>(grid.elements[d])) > 1e-6) {
        const double fewer = std::max(1.0, std::floor(count));
        mistakes += base::format(
            "\n"
            "Grid|Element Size [um]: %.10g um does not divide the specimen's %.10g um along %s "
            "(%.4f elements); admissible near it: %.10g um (%.0f elements) or %.10g um (%.0f "
            "elements), or use Grid|Elements",
            size, length[d], axis[d], count, length[d] / fewer, fewer, length[d] / (fewer + 1.0),
            fewer + 1.0);
      }
    }
    grid.spacing[d] = length[d] / static_cast<double>(grid.elements[d]);
  }
  if (!mistakes.empty()) throw base::InputError(mistakes.substr(1));
  if (parameters.plane_strain && grid.elements[2] != 1) {
    throw base::InputError(
        base::format("Grid|Plane Strain: true needs one element through z, but the grid has %lld; "
                     "admissible: an element size of %.10g um along z, or a Region of the image "
                     "one slice thick",
                     static_cast<long long>(grid.elements[2]), length[2]));
  }
  grid.flat = parameters.plane_strain;
  return grid;
}

}  // namespace stroma::mechanics
