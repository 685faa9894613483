// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/multigrid/CoarsestGrid.hpp"

#include <algorithm>
#include <cmath>

namespace stroma::multigrid {
namespace {

constexpr double least_raise = 1e-6, next_raise = 100.0, most_raise = 100.0;  // of the diagonal

/// Nodes per direction, and the order of directions from the shortest.
std::array<std::int64_t, 3> node_counts(const grid::LevelGrid& grid) {
  return {grid.all_elements(0) + 1, grid.all_elements(1) + 1, grid.all_elements(2) + 1};
}

std::size_t half_band(const grid::LevelGrid& grid) {
  auto counts = node_counts(grid);
  std::sort(counts.begin(), counts.end());
  return static_cast<std::size_t>(3 * (counts[0] * counts[1] + counts[0] + 1) + 2);
}

/// Factorises A + raise D, D the diagonal of a band matrix, in place: L L^T, A(j + r, j) at values[j
/// (b + 1) + r]. If no direction of A is negative no pivot is below raise D: at the first below half
/// of that it gives up.
///
/// \return whether it did not
bool cholesky(std::vector<double>& values, std::size_t unknowns, std::size_t band, double raise) {
  const std::size_t pitch = band + 1;
  std::vector<double> smallest(unknowns);
  for (std::size_t j = 0; j < unknowns; ++j) {
    double& diagonal = values[j * pitch];
    if (!(diagonal > 0.0)) diagonal = 1.0;
    smallest[j] = 0.5 * raise * diagonal;
    diagonal *= 1.0 + raise;
  }
  for (std::size_t j = 0; j < unknowns; ++j) {
    double* const column = &values[j * pitch];
    if (!(column[0] >= smallest[j])) return false;
    column[0] = std::sqrt(column[0]);
    const std::size_t last = std::min(band, unknowns - 1 - j);
    for (std::size_t r = 1; r <= last; ++r) column[r] /= column[0];
    for (std::size_t s = 1; s <= last; ++s) {
      const double factor = column[s];
      if (factor == 0.0) continue;
      double* __restrict target = &values[(j + s) * pitch];
      const double* __restrict source = column + s;
      for (std::size_t r = 0; r <= last - s; ++r) target[r] -= factor * source[r];
    }
  }
  return true;
}

}  // namespace

double CoarsestGrid::size(const grid::LevelGrid& grid) {
  return 3.0 * static_cast<double>(grid.all_nodes()) * static_cast<double>(half_band(grid) + 1);
}

double CoarsestGrid::work(const grid::LevelGrid& grid) {
  return size(grid) * static_cast<double>(half_band(grid));
}

CoarsestGrid::CoarsestGrid(const grid::LevelGrid& grid)
    : unknowns_(static_cast<std::size_t>(3 * grid.all_nodes())), band_(half_band(grid)) {
  const auto counts = node_counts(grid);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return counts[a] < counts[b]; });
  std::int64_t stride = 1;
  for (const std::size_t d : order) {
    stride_[d] = stride;
    stride *= counts[d];
  }
  band_ = std::min(band_, unknowns_ - 1);
}

std::int64_t CoarsestGrid::unknown(const std::array<std::int64_t, 3>& node, int component) const {
  return 3 * (node[0] * stride_[0] + node[1] * stride_[1] + node[2] * stride_[2]) + component;
}

void CoarsestGrid::factorize(const tangent::Stencil& stencil, const grid::BoxExchange& exchange) {
  for (double raise = least_raise; raise <= most_raise; raise *= next_raise) {
    assemble(stencil, exchange);
    const bool is_definite = cholesky(factor_, unknowns_, band_, raise);
    if (!exchange.communicator().any(!is_definite)) return;
  }
}

void CoarsestGrid::assemble(const tangent::Stencil& stencil, const grid::BoxExchange& exchange) {
  const grid::LevelGrid& grid = exchange.grid();
  const transfer::StencilLayout& layout = stencil.layout();
  const std::size_t pitch = band_ + 1;
  factor_.assign(unknowns_ * pitch, 0.0);
  for (int k = 0; k < layout.nodes[2]; ++k)
    for (int j = 0; j < layout.nodes[1]; ++j)
      for (int i = 0; i < layout.nodes[0]; ++i)
        for (int s = 13; s < 27; ++s) {
          const int dx = s % 3 - 1, dy = s / 3 % 3 - 1, dz = s / 9 - 1;
          if (i + dx < 0 || i + dx >= layout.nodes[0] || j + dy < 0 || j + dy >= layout.nodes[1] ||
              k + dz >= layout.nodes[2])
            continue;
          const std::array<std::int64_t, 3> here{grid.first_node(0) + i, grid.first_node(1) + j,
                                                 grid.first_node(2) + k};
          const std::array<std::int64_t, 3> there{here[0] + dx, here[1] + dy, here[2] + dz};
          for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) {
              std::int64_t row = unknown(here, a), column = unknown(there, b);
              if (s == 13 && row < column) continue;  // stored in full
              if (row < column) std::swap(row, column);
              factor_[static_cast<std::size_t>(column) * pitch +
                      static_cast<std::size_t>(row - column)] +=
                  static_cast<double>(stencil.values()(
                      layout.place(j + layout.nodes[1] * k, 9 * (s - 13) + 3 * a + b, i)));
            }
        }
  for (std::size_t begin = 0; begin < factor_.size(); begin += 1 << 24)  // counts are ints
    exchange.communicator().sum_all(&factor_[begin],
                                    std::min<std::size_t>(1 << 24, factor_.size() - begin));
}

void CoarsestGrid::solve(const grid::NodeField<float>& b, const grid::NodeField<float>& x,
                         const grid::BoxExchange& exchange) const {
  const grid::LevelGrid& grid = exchange.grid();
  std::vector<double> v(unknowns_, 0.0);
  const auto for_each_value = [&](bool owned_only, const auto& visit) {
    int end[3];
    for (int d = 0; d < 3; ++d) end[d] = owned_only ? grid.owned_nodes(d) : grid.nodes(d);
    for (int k = 0; k < end[2]; ++k)
      for (int j = 0; j < end[1]; ++j)
        for (int c = 0; c < 3; ++c)
          for (int i = 0; i < end[0]; ++i)
            visit(
                v[static_cast<std::size_t>(unknown(
                    {grid.first_node(0) + i, grid.first_node(1) + j, grid.first_node(2) + k}, c))],
                c, j + grid.nodes(1) * k, i);
  };
  for_each_value(true, [&](double& value, int c, int line, int i) { value = b.line(c, line)[i]; });
  exchange.communicator().sum_all(v.data(), v.size());
  const std::size_t pitch = band_ + 1;
  for (std::size_t j = 0; j < unknowns_; ++j) {
    const double* column = &factor_[j * pitch];
    const std::size_t last = std::min(band_, unknowns_ - 1 - j);
    const double value = v[j] /= column[0];
    for (std::size_t r = 1; r <= last; ++r) v[j + r] -= column[r] * value;
  }
  for (std::size_t j = unknowns_; j-- > 0;) {
    const double* column = &factor_[j * pitch];
    const std::size_t last = std::min(band_, unknowns_ - 1 - j);
    double value = v[j];
    for (std::size_t r = 1; r <= last; ++r) value -= column[r] * v[j + r];
    v[j] = value / column[0];
  }
  for_each_value(false, [&](double& value, int c, int line, int i) {
    x.line(c, line)[i] = static_cast<float>(value);
  });
}

}  // namespace stroma::multigrid
