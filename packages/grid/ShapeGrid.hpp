// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The grid that a kind of shape functions needs over a lattice of nodes.

#include "stroma/grid/Partition.hpp"
#include "stroma/shape/ShapeFunctions.hpp"

namespace stroma::grid {

/// The grid for a kind of shape functions over the elements of a lattice. For all but hats the
/// elements are those centred at the lattice's nodes: a particle whose domain is no larger than an
/// element then reaches into the two spans beside the node in the middle, and no further.
Grid grid_for(shape::ShapeFunctions shape_functions, const Grid& lattice);

/// The same, dealt to the ranks with the cuts of a partition of the lattice.
Partition partition_for(shape::ShapeFunctions shape_functions, const Partition& lattice);

/// The lattice whose hats span what a grid of wider functions covers, dealt with the same cuts.
Partition lattice_under(const Partition& partition);

}  // namespace stroma::grid
