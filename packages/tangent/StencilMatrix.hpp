// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The assembled tangent as a stencil, for Tpetra's clients.

#include <Tpetra_Operator.hpp>

#include "stroma/grid/BoxExchange.hpp"
#include "stroma/grid/Halo.hpp"
#include "stroma/tangent/Stencil.hpp"

namespace stroma::tangent {

/// The tangent without index arrays, in single precision, half of it: 504 bytes a node, where
/// compressed rows take 2,916. Fill it again and again:
///
///     launch(matrix.begin());   // adds the blocks of this rank's elements
///     matrix.finish();
///
/// Each rank keeps what its own elements contribute (a sub-assembled matrix): assembly exchanges
/// nothing, and a product sums at the layers of nodes that ranks share. Products are in double
/// precision; the entries' rounding, 6e-8 of each, changes a Newton direction by about as much and
/// the residual not at all.
///
/// Prescribed components have a row and a column that are zero but for a constant on the diagonal.
class StencilMatrix : public Tpetra::Operator<double> {
 public:
  using Device = grid::Device;
  using Held = Kokkos::View<std::uint8_t*, Device>;

  /// \param halo      outlives the matrix
  /// \param held      prescribed components (touched node), Supports::held()
  /// \param diagonal  what stands on the diagonal of prescribed components [pN/um]
  StencilMatrix(const grid::Halo& halo, const Held& held, double diagonal);

  /// Zeroes the matrix and says where the blocks of elements go.
  transfer::StencilRows<Device> begin();
  /// The blocks are complete: who keeps anything derived from them may tell by version().
  void finish() { ++version_; }
  long long version() const { return version_; }

  const Stencil& stencil() const { return stencil_; }
  const grid::BoxExchange& exchange() const { return exchange_; }
  const Held& held() const { return held_; }
  double held_diagonal() const { return diagonal_; }

  /// field = v at the touched nodes, consistent, and zero at prescribed components. Collective.
  template <class T>
  void to_field(const grid::MultiVector& v, std::size_t column,
                const grid::NodeField<T>& field) const;
  /// y = beta y + alpha (field, and scale * v at prescribed components).
  template <class T>
  void from_field(const grid::NodeField<T>& field, const grid::MultiVector& v, std::size_t column,
                  double scale, double alpha, double beta, grid::MultiVector& y) const;

  grid::RCP<const grid::Map> getDomainMap() const override { return halo_->owned_map(); }
  grid::RCP<const grid::Map> getRangeMap() const override { return halo_->owned_map(); }
  bool hasTransposeApply() const override { return true; }  // symmetric
  void apply(const grid::MultiVector& x, grid::MultiVector& y,
             Teuchos::ETransp mode = Teuchos::NO_TRANS, double alpha = 1.0,
             double beta = 0.0) const override;

 private:
  grid::Halo const* halo_;
  Held held_;
  double diagonal_;
  grid::BoxExchange exchange_;
  Stencil stencil_;
  grid::NodeField<double> x_, y_;  // of the products
  long long version_ = 0;
};

}  // namespace stroma::tangent
