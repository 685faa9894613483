// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The hats under wider shape functions: what pictures of the grid and multigrid work with.

#include <Tpetra_CrsMatrix.hpp>

#include "stroma/grid/Halo.hpp"

namespace stroma::mechanics {

/// Goes between the coefficients c_f of shape functions of any width and the values v_n at the
/// nodes of the lattice under them (grid::lattice_under). Vectors hold three unknowns a node.
class Lattice {
 public:
  using Matrix = Tpetra::CrsMatrix<double>;

  /// \param functions  where the coefficients live. Collective.
  explicit Lattice(const grid::Halo& functions);

  const grid::Halo& halo() const { return halo_; }

  /// Values of the field at the nodes, v_n = sum_f N_f(x_n) c_f.
  void values_at_nodes(const grid::MultiVector& coefficients, grid::MultiVector& values) const {
    values_->apply(coefficients, values);
  }
  /// The forces on the functions that forces at the nodes are, N^T f: their power in any field is that
  /// of the forces in its values at the nodes.
  void to_functions(const grid::MultiVector& at_nodes, grid::MultiVector& forces) const {
    values_->apply(at_nodes, forces, Teuchos::TRANS);
  }
  /// Coefficients c = P v: the field of hats at the places of the functions. Linear fields pass
  /// exactly.
  void to_coefficients(const grid::MultiVector& values, grid::MultiVector& coefficients) const {
    interpolation_->apply(values, coefficients);
  }
  /// Forces at the nodes of the lattice, P^T f: the power of f in any field of hats, and so its
  /// sum.
  void forces_at_nodes(const grid::MultiVector& forces, grid::MultiVector& at_nodes) const {
    interpolation_->apply(forces, at_nodes, Teuchos::TRANS);
  }

 private:
  grid::Halo halo_;
  grid::RCP<const Matrix> interpolation_, values_;
};

}  // namespace stroma::mechanics
