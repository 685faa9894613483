// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/tangent/Stencil.hpp"

#include "stroma/tangent/SimdPack.hpp"

namespace stroma::tangent {
namespace {

using grid::NodeField;
using transfer::StencilLayout;

constexpr int tile = StencilLayout::tile;

/// Three components at eight nodes.
template <class T>
struct PackedVector {
  typename SimdPack<T>::Type c[3];

  PackedVector() : c{} {}
  PackedVector(const T* first, int pitch)
      : c{load_pack(first), load_pack(first + pitch), load_pack(first + 2 * pitch)} {}
  void add_to(T* first, int pitch) const {
    for (int i = 0; i < 3; ++i) add_pack(first + i * pitch, c[i]);
  }
};

/// y += B x and Y += B^T X for a block B of each of eight nodes.
template <class T>
inline void multiply_block(const float* B, const PackedVector<T>& x, PackedVector<T>& y,
                           const PackedVector<T>& X, PackedVector<T>& Y) {
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const auto b = converted<T>(B + tile * (3 * i + k));
      y.c[i] += b * x.c[k];
      Y.c[k] += b * X.c[i];
    }
}

/// A line that is ahead of the one whose blocks are read.
template <class T>
struct LineAhead {
  const T* x = nullptr;  // null: there is none
  T* y = nullptr;
  T carried[3] = {0, 0, 0};  // what the last tile adds to the node beyond it
};

/// Adds what a tile contributes to its neighbours at dx = 1: up, and the last of them carried.
template <class T>
inline void shift_and_carry(const PackedVector<T>& up, T carried[3], PackedVector<T>& sum) {
  for (int i = 0; i < 3; ++i) {
    sum.c[i] += shifted_up(up.c[i], carried[i]);
    carried[i] = up.c[i][tile - 1];
  }
}

/// All products with the blocks of one line of nodes. Each block is read once and serves its own
/// row and, transposed, its neighbour's. Sums at eight nodes stay in registers; what goes to nodes
/// next to the eight is shifted there, so that no store overlaps a load that follows it closely.
template <class T>
void multiply_line(int tiles, const float* blocks, const T* x, T* y, int pitch,
                   LineAhead<T> (&ahead)[4]) {
  T carried[3] = {0, 0, 0};
  for (int t = 0; t < tiles; ++t, blocks += StencilLayout::entries * tile) {
    const int first = t * tile;
    const PackedVector<T> x_here(x + first, pitch);
    PackedVector<T> y_here;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        y_here.c[i] += converted<T>(blocks + tile * (3 * i + k)) * x_here.c[k];
    PackedVector<T> up;
    multiply_block(blocks + 9 * tile, PackedVector<T>(x + first + 1, pitch), y_here, x_here, up);
    shift_and_carry(up, carried, y_here);
    for (int n = 0; n < 4; ++n) {
      LineAhead<T>& line = ahead[n];
      if (line.x == nullptr) continue;
      const float* const B = blocks + (18 + 27 * n) * tile;
      const T* const x_there = line.x + first;
      T* const y_there = line.y + first;
      PackedVector<T> below, sum, above;
      multiply_block(B, PackedVector<T>(x_there - 1, pitch), y_here, x_here, below);
      for (int i = 0; i < 3; ++i) {
        y_there[i * pitch - 1] += below.c[i][0];
        sum.c[i] = shifted_down(below.c[i]);
      }
      multiply_block(B + 9 * tile, PackedVector<T>(x_there, pitch), y_here, x_here, sum);
      multiply_block(B + 18 * tile, PackedVector<T>(x_there + 1, pitch), y_here, x_here, above);
      shift_and_carry(above, line.carried, sum);
      sum.add_to(y_there, pitch);
    }
    y_here.add_to(y + first, pitch);
  }
}

}  // namespace

Stencil::Stencil(const grid::LevelGrid& grid) {
  for (int d = 0; d < 3; ++d) layout_.nodes[d] = grid.nodes(d);
  values_ = Kokkos::View<float*, Device>("stencil", layout_.count());
}

template <class T>
void Stencil::multiply_in(const NodeField<T>& x, const NodeField<T>& y) const {
  y.zero();
  const StencilLayout layout = layout_;
  const float* const values = values_.data();
  const auto multiply_lines_of_plane = [=](const int k) {
    for (int j = 0; j < layout.nodes[1]; ++j) {
      const int here = j + layout.nodes[1] * k;
      LineAhead<T> ahead[4];
      for (int n = 0; n < 4; ++n) {  // (dy, dz) = (1, 0), (-1, 1), (0, 1), (1, 1)
        const int dy = n == 0 ? 1 : n - 2, dz = n == 0 ? 0 : 1;
        if (j + dy < 0 || j + dy >= layout.nodes[1] || k + dz >= layout.nodes[2]) continue;
        const int there = here + dy + layout.nodes[1] * dz;
        ahead[n].x = x.line(0, there);
        ahead[n].y = y.line(0, there);
      }
      multiply_line(layout.tiles(), values + layout.first(here, 0), x.line(0, here),
                    y.line(0, here), x.pitch, ahead);
    }
  };
  // A plane of lines adds to itself and to the next: every second one may run at the same time.
  for (int colour = 0; colour < 2 && colour < layout.nodes[2]; ++colour)
    Kokkos::parallel_for(
        "stencil product",
        Kokkos::RangePolicy<grid::ExecutionSpace, Kokkos::Schedule<Kokkos::Static>>(
            0, (layout.nodes[2] - colour + 1) / 2),
        [=](const int pair) { multiply_lines_of_plane(2 * pair + colour); });
}

void Stencil::multiply(const NodeField<float>& x, const NodeField<float>& y) const {
  multiply_in(x, y);
}
void Stencil::multiply(const NodeField<double>& x, const NodeField<double>& y) const {
  multiply_in(x, y);
}

}  // namespace stroma::tangent
