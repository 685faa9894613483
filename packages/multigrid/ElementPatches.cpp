// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/multigrid/ElementPatches.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <iterator>

namespace stroma::multigrid {
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

/// Calls visit(element) for the elements of a box that share a node with one of them.
template <class Visit>
void for_each_neighbour(const std::array<int, 3>& elements, int element, const Visit& visit) {
  const int at[3] = {element % elements[0], element / elements[0] % elements[1],
                     element / (elements[0] * elements[1])};
  for (int k = std::max(at[2] - 1, 0); k <= std::min(at[2] + 1, elements[2] - 1); ++k)
    for (int j = std::max(at[1] - 1, 0); j <= std::min(at[1] + 1, elements[1] - 1); ++j)
      for (int i = std::max(at[0] - 1, 0); i <= std::min(at[0] + 1, elements[0] - 1); ++i)
        visit(i + elements[0] * (j + elements[1] * k));
}

}  // namespace

ElementPatches::ElementPatches(const grid::BoxExchange& exchange, const Chosen& chosen) {
  const grid::LevelGrid& grid = exchange.grid();
  for (int d = 0; d < 3; ++d) nodes_[d] = grid.nodes(d);
  find_patches(chosen);
  is_empty_ =
      exchange.communicator().sum<std::int64_t>(static_cast<std::int64_t>(patches_.size())) == 0;
  if (is_empty_) return;
  sort_by_colour();
  sum_ = NodeField<float>("patches' sum", grid);
  for (const Patch& patch : patches_)
    for (const int n : patch.nodes) sum_.line(0, n / nodes_[0])[n % nodes_[0]] = 1.0f;
  exchange.sum(sum_);
  patched_ = Kokkos::View<std::uint8_t*, grid::Device>(
      "patched", static_cast<std::size_t>(nodes_[0]) * nodes_[1] * nodes_[2]);
  for (int line = 0; line < nodes_[1] * nodes_[2]; ++line)
    for (int i = 0; i < nodes_[0]; ++i)
      patched_(i + nodes_[0] * line) = sum_.line(0, line)[i] > 0.0f ? 1 : 0;
}

/// Gathers clusters breadth first, each from the first chosen element that is in none.
void ElementPatches::find_patches(const Chosen& chosen) {
  const bool is_flat = nodes_[2] == 1;
  const std::array<int, 3> elements{nodes_[0] - 1, nodes_[1] - 1, is_flat ? 1 : nodes_[2] - 1};
  auto is_free = Kokkos::create_mirror(Kokkos::HostSpace(), chosen);
  Kokkos::deep_copy(is_free, chosen);
  std::vector<int> cluster;
  const auto take = [&](int element) {
    if (cluster.size() == most_elements || is_free(static_cast<std::size_t>(element)) == 0) return;
    is_free(static_cast<std::size_t>(element)) = 0;
    cluster.push_back(element);
  };
  for (std::size_t start = 0; start < is_free.extent(0); ++start) {
    cluster.clear();
    take(static_cast<int>(start));
    if (cluster.empty()) continue;
    // The cluster grows meanwhile. NOLINTNEXTLINE(modernize-loop-convert)
    for (std::size_t next = 0; next < cluster.size(); ++next)
      for_each_neighbour(elements, cluster[next], take);
    Patch patch;
    for (const int e : cluster)
      for (int corner = 0; corner < (is_flat ? 4 : 8); ++corner)
        patch.nodes.push_back(e % elements[0] + (corner & 1) +
                              nodes_[0] *
                                  (e / elements[0] % elements[1] + (corner >> 1 & 1) +
                                   nodes_[1] * (e / (elements[0] * elements[1]) + (corner >> 2))));
    std::sort(patch.nodes.begin(), patch.nodes.end());
    patch.nodes.erase(std::unique(patch.nodes.begin(), patch.nodes.end()), patch.nodes.end());
    patches_.push_back(std::move(patch));
  }
}

/// Gives each patch the first colour that none of its nodes has met. Its nodes meet 26 other
/// elements for each of its own at most.
void ElementPatches::sort_by_colour() {
  using Colours = std::bitset<26 * most_elements>;
  std::vector<Colours> met(static_cast<std::size_t>(nodes_[0]) * nodes_[1] * nodes_[2]);
  std::vector<std::vector<Patch>> of_colour;
  for (Patch& patch : patches_) {
    Colours taken;
    for (const int n : patch.nodes) taken |= met[static_cast<std::size_t>(n)];
    std::size_t colour = 0;
    while (taken[colour]) ++colour;
    for (const int n : patch.nodes) met[static_cast<std::size_t>(n)].set(colour);
    if (colour == of_colour.size()) of_colour.emplace_back();
    of_colour[colour].push_back(std::move(patch));
  }
  patches_.clear();
  colour_ = {0};
  for (auto& patches : of_colour) {
    std::move(patches.begin(), patches.end(), std::back_inserter(patches_));
    colour_.push_back(patches_.size());
  }
}

/// \param row  of the nodes' own blocks
void ElementPatches::find_unknowns(Patch& patch, const NodeField<float> (&row)[3]) const {
  patch.unknown.clear();
  patch.place.clear();
  for (const int node : patch.nodes)
    for (int c = 0; c < 3; ++c) {
      const int line = node / nodes_[0], i = node % nodes_[0];
      const bool is_live = row[c].line(c, line)[i] > 0.0f;
      patch.unknown.push_back(is_live ? patch.size() : -1);
      if (is_live)
        patch.place.push_back(
            static_cast<std::size_t>(sum_.line(c, line) + i - sum_.values.data()));
    }
  const auto n = static_cast<std::size_t>(patch.size());
  patch.C.assign(n * (n + 1) / 2, 0.0f);
}

/// Puts the blocks that couple nodes to those a step further on into a patch's matrix.
void ElementPatches::add_entries(Patch& patch, const std::array<int, 3>& step,
                                 const NodeField<float> (&row)[3]) const {
  const int distance = step[0] + nodes_[0] * (step[1] + nodes_[1] * step[2]);
  for (std::size_t here = 0; here < patch.nodes.size(); ++here) {
    const int node = patch.nodes[here], line = node / nodes_[0], i = node % nodes_[0];
    const int next[2] = {i + step[0], line % nodes_[1] + step[1]};
    if (next[0] < 0 || next[0] >= nodes_[0] || next[1] < 0 || next[1] >= nodes_[1]) continue;
    const auto found = std::lower_bound(patch.nodes.begin(), patch.nodes.end(), node + distance);
    if (found == patch.nodes.end() || *found != node + distance) continue;
    const auto there = static_cast<std::size_t>(found - patch.nodes.begin());
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t e = 0; e < 3; ++e) {
        const int a = patch.unknown[3 * here + c], b = patch.unknown[3 * there + e];
        if (a < 0 || b < 0) continue;
        const int lower = std::max(a, b), upper = std::min(a, b);
        patch.C[column(patch.size(), upper) + static_cast<std::size_t>(lower)] =
            row[c].line(static_cast<int>(e), line)[i];
      }
  }
}

void ElementPatches::compute(const tangent::Stencil& stencil, const grid::BoxExchange& exchange) {
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
  for (std::size_t colour = 0; colour + 1 < colour_.size(); ++colour)
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

}  // namespace stroma::multigrid
