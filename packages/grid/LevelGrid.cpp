// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/grid/LevelGrid.hpp"

#include <numeric>

namespace stroma::grid {

LevelGrid::LevelGrid(const Partition& partition, int rank) {
  int stride = 1;
  for (int d = 0; d < 3; ++d) {
    coordinate_[d] = rank / stride % partition.intervals(d);
    for (int n = 0; n < partition.intervals(d); ++n)
      elements_[d].push_back(
          partition.grid().flat && d == 2 ? 0 : partition.elements(n * stride).extent(d));
    stride *= partition.intervals(d);
  }
}

LevelGrid LevelGrid::coarsened(const std::array<bool, 3>& directions) const {
  LevelGrid coarse = *this;
  for (std::size_t d = 0; d < 3; ++d)
    if (directions[d])
      for (std::int64_t& count : coarse.elements_[d]) count = (count + 1) / 2;
  return coarse;
}

std::int64_t LevelGrid::all_elements(int d) const {
  return std::accumulate(elements_[d].begin(), elements_[d].end(), std::int64_t{0});
}

std::int64_t LevelGrid::all_nodes() const {
  return (all_elements(0) + 1) * (all_elements(1) + 1) * (all_elements(2) + 1);
}

int LevelGrid::nodes(int d) const {
  return static_cast<int>(elements_[d][static_cast<std::size_t>(coordinate_[d])]) + 1;
}

std::int64_t LevelGrid::first_node(int d) const {
  return std::accumulate(elements_[d].begin(), elements_[d].begin() + coordinate_[d],
                         std::int64_t{0});
}

int LevelGrid::stride(int d) const {
  int stride = 1;
  for (int lower = 0; lower < d; ++lower) stride *= static_cast<int>(elements_[lower].size());
  return stride;
}

int LevelGrid::lower_neighbour(int d) const {
  if (coordinate_[d] == 0) return -1;
  return coordinate_[0] + stride(1) * coordinate_[1] + stride(2) * coordinate_[2] - stride(d);
}

int LevelGrid::upper_neighbour(int d) const {
  if (coordinate_[d] + 1 == static_cast<int>(elements_[d].size())) return -1;
  return coordinate_[0] + stride(1) * coordinate_[1] + stride(2) * coordinate_[2] + stride(d);
}

}  // namespace stroma::grid
