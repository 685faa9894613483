// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a rank sends to others, found by arithmetic from the partition: of any rank of any number
/// of ranks, without running on them.

#include <cstdint>

#include "stroma/grid/LevelGrid.hpp"

namespace stroma::grid {

/// What one rank sends in some piece of work, and in how many sums over all ranks it takes part.
struct Traffic {
  int neighbours = 0;              ///< ranks that it sends to
  std::int64_t messages = 0;       ///< sent to neighbours
  std::int64_t bytes = 0;          ///< in these messages
  std::int64_t reductions = 0;     ///< sums over all ranks (MPI_Allreduce)
  std::int64_t reduced_bytes = 0;  ///< of them all together, as each rank puts in

  Traffic& operator+=(const Traffic& other);
};

/// The same work several times.
Traffic operator*(std::int64_t times, Traffic traffic);

/// One BoxExchange::sum() of values of a size, for the rank that the grid is seen from.
Traffic box_sum_traffic(const LevelGrid& grid, std::int64_t bytes_per_value);

/// One product of a matrix in compressed rows: each rank sends the values (doubles) of its own
/// nodes that lie within the stencils of another rank's nodes.
Traffic rows_product_traffic(const Partition& partition, int rank);

}  // namespace stroma::grid
