// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/grid/Partition.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::grid {
namespace {

/// Ranks per direction with the smallest surface between them.
Index3 rank_grid(const Grid& grid, int ranks) {
  Index3 best{0, 0, 0};
  double smallest = std::numeric_limits<double>::infinity();
  for (std::int64_t px = 1; px <= ranks; ++px) {
    if (ranks % px != 0 || px > grid.elements[0]) continue;
    for (std::int64_t py = 1; py <= ranks / px; ++py) {
      const std::int64_t pz = ranks / px / py;
      if (px * py * pz != ranks || py > grid.elements[1] || pz > grid.elements[2]) continue;
      const double nx = static_cast<double>(grid.elements[0]);
      const double ny = static_cast<double>(grid.elements[1]);
      const double nz = static_cast<double>(grid.elements[2]);
      const double surface = static_cast<double>(px - 1) * ny * nz +
                             static_cast<double>(py - 1) * nx * nz +
                             static_cast<double>(pz - 1) * nx * ny;
      // Of equal surfaces the last wins: cuts along z, in which images are stored.
      if (surface < smallest || (surface == smallest && pz > best[2])) {
        smallest = surface;
        best = {px, py, pz};
      }
    }
  }
  return best;
}

/// Cuts layers into intervals of about equal weight, each at least one layer thick.
std::vector<std::int64_t> cut(const std::vector<double>& weight, std::int64_t intervals) {
  const auto layers = static_cast<std::int64_t>(weight.size());
  const double total = std::accumulate(weight.begin(), weight.end(), 0.0);
  std::vector<std::int64_t> cuts{0};
  double passed = 0.0;
  std::int64_t layer = 0;
  for (std::int64_t n = 1; n < intervals; ++n) {
    const double target = total * static_cast<double>(n) / static_cast<double>(intervals);
    const std::int64_t last = layers - (intervals - n);  // leave a layer for each later interval
    do {
      passed += weight[static_cast<std::size_t>(layer++)];
    } while (layer < last && passed + 0.5 * weight[static_cast<std::size_t>(layer)] <= target);
    cuts.push_back(layer);
  }
  cuts.push_back(layers);
  return cuts;
}

}  // namespace

Partition::Partition(const Grid& grid, std::array<std::vector<std::int64_t>, 3> cuts)
    : grid_(grid), cuts_(std::move(cuts)) {
  first_node_.push_back(0);
  for (int rank = 0; rank < ranks(); ++rank)
    first_node_.push_back(first_node_.back() + owned_nodes(rank).count());
}

Partition Partition::balanced(const Grid& grid, int ranks,
                              const std::array<std::vector<double>, 3>& weights) {
  const Index3 shape = rank_grid(grid, ranks);
  if (shape[0] == 0) {
    throw base::InputError(base::format(
        "a grid of %lld x %lld x %lld elements cannot be dealt in boxes to %d ranks; run with "
        "fewer ranks",
        static_cast<long long>(grid.elements[0]), static_cast<long long>(grid.elements[1]),
        static_cast<long long>(grid.elements[2]), ranks));
  }
  return Partition(
      grid, {cut(weights[0], shape[0]), cut(weights[1], shape[1]), cut(weights[2], shape[2])});
}

Index3 Partition::coordinates(int rank) const {
  return {rank % intervals(0), rank / intervals(0) % intervals(1),
          rank / (intervals(0) * intervals(1))};
}

int Partition::interval_of(int d, std::int64_t element) const {
  const auto after = std::upper_bound(cuts_[d].begin(), cuts_[d].end(), element);
  return static_cast<int>(after - cuts_[d].begin()) - 1;
}

Box Partition::elements(int rank) const {
  const Index3 c = coordinates(rank);
  Box box;
  for (int d = 0; d < 3; ++d) {
    box.begin[d] = cuts_[d][static_cast<std::size_t>(c[d])];
    box.end[d] = cuts_[d][static_cast<std::size_t>(c[d]) + 1];
  }
  return box;
}

Box Partition::owned_nodes(int rank) const {
  Box box = elements(rank);
  for (int d = 0; d < 3; ++d)
    if (box.end[d] == grid_.elements[d]) box.end[d] += grid_.beyond(d);
  return box;
}

Box Partition::touched_nodes(int rank) const {
  Box box = elements(rank);
  for (int d = 0; d < 3; ++d) box.end[d] += grid_.beyond(d);
  return box;
}

int Partition::owner_of_element(const Index3& element) const {
  return interval_of(0, element[0]) +
         intervals(0) * (interval_of(1, element[1]) + intervals(1) * interval_of(2, element[2]));
}

int Partition::owner_of_node(const Index3& node) const {
  Index3 element = node;
  for (int d = 0; d < 3; ++d) element[d] = std::min(node[d], grid_.elements[d] - 1);
  return owner_of_element(element);
}

std::int64_t Partition::node_number(const Index3& node) const {
  const int owner = owner_of_node(node);
  return first_node(owner) + owned_nodes(owner).local(node);
}

}  // namespace stroma::grid
