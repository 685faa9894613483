// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A symmetric matrix of 3 x 3 blocks on the 27-point stencil of a rank's box of nodes.

#include "stroma/grid/NodeField.hpp"
#include "stroma/transfer/StencilRows.hpp"

namespace stroma::tangent {

/// This rank's part of a symmetric matrix: the sum over the ranks' parts is the matrix. No indices
/// are stored, only the upper half of the blocks, in single precision: 504 bytes a node. A product
/// reads them once, and uses each block for its own row and, transposed, for its neighbour's.
class Stencil {
 public:
  using Device = grid::Device;

  Stencil() = default;
  explicit Stencil(const grid::LevelGrid& grid);

  const transfer::StencilLayout& layout() const { return layout_; }
  const Kokkos::View<float*, Device>& values() const { return values_; }
  void zero() const { Kokkos::deep_copy(values_, 0.0f); }
  std::size_t bytes() const { return sizeof(float) * values_.extent(0); }

  /// partial y = K x for a consistent x. The same bit for bit for any number of threads.
  void multiply(const grid::NodeField<float>& x, const grid::NodeField<float>& y) const;
  void multiply(const grid::NodeField<double>& x, const grid::NodeField<double>& y) const;

 private:
  template <class T>
  void multiply_in(const grid::NodeField<T>& x, const grid::NodeField<T>& y) const;

  transfer::StencilLayout layout_;
  Kokkos::View<float*, Device> values_;
};

}  // namespace stroma::tangent
