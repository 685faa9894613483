// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/tangent/StencilMatrix.hpp"

namespace stroma::tangent {

using grid::NodeField;

StencilMatrix::StencilMatrix(const grid::Halo& halo, const Held& held, double diagonal)
    : halo_(&halo),
      held_(held),
      diagonal_(diagonal),
      exchange_(halo.communicator(), grid::LevelGrid(halo.partition(), halo.communicator().rank())),
      stencil_(exchange_.grid()),
      x_("stencil x", exchange_.grid()),
      y_("stencil y", exchange_.grid()) {}

transfer::StencilRows<grid::Device> StencilMatrix::begin() {
  stencil_.zero();
  return {stencil_.layout(), stencil_.values(), held_};
}

template <class T>
void StencilMatrix::to_field(const grid::MultiVector& v, std::size_t column,
                             const NodeField<T>& field) const {
  const grid::LevelGrid& grid = exchange_.grid();
  const int owned[3] = {grid.owned_nodes(0), grid.owned_nodes(1), grid.owned_nodes(2)};
  const auto column_view = v.getVector(column)->getLocalViewDevice(Tpetra::Access::ReadOnly);
  const double* const values = column_view.data();
  const std::uint8_t* const held = held_.data();
  grid::for_each_line(
      "vector to field", field.nodes, KOKKOS_LAMBDA(const int line, const int j, const int k) {
        const int n = field.nodes[0];
        const int m = j < owned[1] && k < owned[2] ? owned[0] : 0;
        const double* from = values + 3 * static_cast<std::size_t>(owned[0]) * (j + owned[1] * k);
        const std::uint8_t* bits = held + static_cast<std::size_t>(n) * line;
        for (int c = 0; c < 3; ++c) {
          T* const to = field.line(c, line);
          for (int i = 0; i < m; ++i) to[i] = bits[i] >> c & 1 ? T(0) : T(from[3 * i + c]);
          for (int i = m; i < n; ++i) to[i] = T(0);
        }
      });
  exchange_.sum(field);
}

template <class T>
void StencilMatrix::from_field(const NodeField<T>& field, const grid::MultiVector& v,
                               std::size_t column, double scale, double alpha, double beta,
                               grid::MultiVector& y) const {
  const grid::LevelGrid& grid = exchange_.grid();
  const int owned[3] = {grid.owned_nodes(0), grid.owned_nodes(1), grid.owned_nodes(2)};
  const auto v_column = v.getVector(column)->getLocalViewDevice(Tpetra::Access::ReadOnly);
  const auto y_column = y.getVectorNonConst(column)->getLocalViewDevice(Tpetra::Access::ReadWrite);
  const double* const v_values = v_column.data();
  double* const y_values = y_column.data();
  const std::uint8_t* const held = held_.data();
  grid::for_each_line(
      "field to vector", owned, KOKKOS_LAMBDA(const int owned_line, const int j, const int k) {
        const int line = j + field.nodes[1] * k;
        const std::size_t first = 3 * static_cast<std::size_t>(owned[0]) * owned_line;
        const std::uint8_t* bits = held + static_cast<std::size_t>(field.nodes[0]) * line;
        for (int c = 0; c < 3; ++c) {
          const T* const from = field.line(c, line);
          for (int i = 0; i < owned[0]; ++i) {
            const std::size_t n = first + static_cast<std::size_t>(3 * i + c);
            const double value = bits[i] >> c & 1 ? scale * v_values[n] : double(from[i]);
            y_values[n] = alpha * value + (beta == 0.0 ? 0.0 : beta * y_values[n]);
          }
        }
      });
}

template void StencilMatrix::to_field(const grid::MultiVector&, std::size_t,
                                      const NodeField<float>&) const;
template void StencilMatrix::from_field(const NodeField<float>&, const grid::MultiVector&,
                                        std::size_t, double, double, double,
                                        grid::MultiVector&) const;

void StencilMatrix::apply(const grid::MultiVector& x, grid::MultiVector& y, Teuchos::ETransp,
                          double alpha, double beta) const {
  for (std::size_t column = 0; column < x.getNumVectors(); ++column) {
    to_field(x, column, x_);
    stencil_.multiply(x_, y_);
    exchange_.sum(y_);
    from_field(y_, x, column, diagonal_, alpha, beta, y);
  }
}

}  // namespace stroma::tangent
