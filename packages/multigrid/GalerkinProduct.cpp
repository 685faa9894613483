// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/multigrid/GalerkinProduct.hpp"

#include <algorithm>
#include <vector>

namespace stroma::multigrid {
namespace {

// A plane of blocks couples a plane of nodes to itself or to the next: nine blocks a node, q = (dx
// + 1) + 3 (dy + 1), of nine entries each. A line of nodes holds its 81 rows one after the other.
constexpr int plane_rows = 81;
constexpr int own_rows = 45;  // of a stencil's line: what couples a plane to itself, q = 4 to 8

using Floats = std::vector<float>;
using transfer::StencilLayout;

std::size_t size(int n) { return static_cast<std::size_t>(n); }

template <class F>
void for_each(int count, const F& f) {
  Kokkos::parallel_for("galerkin product", Kokkos::RangePolicy<grid::ExecutionSpace>(0, count), f);
}

/// to += weight * transpose of a block of nine rows, `shift` nodes further on, for n nodes.
void add_transposed(int n, float weight, int shift, const float* from, std::size_t from_pitch,
                    float* to, std::size_t to_pitch) {
  const int begin = std::max(0, -shift), end = std::min(n, n - shift);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const float* __restrict source = from + size(3 * k + i) * from_pitch;
      float* __restrict target = to + size(3 * i + k) * to_pitch;
      for (int m = begin; m < end; ++m) target[m] += weight * source[m + shift];
    }
}

/// Rows of a line: entries [first, first + rows) of the stencil.
void unpack(const StencilLayout& layout, const float* values, int line, int first, int rows,
            float* to) {
  const int n = layout.nodes[0];
  for (int t = 0; t < layout.tiles(); ++t) {
    const float* const from = values + layout.first(line, t) + size(first * StencilLayout::tile);
    const int begin = t * StencilLayout::tile;
    const int count = std::min(StencilLayout::tile, n - begin);
    for (int row = 0; row < rows; ++row)
      std::copy_n(from + size(row * StencilLayout::tile), count, to + size(row) * size(n) + begin);
  }
}

/// The nine blocks of a plane's lines with itself, of which the stencil holds five.
void complete_plane(const StencilLayout& layout, const float* values, int k, Floats& plane) {
  const int n = layout.nodes[0];
  const std::size_t pitch = size(n);
  const auto line_of = [&](int j) { return plane.data() + size(j) * plane_rows * pitch; };
  for_each(layout.nodes[1], [&](const int j) {
    std::fill_n(line_of(j), 36 * pitch, 0.0f);
    unpack(layout, values, j + layout.nodes[1] * k, 0, own_rows, line_of(j) + 36 * pitch);
  });
  for_each(layout.nodes[1], [&](const int j) {
    for (int q = 0; q < 4; ++q) {
      const int dx = q % 3 - 1, dy = q / 3 - 1;
      if (j + dy < 0) continue;
      add_transposed(n, 1.0f, dx, line_of(j + dy) + size(9 * (8 - q)) * pitch, pitch,
                     line_of(j) + size(9 * q) * pitch, pitch);
    }
  });
}

/// The nine blocks that couple a plane's lines to the next plane.
void next_plane(const StencilLayout& layout, const float* values, int k, Floats& plane) {
  for_each(layout.nodes[1], [&](const int j) {
    unpack(layout, values, j + layout.nodes[1] * k, own_rows, plane_rows,
           plane.data() + size(j) * plane_rows * size(layout.nodes[0]));
  });
}

/// A term of a transformed line: coarse block at (I, I + to) += weight * fine block (i, i + from).
struct Term {
  int coarse, to, fine, from;
  float weight;
};

std::vector<Term> terms(const LineTransfer& along) {
  std::vector<Term> all;
  for (int I = 0; I < along.coarse; ++I)
    along.for_each_child(I, [&](int i, float weight) {
      for (int step = -1; step <= 1; ++step) {
        if (i + step < 0 || i + step >= along.fine) continue;
        along.for_each_parent(i + step, [&](int other, float other_weight) {
          all.push_back({I, other - I, i, step, weight * other_weight});
        });
      }
    });
  return all;
}

/// Transforms a plane of blocks along y, then along x.
///
/// \param plane   (fine line, 81 rows, fine node)
/// \param result   (coarse line, 81 rows, coarse node)
void transform_plane(const LevelTransfer& transfer, const std::vector<Term>& y_terms,
                     const std::vector<Term>& x_terms, const Floats& plane, Floats& result) {
  const LineTransfer &x = transfer.along(0), &y = transfer.along(1);
  const std::size_t fine = size(x.fine), coarse = size(x.coarse);
  for_each(y.coarse, [&](const int J) {
    Floats along_y(plane_rows * fine, 0.0f);
    const auto first = std::lower_bound(y_terms.begin(), y_terms.end(), J,
                                        [](const Term& t, int line) { return t.coarse < line; });
    for (auto term = first; term != y_terms.end() && term->coarse == J; ++term) {
      // The three blocks of one dy stand together.
      const float* __restrict from =
          plane.data() + (size(term->fine) * plane_rows + size(27 * (term->from + 1))) * fine;
      float* __restrict to = along_y.data() + size(27 * (term->to + 1)) * fine;
      const float weight = term->weight;
      for (std::size_t n = 0; n < 27 * fine; ++n) to[n] += weight * from[n];
    }
    float* const line = result.data() + size(J) * plane_rows * coarse;
    std::fill(line, line + plane_rows * coarse, 0.0f);
    for (int dy = 0; dy < 3; ++dy)
      for (const Term& term : x_terms) {
        const float* from =
            along_y.data() + size(27 * dy + 9 * (term.from + 1)) * fine + size(term.fine);
        float* to = line + size(27 * dy + 9 * (term.to + 1)) * coarse + size(term.coarse);
        for (std::size_t entry = 0; entry < 9; ++entry)
          to[entry * coarse] += term.weight * from[entry * fine];
      }
  });
}

/// Adds weight * plane to a coarse plane's coupling with itself or with the next.
class CoarsePlanes {
 public:
  explicit CoarsePlanes(const tangent::Stencil& coarse)
      : layout_(coarse.layout()), values_(coarse.values().data()), pitch_(size(layout_.nodes[0])) {}

