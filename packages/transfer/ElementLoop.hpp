// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The loop over the elements of a rank that lets kernels add to nodes without atomics.

#include <Kokkos_Core.hpp>
#include <cstdint>
#include <string>

namespace stroma::transfer {

/// A rank's part of the grid as kernels see it: its box of elements, and the nodes they see. All
/// local numbers run x fastest.
struct ElementBox {
  int elements[3];            ///< elements per direction
  double corner[3];           ///< position of the lower corner of the first element [um]
  double spacing[3];          ///< element size [um]
  double inverse_spacing[3];  ///< [1/um]
  bool flat = false;          ///< plane strain: all nodes along z are one
  int beyond = 1;             ///< nodes per direction beyond the number of elements
  int first[3] = {0, 0, 0};   ///< number of the first element in the whole grid
  int all[3] = {0, 0, 0};     ///< elements of the whole grid
  bool centered = false;      ///< elements are centred at knots, the first and last at the ends

  KOKKOS_INLINE_FUNCTION int element(int i, int j, int k) const {
    return i + elements[0] * (j + elements[1] * k);
  }
  /// The part of element i along d that lies between the ends of the grid, in the element's natural
  /// coordinate: all of it, or the inner half of one that is centred at an end.
  KOKKOS_INLINE_FUNCTION void within_ends(int d, int i, double& lower, double& upper) const {
    const bool has_ends = centered && !(flat && d == 2);
    lower = has_ends && first[d] + i == 0 ? 0.5 : 0.0;
    upper = has_ends && first[d] + i == all[d] - 1 ? 0.5 : 1.0;
  }
  KOKKOS_INLINE_FUNCTION int node(int i, int j, int k) const {
    return i + (elements[0] + beyond) * (j + (elements[1] + beyond) * (flat ? 0 : k));
  }
};

/// Runs a functor on each line of elements along x whose (j, k) has one colour.
template <class Functor>
struct ElementLines {
  ElementBox box;
  Functor functor;
  int stride, first_j, first_k;

  KOKKOS_FUNCTION void operator()(const int line, std::int64_t& bad) const {
    const int lines_j = (box.elements[1] - first_j + stride - 1) / stride;
    const int j = first_j + stride * (line % lines_j);
    const int k = first_k + stride * (line / lines_j);
    for (int i = 0; i < box.elements[0]; ++i) functor(i, j, k, bad);
  }
};

/// Runs functor(i, j, k, bad) on every element (i, j, k) of the rank.
///
/// A line of elements along x is one work item, and lines are coloured so that no two items that
/// run at the same time share a node: the functor may add to the nodes of its element without
/// atomics. Every node is added to in an order that depends on the colours alone, so the sum is the
/// same bit for bit for any number of threads.
///
/// \tparam Width  nodes per direction of an element's support box (shape::Linear::width)
/// \return the sum of what the functor counted in `bad` (kernels cannot throw: they count)
template <int Width, class Space, class Functor>
std::int64_t for_each_element(const std::string& name, const ElementBox& box,
                              const Functor& functor) {
  std::int64_t bad = 0;
  for (int first_k = 0; first_k < Width && first_k < box.elements[2]; ++first_k)
    for (int first_j = 0; first_j < Width && first_j < box.elements[1]; ++first_j) {
      const int lines_j = (box.elements[1] - first_j + Width - 1) / Width;
      const int lines_k = (box.elements[2] - first_k + Width - 1) / Width;
      std::int64_t bad_of_colour = 0;
      Kokkos::parallel_reduce(
          name, Kokkos::RangePolicy<Space, Kokkos::Schedule<Kokkos::Static>>(0, lines_j * lines_k),
          ElementLines<Functor>{box, functor, Width, first_j, first_k}, bad_of_colour);
      bad += bad_of_colour;
    }
  return bad;
}

/// Runs functor(i, j, k, bad) on the elements of one layer k, in no order: for functors that write
/// to nothing but their own element's particles.
template <class Space, class Functor>
std::int64_t for_each_element_of_layer(const std::string& name, const ElementBox& box, int k,
                                       const Functor& functor) {
  std::int64_t bad = 0;
  Kokkos::parallel_reduce(
      name, Kokkos::RangePolicy<Space>(0, box.elements[1]),
      KOKKOS_LAMBDA(const int j, std::int64_t& sum) {
        for (int i = 0; i < box.elements[0]; ++i) functor(i, j, k, sum);
      },
      bad);
  return bad;
}

}  // namespace stroma::transfer
