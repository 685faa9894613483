// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/grid/ShapeGrid.hpp"

namespace stroma::grid {

Grid grid_for(shape::ShapeFunctions shape_functions, const Grid& lattice) {
  Grid grid = lattice;
  grid.width = shape::kind_of(shape_functions).width;
  grid.centered = shape::kind_of(shape_functions).is_centered;
  if (!grid.centered) return grid;
  for (int d = 0; d < (grid.flat ? 2 : 3); ++d) {
    grid.origin[d] -= 0.5 * grid.spacing[d];
    ++grid.elements[d];
  }
  return grid;
}

Partition partition_for(shape::ShapeFunctions shape_functions, const Partition& lattice) {
  const Grid grid = grid_for(shape_functions, lattice.grid());
  std::array<std::vector<std::int64_t>, 3> cuts;
  for (int d = 0; d < 3; ++d) {
    cuts[d] = lattice.cuts(d);
    cuts[d].back() = grid.elements[d];
  }
  return Partition(grid, cuts);
}

Partition lattice_under(const Partition& partition) {
  Grid lattice = partition.grid();
  lattice.width = 2;
  lattice.centered = false;
  std::array<std::vector<std::int64_t>, 3> cuts;
  for (int d = 0; d < 3; ++d) {
    cuts[d] = partition.cuts(d);
    if (!partition.grid().centered || partition.grid().beyond(d) == 0) continue;
    lattice.origin[d] -= 0.5 * lattice.spacing[d];
    ++lattice.elements[d];
    cuts[d].back() = lattice.elements[d];
  }
  return Partition(lattice, cuts);
}

}  // namespace stroma::grid
