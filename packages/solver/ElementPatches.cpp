#include "solver/ElementPatches.hpp"

#include <algorithm>
#include <cmath>

namespace stroma::solver {
namespace {

using grid::NodeField;
using transfer::StencilLayout;

/// A pivot of less than this share of its diagonal entry is what rounding in single precision left.
constexpr double smallest_pivot = 1e-6;

/// Puts C = D^-1/2 L^-1 in place of the symmetric A = L D L^T, column by column: C(i, j) at
/// [j size + i]. Unknowns without stiffness get a row and a column of zeros.
template <int size>
void factorize(float* block) {
  double A[size][size], L[size][size] = {}, pivot[size];
  bool is_dead[size];
  for (int i = 0; i < size; ++i) {
    is_dead[i] = !(block[i * size + i] > 0.0f);
    for (int j = 0; j <= i; ++j) A[i][j] = double(block[i * size + j]);
  }
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j)
      if (is_dead[i] || is_dead[j]) A[i][j] = i == j ? 1.0 : 0.0;
  for (int j = 0; j < size; ++j) {
    pivot[j] = A[j][j];
    for (int k = 0; k < j; ++k) pivot[j] -= L[j][k] * L[j][k] * pivot[k];
    if (!(pivot[j] > smallest_pivot * A[j][j])) pivot[j] = A[j][j];
    for (int i = j + 1; i < size; ++i) {
      double sum = A[i][j];
      for (int k = 0; k < j; ++k) sum -= L[i][k] * L[j][k] * pivot[k];
      L[i][j] = sum / pivot[j];
    }
  }
  std::fill_n(block, size * size, 0.0f);
  for (int j = 0; j < size; ++j) {
    if (is_dead[j]) continue;
    double column[size] = {};  // of L^-1
    column[j] = 1.0;
    for (int i = j + 1; i < size; ++i)
      for (int k = j; k < i; ++k) column[i] -= L[i][k] * column[k];
    for (int i = j; i < size; ++i)
      block[j * size + i] = static_cast<float>(column[i] / std::sqrt(pivot[i]));
  }
}

}  // namespace

ElementPatches::ElementPatches(const grid::BoxExchange& exchange, const Chosen& chosen) {
  const grid::LevelGrid& grid = exchange.grid();
  for (int d = 0; d < 3; ++d) nodes_[d] = grid.nodes(d);
  const bool is_flat = nodes_[2] == 1;
  corners_ = is_flat ? 4 : 8;
  const int elements[3] = {nodes_[0] - 1, nodes_[1] - 1, is_flat ? 1 : nodes_[2] - 1};
  const auto is_chosen = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), chosen);
  for (int colour = 0; colour < 8; ++colour) {
    for (int k = colour >> 2; k < elements[2]; k += 2)
      for (int j = colour >> 1 & 1; j < elements[1]; j += 2)
        for (int i = colour & 1; i < elements[0]; i += 2) {
          const auto e = static_cast<std::size_t>(i + elements[0] * (j + elements[1] * k));
          if (e < is_chosen.extent(0) && is_chosen(e) != 0)
            patches_.push_back({j + nodes_[1] * k, i});
        }
    colour_[static_cast<std::size_t>(colour) + 1] = patches_.size();
  }
  is_empty_ =
      exchange.communicator().sum<std::int64_t>(static_cast<std::int64_t>(patches_.size())) == 0;
  if (is_empty_) return;
  factor_ = Kokkos::View<float*, grid::Device>("element patches",
                                               patches_.size() * std::size_t(size * size));
  sum_ = NodeField<float>("patches' sum", grid);
  for (const Patch& patch : patches_)
    for (int a = 0; a < corners_; ++a) sum_.line(0, line_of(patch, a))[patch.node + (a & 1)] = 1.0f;
  exchange.sum(sum_);
  patched_ = Kokkos::View<std::uint8_t*, grid::Device>(
      "patched", static_cast<std::size_t>(nodes_[0]) * nodes_[1] * nodes_[2]);
  for (int line = 0; line < nodes_[1] * nodes_[2]; ++line)
    for (int i = 0; i < nodes_[0]; ++i)
      patched_(i + nodes_[0] * line) = sum_.line(0, line)[i] > 0.0f ? 1 : 0;
}

/// Line of an element's node a.
int ElementPatches::line_of(const Patch& patch, int a) const {
  return patch.line + (a >> 1 & 1) + nodes_[1] * (a >> 2);
}

