// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The assembled tangent as a Tpetra matrix.

#include <Tpetra_CrsMatrix.hpp>

#include "stroma/grid/Halo.hpp"
#include "stroma/transfer/Tangent.hpp"

namespace stroma::tangent {

using Matrix = Tpetra::CrsMatrix<double>;

/// A compressed row matrix over the unknowns of the nodes whose graph, a node and all its
/// neighbours within the shape functions' reach (width - 1: 27, 125, 343 or 729 blocks a row; in
/// plane strain 9, 25, 49 or 81), is built once, by arithmetic. It can be filled again and again:
///
///     launch(tangent.begin());   // adds the blocks of this rank's elements
///     tangent.finish();          // rows shared with neighbours go to their owners
///
/// Prescribed components keep their row and column, empty but for a constant on the diagonal, so
/// that the matrix stays symmetric and three by three blocked.
///
/// Memory: 12 bytes an entry, three entries a block and row.
class TangentMatrix {
 public:
  using Device = grid::Device;

  /// \param halo      this rank's nodes and their owners
  /// \param held      prescribed components (touched node), Supports::held()
  /// \param diagonal  what stands on the diagonal of prescribed components [pN/um]; of the size
  ///                  of the other diagonal entries, so that multigrid sees nothing odd
  TangentMatrix(const grid::Halo& halo, const Kokkos::View<std::uint8_t*, Device>& held,
                double diagonal);

  /// Zeroes the matrix and says where the blocks of elements go.
  transfer::BlockRows<Device> begin();
  /// Completes the rows of owned nodes. Collective.
  void finish();

  const grid::RCP<Matrix>& matrix() const { return matrix_; }

 private:
  void build_graph();
  void build_exchange();

  const grid::Halo* halo_;
  double diagonal_;
  grid::RCP<Matrix> matrix_;
  transfer::BlockRows<Device> rows_;
  int reach_, stencil_;  // of a row, in nodes per direction; blocks in all
  Kokkos::View<std::uint16_t**, Kokkos::LayoutRight, Device> slot_;
  Kokkos::View<int*, Device> row_;
  Kokkos::View<std::size_t*, Device> row_begin_;
  // Only with several ranks: blocks of nodes that others own, and of owned nodes that others touch.
  grid::RCP<grid::MultiVector> shared_, received_;
  grid::RCP<const Tpetra::Export<>> export_;
  Kokkos::View<int*, Device> received_node_;  // (row of received_) owned node
};

}  // namespace stroma::tangent
