#include "solver/ElementPatches.hpp"

#include <algorithm>
#include <cmath>

namespace stroma::solver {
namespace {

using grid::NodeField;
using transfer::StencilLayout;

/// A pivot of less than this share of its diagonal entry is what rounding in single precision left.
constexpr double smallest_pivot = 1e-6;

/// First entry of column j of a packed lower triangle; entry (i, j) stands at column(n, j) + i.
std::size_t column(int n, int j) {
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(2 * n - j - 1) / 2;
}

/// Puts C = D^-1/2 L^-1 in place of the symmetric K = L D L^T.
void factorize(int n, std::vector<float>& packed) {
  const auto size = static_cast<std::size_t>(n);
  std::vector<double> L(size * size, 0.0), pivot(size), inverse(size);
  for (int j = 0; j < n; ++j) {  // by columns, each taken off all that follow
    double* const here = &L[static_cast<std::size_t>(j) * size];
    for (int i = j; i < n; ++i)
      here[i] += double(packed[column(n, j) + static_cast<std::size_t>(i)]);
    const double diagonal = double(packed[column(n, j) + static_cast<std::size_t>(j)]);
    pivot[static_cast<std::size_t>(j)] = here[j] > smallest_pivot * diagonal ? here[j] : diagonal;
    for (int i = j + 1; i < n; ++i) here[i] /= pivot[static_cast<std::size_t>(j)];
    for (int k = j + 1; k < n; ++k) {
      const double factor = here[k] * pivot[static_cast<std::size_t>(j)];
      if (factor == 0.0) continue;
      double* __restrict next = &L[static_cast<std::size_t>(k) * size];
      for (int i = k; i < n; ++i) next[i] -= factor * here[i];
    }
    here[j] = 1.0;
  }
  for (int j = 0; j < n; ++j) {
    std::fill(inverse.begin(), inverse.end(), 0.0);
    inverse[static_cast<std::size_t>(j)] = 1.0;
    for (int k = j; k < n; ++k) {
      const double value = inverse[static_cast<std::size_t>(k)];
      if (value == 0.0) continue;
      const double* const below = &L[static_cast<std::size_t>(k) * size];
      for (int i = k + 1; i < n; ++i) inverse[static_cast<std::size_t>(i)] -= value * below[i];
    }
    for (int i = j; i < n; ++i)
      packed[column(n, j) + static_cast<std::size_t>(i)] = static_cast<float>(
          inverse[static_cast<std::size_t>(i)] / std::sqrt(pivot[static_cast<std::size_t>(i)]));
  }
}

}  // namespace

ElementPatches::ElementPatches(const grid::BoxExchange& exchange, const Chosen& chosen) {
  const grid::LevelGrid& grid = exchange.grid();
  for (int d = 0; d < 3; ++d) nodes_[d] = grid.nodes(d);
  const bool is_flat = nodes_[2] == 1;
  const int elements[3] = {nodes_[0] - 1, nodes_[1] - 1, is_flat ? 1 : nodes_[2] - 1};
  const auto is_chosen = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), chosen);
  const auto holds_chosen = [&](const std::array<int, 3>& first) {
    for (int k = first[2]; k < std::min(first[2] + edge, elements[2]); ++k)
      for (int j = first[1]; j < std::min(first[1] + edge, elements[1]); ++j)
        for (int i = first[0]; i < std::min(first[0] + edge, elements[0]); ++i)
          if (is_chosen(static_cast<std::size_t>(i + elements[0] * (j + elements[1] * k))) != 0)
            return true;
    return false;
  };
  for (int colour = 0; colour < 8 && is_chosen.extent(0) != 0; ++colour) {
    const int start[3] = {edge * (colour & 1), edge * (colour >> 1 & 1), edge * (colour >> 2)};
    for (int k = start[2]; k < elements[2]; k += 2 * edge)
      for (int j = start[1]; j < elements[1]; j += 2 * edge)
        for (int i = start[0]; i < elements[0]; i += 2 * edge) {
          Patch patch{};
          patch.first = {i, j, k};
          if (!holds_chosen(patch.first)) continue;
          for (std::size_t d = 0; d < 3; ++d)
            patch.extent[d] = std::min(edge + 1, nodes_[d] - patch.first[d]);
          patches_.push_back(patch);
        }
    colour_[static_cast<std::size_t>(colour) + 1] = patches_.size();
  }
  is_empty_ =
      exchange.communicator().sum<std::int64_t>(static_cast<std::int64_t>(patches_.size())) == 0;
  if (is_empty_) return;
  sum_ = NodeField<float>("patches' sum", grid);
  for (const Patch& patch : patches_)
    for_each_node(patch, [&](int, int line, int i) { sum_.line(0, line)[i] = 1.0f; });
  exchange.sum(sum_);
  patched_ = Kokkos::View<std::uint8_t*, grid::Device>(
      "patched", static_cast<std::size_t>(nodes_[0]) * nodes_[1] * nodes_[2]);
  for (int line = 0; line < nodes_[1] * nodes_[2]; ++line)
    for (int i = 0; i < nodes_[0]; ++i)
      patched_(i + nodes_[0] * line) = sum_.line(0, line)[i] > 0.0f ? 1 : 0;
}

/// Calls visit(node of the patch, line of the box, node of the line).
template <class Visit>
void ElementPatches::for_each_node(const Patch& patch, const Visit& visit) const {
  int number = 0;
  for (int k = 0; k < patch.extent[2]; ++k)
    for (int j = 0; j < patch.extent[1]; ++j)
      for (int i = 0; i < patch.extent[0]; ++i)
        visit(number++, patch.first[1] + j + nodes_[1] * (patch.first[2] + k), patch.first[0] + i);
}

