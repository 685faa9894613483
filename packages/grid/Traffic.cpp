// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/grid/Traffic.hpp"

#include <algorithm>

namespace stroma::grid {

Traffic& Traffic::operator+=(const Traffic& other) {
  neighbours = std::max(neighbours, other.neighbours);
  messages += other.messages;
  bytes += other.bytes;
  reductions += other.reductions;
  reduced_bytes += other.reduced_bytes;
  return *this;
}

Traffic operator*(std::int64_t times, Traffic traffic) {
  traffic.messages *= times;
  traffic.bytes *= times;
  traffic.reductions *= times;
  traffic.reduced_bytes *= times;
  return traffic;
}

Traffic box_sum_traffic(const LevelGrid& grid, std::int64_t bytes_per_value) {
  Traffic traffic;
  for (int d = 0; d < 3; ++d) {
    const std::int64_t face = std::int64_t{grid.nodes((d + 1) % 3)} * grid.nodes((d + 2) % 3);
    for (const int neighbour : {grid.lower_neighbour(d), grid.upper_neighbour(d)}) {
      if (neighbour < 0) continue;
      ++traffic.neighbours;
      ++traffic.messages;
      traffic.bytes += 3 * face * bytes_per_value;
    }
  }
  return traffic;
}

Traffic rows_product_traffic(const Partition& partition, int rank) {
  const int px = partition.intervals(0), py = partition.intervals(1), pz = partition.intervals(2);
  const Index3 here{rank % px, rank / px % py, rank / (px * py)};
  const Box own = partition.owned_nodes(rank);
  Traffic traffic;
  // Every box of elements is at least one element thick: nobody's stencils reach further than that.
  const std::int64_t reach = partition.grid().width - 1;
  const Box steps{{-reach, -reach, -reach}, {reach + 1, reach + 1, reach + 1}};
  for_each_index(steps, [&](const Index3& step) {
    Index3 there;
    for (int d = 0; d < 3; ++d) there[d] = here[d] + step[d];
    if (!Box{{0, 0, 0}, {px, py, pz}}.contains(there) || there == here) return;
    const Box theirs =
        partition.owned_nodes(static_cast<int>(there[0] + px * (there[1] + py * there[2])));
    Box wanted;
    for (int d = 0; d < 3; ++d) {
      wanted.begin[d] = std::max(own.begin[d], theirs.begin[d] - reach);
      wanted.end[d] = std::min(own.end[d], theirs.end[d] + reach);
    }
    if (wanted.count() == 0) return;
    ++traffic.neighbours;
    ++traffic.messages;
    traffic.bytes += 3 * wanted.count() * std::int64_t{sizeof(double)};
  });
  return traffic;
}

}  // namespace stroma::grid