/// The blocks as they are: for each place of the stencil its entries are summed over the ranks,
/// then put into the elements of which both nodes are corners.
void ElementPatches::gather_blocks(const mechanics::Stencil& stencil,
                                   const grid::BoxExchange& exchange) const {
  Kokkos::deep_copy(factor_, 0.0f);
  const StencilLayout& layout = stencil.layout();
  const float* const values = stencil.values().data();
  const NodeField<float> row[3] = {NodeField<float>("entries", exchange.grid()),
                                   NodeField<float>("entries", exchange.grid()),
                                   NodeField<float>("entries", exchange.grid())};
  for (int s = StencilLayout::own; s < 27; ++s) {
    const int step[3] = {s % 3 - 1, s / 3 % 3 - 1, s / 9 - 1};
    if (corners_ == 4 && step[2] != 0) continue;
    grid::for_each_line("entries", nodes_, [&](const int line, int, int) {
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
          for (int i = 0; i < nodes_[0]; ++i)
            row[c].line(d, line)[i] =
                values[layout.place(line, 9 * (s - StencilLayout::own) + 3 * c + d, i)];
    });
    for (const auto& field : row) exchange.sum(field);
    for (std::size_t p = 0; p < patches_.size(); ++p)
      for (int a = 0; a < corners_; ++a) {
        const int there[3] = {(a & 1) + step[0], (a >> 1 & 1) + step[1], (a >> 2) + step[2]};
        if (std::any_of(there, there + 3, [](int n) { return n < 0 || n > 1; })) continue;
        const int b = there[0] + 2 * there[1] + 4 * there[2];
        const int line = line_of(patches_[p], a), node = patches_[p].node + (a & 1);
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d) {
            const float entry = row[c].line(d, line)[node];
            factor(p)[(3 * a + c) * size + 3 * b + d] = entry;
            factor(p)[(3 * b + d) * size + 3 * a + c] = entry;
          }
      }
  }
}

void ElementPatches::compute(const mechanics::Stencil& stencil, const grid::BoxExchange& exchange) {
  gather_blocks(stencil, exchange);
  Kokkos::parallel_for(
      "factorise patches",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(patches_.size())),
      [&](const int p) { factorize<size>(factor(static_cast<std::size_t>(p))); });
}

void ElementPatches::add_step(const NodeField<float>& b, const NodeField<float>* y, float scale,
                              const NodeField<float>& step, const NodeField<float>& x,
                              const grid::BoxExchange& exchange) const {
  sum_.zero();
  const auto solve = [&](const std::size_t p) {
    const Patch& patch = patches_[p];
    float r[size] = {}, half[size] = {};
    for (int a = 0; a < corners_; ++a)
      for (int c = 0; c < 3; ++c) {
        const int line = line_of(patch, a), node = patch.node + (a & 1);
        r[3 * a + c] = b.line(c, line)[node] - (y == nullptr ? 0.0f : y->line(c, line)[node]);
      }
    const float* const C = factor(p);
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i) half[i] += C[j * size + i] * r[j];
    for (int a = 0; a < corners_; ++a)
      for (int c = 0; c < 3; ++c) {
        const float* const column = C + (3 * a + c) * size;
        float part[8] = {};
        for (int i = 0; i < size; i += 8)
          for (int lane = 0; lane < 8; ++lane) part[lane] += column[i + lane] * half[i + lane];
        float z = 0.0f;
        for (const float value : part) z += value;
        sum_.line(c, line_of(patch, a))[patch.node + (a & 1)] += z;
      }
  };
  for (std::size_t colour = 0; colour < 8; ++colour)
    Kokkos::parallel_for(
        "element patches",
        Kokkos::RangePolicy<grid::ExecutionSpace, Kokkos::Schedule<Kokkos::Static>>(
            static_cast<int>(colour_[colour]), static_cast<int>(colour_[colour + 1])),
        [&](const int p) { solve(static_cast<std::size_t>(p)); });
  exchange.sum(sum_);
  grid::for_each_line("patches' step", nodes_, [&](const int line, int, int) {
    for (int c = 0; c < 3; ++c) {
      const float* __restrict z = sum_.line(c, line);
      float* __restrict s = step.line(c, line);
      float* __restrict to = x.line(c, line);
      for (int i = 0; i < nodes_[0]; ++i) {
        s[i] += scale * z[i];
        to[i] += scale * z[i];
      }
    }
  });
}

}  // namespace stroma::solver