  void add_to_self(int K, float weight, const Floats& plane) const {
    for_each(layout_.nodes[1], [&](const int J) {
      add(J, K, weight, plane.data() + (size(J) * plane_rows + 36) * pitch_, own_rows, 0);
    });
  }
  void add_to_next(int K, float weight, const Floats& plane) const {
    for_each(layout_.nodes[1], [&](const int J) {
      add(J, K, weight, plane.data() + size(J) * plane_rows * pitch_, plane_rows, own_rows);
    });
  }
  /// The same as add_to_self() for the transpose of a plane.
  void add_transposed_to_self(int K, float weight, const Floats& plane) const {
    for_each(layout_.nodes[1], [&](const int J) {
      Floats line(own_rows * pitch_, 0.0f);
      for (int q = 4; q < 9; ++q) {
        const int dx = q % 3 - 1, dy = q / 3 - 1;
        if (J + dy >= layout_.nodes[1]) continue;
        add_transposed(layout_.nodes[0], 1.0f, dx,
                       plane.data() + (size(J + dy) * plane_rows + size(9 * (8 - q))) * pitch_,
                       pitch_, line.data() + size(9 * (q - 4)) * pitch_, pitch_);
      }
      add(J, K, weight, line.data(), own_rows, 0);
    });
  }

 private:
  void add(int J, int K, float weight, const float* from, int rows, int entry) const {
    constexpr int tile = StencilLayout::tile;
    for (int t = 0; t < layout_.tiles(); ++t) {
      float* to = values_ + layout_.first(J + layout_.nodes[1] * K, t) + size(entry * tile);
      const float* source = from + t * tile;
      const int count = std::min(tile, layout_.nodes[0] - t * tile);
      for (int row = 0; row < rows; ++row, to += tile, source += pitch_)
        for (int m = 0; m < count; ++m) to[m] += weight * source[m];
    }
  }

  StencilLayout layout_;
  float* values_;
  std::size_t pitch_;
};

}  // namespace

void galerkin_product(const tangent::Stencil& fine, const LevelTransfer& transfer,
                      const tangent::Stencil& coarse) {
  const StencilLayout& layout = fine.layout();
  const float* const values = fine.values().data();
  const LineTransfer& z = transfer.along(2);
  const auto x_terms = terms(transfer.along(0)), y_terms = terms(transfer.along(1));
  coarse.zero();
  const CoarsePlanes planes(coarse);
  Floats plane(size(layout.nodes[1]) * plane_rows * size(layout.nodes[0]));
  Floats transformed(size(transfer.along(1).coarse) * plane_rows * size(transfer.along(0).coarse));
  for (int k = 0; k < layout.nodes[2]; ++k) {
    complete_plane(layout, values, k, plane);
    transform_plane(transfer, y_terms, x_terms, plane, transformed);
    z.for_each_parent(k, [&](int K, float weight) {
      z.for_each_parent(k, [&](int other, float other_weight) {
        if (other == K) planes.add_to_self(K, weight * other_weight, transformed);
        if (other == K + 1) planes.add_to_next(K, weight * other_weight, transformed);
      });
    });
    if (k + 1 == layout.nodes[2]) continue;
    next_plane(layout, values, k, plane);
    transform_plane(transfer, y_terms, x_terms, plane, transformed);
    z.for_each_parent(k, [&](int K, float weight) {
      z.for_each_parent(k + 1, [&](int other, float other_weight) {
        if (other == K) {
          planes.add_to_self(K, weight * other_weight, transformed);
          planes.add_transposed_to_self(K, weight * other_weight, transformed);
        }
        if (other == K + 1) planes.add_to_next(K, weight * other_weight, transformed);
      });
    });
  }
}

}  // namespace stroma::multigrid
