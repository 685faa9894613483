// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The kinds of shape functions, and what the grid must know of each.

#include <array>
#include <cstddef>

namespace stroma::shape {

enum class ShapeFunctions { linear, gimp, cpdi, quadratic_b_spline, cubic_b_spline };

struct ShapeKind {
  ShapeFunctions kind;
  const char* name;  ///< in the deck
  int width;         ///< nodes along an axis that a particle reaches
  bool is_centered;  ///< elements are centred at nodes of the lattice
  bool locks;        ///< too stiff near incompressibility without a mean dilatation
};

/// Every kind once, in the order of the enumeration.
inline constexpr std::array<ShapeKind, 5> shape_kinds{
    {{ShapeFunctions::linear, "Linear", 2, false, true},
     {ShapeFunctions::gimp, "GIMP", 3, true, true},
     {ShapeFunctions::cpdi, "CPDI", 3, true, true},
     {ShapeFunctions::quadratic_b_spline, "Quadratic B-Spline", 4, true, false},
     {ShapeFunctions::cubic_b_spline, "Cubic B-Spline", 5, true, false}}};

constexpr const ShapeKind& kind_of(ShapeFunctions functions) {
  return shape_kinds[static_cast<std::size_t>(functions)];
}

}  // namespace stroma::shape
