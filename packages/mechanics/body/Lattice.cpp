// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/body/Lattice.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/shape/BSpline.hpp"

namespace stroma::mechanics {
namespace {

/// Indices along one axis, each with its weight.
using Weights = std::vector<std::pair<std::int64_t, double>>;

/// The averaged B-splines' own values at a node of the lattice, which has one more node than the
/// grid has knots at either end.
template <int Degree>
Weights b_splines_at(const grid::Grid& grid, int d, std::int64_t node) {
  const auto elements = static_cast<int>(grid.elements[d]);
  const int knot = static_cast<int>(node) - 1;
  shape::Place place{};
  place.element[d] = std::clamp(knot, 0, elements - 1);
  place.elements[d] = elements;
  double value[Degree + 2];
  shape::BSplineAxis<Degree>::at(place, d, knot - place.element[d], value);
  Weights weights;
  for (int f = 0; f < Degree + 2; ++f)
    if (value[f] != 0.0) weights.emplace_back(place.element[d] + f, value[f]);
  return weights;
}

/// The functions that are not zero at a node of the lattice, along d.
Weights functions_at(const grid::Grid& grid, int d, std::int64_t node) {
  if (grid.beyond(d) == 0 || !grid.centered) return {{node, 1.0}};
  if (grid.width == 3) return b_splines_at<1>(grid, d, node);
  if (grid.width == 4) return b_splines_at<2>(grid, d, node);
  if (grid.width == 5) return b_splines_at<3>(grid, d, node);
  throw std::logic_error("shape functions of unknown width");
}

/// The nodes of the lattice between which a position lies, along d.
Weights nodes_around(const grid::Grid& lattice, int d, double x) {
  if (lattice.beyond(d) == 0) return {{0, 1.0}};
  const auto elements = static_cast<double>(lattice.elements[d]);
  const double s = std::clamp((x - lattice.origin[d]) / lattice.spacing[d], 0.0, elements);
  const double below = std::min(std::floor(s + 1e-9), elements - 1.0);
  const double above = s - below;
  const auto node = static_cast<std::int64_t>(below);
  Weights weights;
  if (std::abs(above - 1.0) > 1e-9) weights.emplace_back(node, 1.0 - above);
  if (std::abs(above) > 1e-9) weights.emplace_back(node + 1, above);
  return weights;
}

/// A matrix of three unknowns a node whose rows are products of weights along the axes.
/// \param along  along(d, row node) -> Weights over column nodes
template <class Along>
grid::RCP<const Lattice::Matrix> tensor_product(const grid::Halo& rows, const grid::Halo& columns,
                                                const Along& along) {
  const auto matrix = Teuchos::rcp(new Lattice::Matrix(rows.owned_map(), 64));
  const grid::Partition& of_rows = rows.partition();
  const grid::Partition& of_columns = columns.partition();
  grid::for_each_index(
      of_rows.owned_nodes(rows.communicator().rank()), [&](const grid::Index3& node) {
        const Weights x = along(0, node), y = along(1, node), z = along(2, node);
        Teuchos::Array<grid::GlobalOrdinal> column;
        Teuchos::Array<double> weight;
        for (const auto& [k, wz] : z)
          for (const auto& [j, wy] : y)
            for (const auto& [i, wx] : x) {
              column.push_back(3 * of_columns.node_number({i, j, k}));
              weight.push_back(wx * wy * wz);
            }
        for (int c = 0; c < 3; ++c) {
          matrix->insertGlobalValues(3 * of_rows.node_number(node) + c, column(), weight());
          for (auto& number : column) ++number;
        }
      });
  matrix->fillComplete(columns.owned_map(), rows.owned_map());
  return matrix;
}

}  // namespace

Lattice::Lattice(const grid::Halo& functions)
    : halo_(functions.communicator(), grid::lattice_under(functions.partition())) {
  const grid::Grid& grid = functions.partition().grid();
  const grid::Grid& lattice = halo_.partition().grid();
  interpolation_ = tensor_product(functions, halo_, [&](int d, const grid::Index3& function) {
    return nodes_around(lattice, d, grid.node_position(function)[static_cast<std::size_t>(d)]);
  });
  values_ = tensor_product(halo_, functions, [&](int d, const grid::Index3& node) {
    return functions_at(grid, d, node[static_cast<std::size_t>(d)]);
  });
}

}  // namespace stroma::mechanics