/// \param row  of the nodes' own blocks
void ElementPatches::find_unknowns(Patch& patch, const NodeField<float> (&row)[3]) const {
  patch.place.clear();
  for_each_node(patch, [&](int number, int line, int i) {
    for (int c = 0; c < 3; ++c) {
      const bool is_live = row[c].line(c, line)[i] > 0.0f;
      patch.unknown[static_cast<std::size_t>(3 * number + c)] = is_live ? patch.size() : -1;
      if (is_live)
        patch.place.push_back(
            static_cast<std::size_t>(sum_.line(c, line) + i - sum_.values.data()));
    }
  });
  const auto n = static_cast<std::size_t>(patch.size());
  patch.C.assign(n * (n + 1) / 2, 0.0f);
}

/// Puts the blocks that couple nodes to those a step further on into a patch's matrix.
void ElementPatches::add_entries(Patch& patch, const std::array<int, 3>& step,
                                 const NodeField<float> (&row)[3]) const {
  const auto& extent = patch.extent;
  const int distance = step[0] + extent[0] * (step[1] + extent[1] * step[2]);
  for_each_node(patch, [&](int number, int line, int i) {
    const std::array<int, 3> there{number % extent[0] + step[0],
                                   number / extent[0] % extent[1] + step[1],
                                   number / (extent[0] * extent[1]) + step[2]};
    for (std::size_t d = 0; d < 3; ++d)
      if (there[d] < 0 || there[d] >= extent[d]) return;
    for (int c = 0; c < 3; ++c)
      for (int e = 0; e < 3; ++e) {
        const int a = patch.unknown[static_cast<std::size_t>(3 * number + c)];
        const int b = patch.unknown[static_cast<std::size_t>(3 * (number + distance) + e)];
        if (a < 0 || b < 0) continue;
        const int lower = std::max(a, b), upper = std::min(a, b);
        patch.C[column(patch.size(), upper) + static_cast<std::size_t>(lower)] =
            row[c].line(e, line)[i];
      }
  });
}

void ElementPatches::compute(const mechanics::Stencil& stencil, const grid::BoxExchange& exchange) {
  const StencilLayout& layout = stencil.layout();
  const float* const values = stencil.values().data();
  const NodeField<float> row[3] = {NodeField<float>("entries", exchange.grid()),
                                   NodeField<float>("entries", exchange.grid()),
                                   NodeField<float>("entries", exchange.grid())};
  const auto for_each_patch = [&](const auto& visit) {
    Kokkos::parallel_for(
        "patches", Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(patches_.size())),
        [&](const int p) { visit(patches_[static_cast<std::size_t>(p)]); });
  };
  for (int s = StencilLayout::own; s < 27; ++s) {
    const std::array<int, 3> step{s % 3 - 1, s / 3 % 3 - 1, s / 9 - 1};
    if (nodes_[2] == 1 && step[2] != 0) continue;
    grid::for_each_line("entries", nodes_, [&](const int line, int, int) {
      for (int c = 0; c < 3; ++c)
        for (int e = 0; e < 3; ++e)
          for (int i = 0; i < nodes_[0]; ++i)
            row[c].line(e, line)[i] =
                values[layout.place(line, 9 * (s - StencilLayout::own) + 3 * c + e, i)];
    });
    for (const auto& field : row) exchange.sum(field);
    for_each_patch([&](Patch& patch) {
      if (s == StencilLayout::own) find_unknowns(patch, row);
      add_entries(patch, step, row);
    });
  }
  for_each_patch([](Patch& patch) { factorize(patch.size(), patch.C); });
}

/// Adds a patch's C^T C (b - y) to the sum.
void ElementPatches::solve(const Patch& patch, const float* b, const float* y) const {
  float r[most], half[most] = {};
  const int n = patch.size();
  for (int j = 0; j < n; ++j) {
    const std::size_t at = patch.place[static_cast<std::size_t>(j)];
    r[j] = b[at] - (y == nullptr ? 0.0f : y[at]);
  }
  for (int j = 0; j < n; ++j) {
    const float* __restrict C = patch.C.data() + column(n, j);
    for (int i = j; i < n; ++i) half[i] += C[i] * r[j];
  }
  float* const z = sum_.values.data();
  for (int j = 0; j < n; ++j) {
    const float* __restrict C = patch.C.data() + column(n, j);
    float part[8] = {};
    int i = j;
    for (; i + 8 <= n; i += 8)
      for (int lane = 0; lane < 8; ++lane) part[lane] += C[i + lane] * half[i + lane];
    for (; i < n; ++i) part[0] += C[i] * half[i];
    for (int lane = 1; lane < 8; ++lane) part[0] += part[lane];
    z[patch.place[static_cast<std::size_t>(j)]] += part[0];
  }
}

void ElementPatches::add_step(const NodeField<float>& b, const NodeField<float>* y, float scale,
                              const NodeField<float>& step, const NodeField<float>& x,
                              const grid::BoxExchange& exchange) const {
  sum_.zero();
  const float* const y_values = y == nullptr ? nullptr : y->values.data();
  for (std::size_t colour = 0; colour < 8; ++colour)
    Kokkos::parallel_for(
        "element patches",
        Kokkos::RangePolicy<grid::ExecutionSpace>(static_cast<int>(colour_[colour]),
                                                  static_cast<int>(colour_[colour + 1])),
        [&](const int p) {
          solve(patches_[static_cast<std::size_t>(p)], b.values.data(), y_values);
        });
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
