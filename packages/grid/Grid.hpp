// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The background grid: a Cartesian box of elements, and boxes of indices in it.

#include <algorithm>
#include <array>
#include <cstdint>

namespace stroma::grid {

using Index3 = std::array<std::int64_t, 3>;

/// A half-open box of indices [begin, end) in each direction; x runs fastest in local numbers.
struct Box {
  Index3 begin{0, 0, 0};
  Index3 end{0, 0, 0};

  std::int64_t extent(int d) const { return end[d] > begin[d] ? end[d] - begin[d] : 0; }
  std::int64_t count() const { return extent(0) * extent(1) * extent(2); }
  bool contains(const Index3& index) const {
    for (int d = 0; d < 3; ++d)
      if (index[d] < begin[d] || index[d] >= end[d]) return false;
    return true;
  }
  /// Local number of an index of the box.
  std::int64_t local(const Index3& index) const {
    return (index[0] - begin[0]) +
           extent(0) * ((index[1] - begin[1]) + extent(1) * (index[2] - begin[2]));
  }
  /// Index of a local number.
  Index3 index(std::int64_t number) const {
    return {begin[0] + number % extent(0), begin[1] + number / extent(0) % extent(1),
            begin[2] + number / (extent(0) * extent(1))};
  }
};

/// Calls f(index) for every index of a box, x fastest.
template <class Function>
void for_each_index(const Box& box, const Function& f) {
  for (std::int64_t k = box.begin[2]; k < box.end[2]; ++k)
    for (std::int64_t j = box.begin[1]; j < box.end[1]; ++j)
      for (std::int64_t i = box.begin[0]; i < box.end[0]; ++i) f(Index3{i, j, k});
}

/// Cartesian grid of box elements, and where its shape functions lie.
///
/// In each direction `width` functions are not zero in an element: element e holds the functions e
/// to e + width - 1, so there are elements + width - 1 of them. A function, with the unknowns that
/// it carries, is called a node, wherever it lies:
///
/// - hats (width 2): at the corners of elements, origin + f * spacing;
/// - averaged B-splines of degree p = width - 2 (p = 1: hats): each element is centred at a knot, a
///   node of the lattice. Function f is the (f - 1)th of the open knots and lies at its Greville
///   point, where the coefficient of a linear field is the field's value,
///       origin + spacing * (1/2 + 1/p sum_(k = 1..p) clamp(f - 1 - p + k, 0, elements - 1)).
///   The first and the last f stand for no function; no particle touches them.
struct Grid {
  Index3 elements{1, 1, 1};                      ///< elements per direction
  std::array<double, 3> origin{0.0, 0.0, 0.0};   ///< lower corner of element (0, 0, 0) [um]
  std::array<double, 3> spacing{1.0, 1.0, 1.0};  ///< size of an element [um]
  /// Plane strain: one element through z, whose lower and upper nodes are one and the same, for
  /// nothing varies along z. Half the unknowns, and none of the stiff modes across a thin slice.
  bool flat = false;
  int width = 2;          ///< shape functions per direction that an element sees
  bool centered = false;  ///< elements are centred at nodes of the lattice

  Box all_elements() const { return {{0, 0, 0}, elements}; }
  Box all_nodes() const {
    Box box = all_elements();
    for (int d = 0; d < 3; ++d) box.end[d] += beyond(d);
    return box;
  }
  /// Nodes along d beyond one per element; in plane strain there is one node along z.
  int beyond(int d) const { return flat && d == 2 ? 0 : width - 1; }
  double length(int d) const { return static_cast<double>(elements[d]) * spacing[d]; }
  /// Of all axes [um].
  std::array<double, 3> lengths() const { return {length(0), length(1), length(2)}; }
  std::array<double, 3> node_position(const Index3& node) const {
    std::array<double, 3> x;
    for (int d = 0; d < 3; ++d) x[d] = origin[d] + node_place(d, node[d]) * spacing[d];
    return x;
  }

 private:
  /// Where node f lies along d, in elements from the origin.
  double node_place(int d, std::int64_t f) const {
    if (flat && d == 2) return 0.0;
    if (!centered) return static_cast<double>(f);
    const int degree = width - 2;
    std::int64_t sum = 0;
    for (int k = 1; k <= degree; ++k)
      sum += std::clamp<std::int64_t>(f - 1 - degree + k, 0, elements[d] - 1);
    return 0.5 + static_cast<double>(sum) / degree;
  }
};

}  // namespace stroma::grid
