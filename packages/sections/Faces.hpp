// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck's words for faces and for how conditions reach them.

#include <string>
#include <utility>
#include <vector>

#include "stroma/mechanics/problem/BoundaryConditions.hpp"

namespace stroma::sections {

/// The six faces of the body's box.
inline std::vector<std::pair<std::string, mechanics::Face>> single_faces() {
  using mechanics::Face;
  return {{"x-", Face::x_lower}, {"x+", Face::x_upper}, {"y-", Face::y_lower},
          {"y+", Face::y_upper}, {"z-", Face::z_lower}, {"z+", Face::z_upper}};
}

inline std::vector<std::pair<std::string, mechanics::ImposedBy>> ways_of_imposing() {
  using mechanics::ImposedBy;
  return {{"Nodes", ImposedBy::nodes}, {"Grip", ImposedBy::grip}, {"Penalty", ImposedBy::penalty}};
}

}  // namespace stroma::sections
