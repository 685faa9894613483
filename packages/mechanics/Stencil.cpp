#include "mechanics/Stencil.hpp"

namespace stroma::mechanics {
namespace {

using grid::NodeField;

/// Pointers to the three components of a line.
template <class T>
struct Line {
  T* c[3];
  Line(const NodeField<T>& field, int number, int shift)
      : c{field.line(0, number) + shift, field.line(1, number) + shift,
          field.line(2, number) + shift} {}
};

/// y_i += K_ik x_k along a line, for a block whose nine rows lie `pitch` apart.
template <class T>
void add_block(int n, const float* __restrict K, std::size_t pitch, const Line<T>& x,
               const Line<T>& y) {
  const T* __restrict x0 = x.c[0], * __restrict x1 = x.c[1], * __restrict x2 = x.c[2];
  T* __restrict y0 = y.c[0], * __restrict y1 = y.c[1], * __restrict y2 = y.c[2];
  for (int m = 0; m < n; ++m) {
    const T a = x0[m], b = x1[m], c = x2[m];
    y0[m] += T(K[m]) * a + T(K[pitch + m]) * b + T(K[2 * pitch + m]) * c;
    y1[m] += T(K[3 * pitch + m]) * a + T(K[4 * pitch + m]) * b + T(K[5 * pitch + m]) * c;
    y2[m] += T(K[6 * pitch + m]) * a + T(K[7 * pitch + m]) * b + T(K[8 * pitch + m]) * c;
  }
}

/// Y_k += K_ik X_i along a line: the block's transpose.
template <class T>
void add_transposed_block(int n, const float* __restrict K, std::size_t pitch, const Line<T>& X,
                          const Line<T>& Y) {
  const T* __restrict x0 = X.c[0], * __restrict x1 = X.c[1], * __restrict x2 = X.c[2];
  T* __restrict y0 = Y.c[0], * __restrict y1 = Y.c[1], * __restrict y2 = Y.c[2];
  for (int m = 0; m < n; ++m) {
    const T a = x0[m], b = x1[m], c = x2[m];
    y0[m] += T(K[m]) * a + T(K[3 * pitch + m]) * b + T(K[6 * pitch + m]) * c;
    y1[m] += T(K[pitch + m]) * a + T(K[4 * pitch + m]) * b + T(K[7 * pitch + m]) * c;
    y2[m] += T(K[2 * pitch + m]) * a + T(K[5 * pitch + m]) * b + T(K[8 * pitch + m]) * c;
  }
}

/// Both in one pass over the block: y of this line, Y of another.
template <class T>
void add_block_both_ways(int n, const float* __restrict K, std::size_t pitch, const Line<T>& x,
                         const Line<T>& y, const Line<T>& X, const Line<T>& Y) {
  const T* __restrict x0 = x.c[0], * __restrict x1 = x.c[1], * __restrict x2 = x.c[2];
  const T* __restrict X0 = X.c[0], * __restrict X1 = X.c[1], * __restrict X2 = X.c[2];
  T* __restrict y0 = y.c[0], * __restrict y1 = y.c[1], * __restrict y2 = y.c[2];
  T* __restrict Y0 = Y.c[0], * __restrict Y1 = Y.c[1], * __restrict Y2 = Y.c[2];
#pragma GCC ivdep
  for (int m = 0; m < n; ++m) {
    const T k00 = K[m], k01 = K[pitch + m], k02 = K[2 * pitch + m];
    const T k10 = K[3 * pitch + m], k11 = K[4 * pitch + m], k12 = K[5 * pitch + m];
    const T k20 = K[6 * pitch + m], k21 = K[7 * pitch + m], k22 = K[8 * pitch + m];
    const T a = X0[m], b = X1[m], c = X2[m];
    y0[m] += k00 * a + k01 * b + k02 * c;
    y1[m] += k10 * a + k11 * b + k12 * c;
    y2[m] += k20 * a + k21 * b + k22 * c;
    const T d = x0[m], e = x1[m], f = x2[m];
    Y0[m] += k00 * d + k10 * e + k20 * f;
    Y1[m] += k01 * d + k11 * e + k21 * f;
    Y2[m] += k02 * d + k12 * e + k22 * f;
  }
}

}  // namespace

Stencil::Stencil(const grid::LevelGrid& grid) {
  for (int d = 0; d < 3; ++d) lines_.nodes[d] = grid.nodes(d);
  values_ = Kokkos::View<float*, Device>("stencil", lines_.count());
}

template <class T>
void Stencil::multiply_in(const NodeField<T>& x, const NodeField<T>& y) const {
  y.zero();
  const transfer::StencilLines lines = lines_;
  const float* const values = values_.data();
  const auto line_product = KOKKOS_LAMBDA(const int j, const int k) {
    const int n = lines.nodes[0];
    const auto pitch = static_cast<std::size_t>(n);
    const int here = j + lines.nodes[1] * k;
    const auto block = [&](int s) { return values + lines.row(here, 9 * (s - 13)); };
    const Line<T> x_here(x, here, 0), y_here(y, here, 0);
    add_block(n, block(13), pitch, x_here, y_here);
    add_block(n, block(14), pitch, Line<T>(x, here, 1), y_here);
    add_transposed_block(n, block(14), pitch, x_here, Line<T>(y, here, 1));
    for (int s = 15; s < 27; s += 3) {  // lines ahead: (dy, dz) = (1, 0), (-1, 1), (0, 1), (1, 1)
      const int dy = s / 3 % 3 - 1, dz = s / 9 - 1;
      if (j + dy < 0 || j + dy >= lines.nodes[1] || k + dz >= lines.nodes[2]) continue;
      const int there = here + dy + lines.nodes[1] * dz;
      for (int dx = -1; dx <= 1; ++dx)
        add_block_both_ways(n, block(s + dx + 1), pitch, x_here, y_here, Line<T>(x, there, dx),
                            Line<T>(y, there, dx));
    }
  };
  // A plane of lines adds to itself and to the next: every second one may run at the same time.
  for (int colour = 0; colour < 2 && colour < lines.nodes[2]; ++colour)
    Kokkos::parallel_for(
        "stencil product",
        Kokkos::RangePolicy<grid::ExecutionSpace, Kokkos::Schedule<Kokkos::Static>>(
            0, (lines.nodes[2] - colour + 1) / 2),
        KOKKOS_LAMBDA(const int pair) {
          for (int j = 0; j < lines.nodes[1]; ++j) line_product(j, 2 * pair + colour);
        });
}

void Stencil::multiply(const NodeField<float>& x, const NodeField<float>& y) const {
  multiply_in(x, y);
}
void Stencil::multiply(const NodeField<double>& x, const NodeField<double>& y) const {
  multiply_in(x, y);
}

}  // namespace stroma::mechanics
