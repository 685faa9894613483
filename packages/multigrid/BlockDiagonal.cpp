// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/multigrid/BlockDiagonal.hpp"

#include "stroma/tensor/Tensor3.hpp"

namespace stroma::multigrid {

using grid::NodeField;

BlockDiagonal::BlockDiagonal(const grid::LevelGrid& grid) {
  for (int d = 0; d < 3; ++d) nodes_[d] = grid.nodes(d);
  inverse_ = Kokkos::View<float*, grid::Device>(
      "block diagonal", 6 * static_cast<std::size_t>(nodes_[0]) * nodes_[1] * nodes_[2]);
}

void BlockDiagonal::compute(const tangent::Stencil& stencil, const grid::BoxExchange& exchange) {
  const transfer::StencilLayout layout = stencil.layout();
  const float* const values = stencil.values().data();
  const NodeField<float> row[3] = {NodeField<float>("diagonal", exchange.grid()),
                                   NodeField<float>("diagonal", exchange.grid()),
                                   NodeField<float>("diagonal", exchange.grid())};
  const int n = nodes_[0];
  grid::for_each_line("diagonal blocks", nodes_, [&](const int line, int, int) {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        for (int m = 0; m < n; ++m)
          row[i].line(k, line)[m] = values[layout.place(line, 3 * i + k, m)];
  });
  for (const auto& field : row) exchange.sum(field);

  float* const inverse = inverse_.data();
  grid::for_each_line("invert blocks", nodes_, [&](const int line, int, int) {
    for (int m = 0; m < n; ++m) {
      tensor::Tensor3 D;
      bool dead[3];
      double largest = 0.0;
      for (int i = 0; i < 3; ++i) largest = std::max(largest, double(row[i].line(i, line)[m]));
      for (int i = 0; i < 3; ++i) {
        dead[i] = !(row[i].line(i, line)[m] > 1e-30 * largest);
        for (int k = 0; k < 3; ++k)  // symmetric but for rounding
          D(i, k) = 0.5 * (double(row[i].line(k, line)[m]) + double(row[k].line(i, line)[m]));
      }
      for (int i = 0; i < 3; ++i) {
        if (!dead[i]) continue;
        for (int k = 0; k < 3; ++k) D(i, k) = D(k, i) = 0.0;
        D(i, i) = largest > 0.0 ? largest : 1.0;
      }
      const tensor::Tensor3 inverse_block = tensor::inverse(D);
      const int place[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
      for (int e = 0; e < 6; ++e) {
        const bool is_out = dead[place[e][0]] || dead[place[e][1]];
        inverse[(static_cast<std::size_t>(line) * 6 + static_cast<std::size_t>(e)) *
                    static_cast<std::size_t>(n) +
                static_cast<std::size_t>(m)] =
            is_out ? 0.0f : static_cast<float>(inverse_block(place[e][0], place[e][1]));
      }
    }
  });
}

void BlockDiagonal::leave_out(const Kokkos::View<const std::uint8_t*, grid::Device>& nodes) {
  const int n = nodes_[0];
  float* const inverse = inverse_.data();
  const std::uint8_t* const is_out = nodes.data();
  grid::for_each_line("leave out", nodes_, [&](const int line, int, int) {
    for (int m = 0; m < n; ++m)
      if (is_out[m + n * line] != 0)
        for (int e = 0; e < 6; ++e)
          inverse[(static_cast<std::size_t>(line) * 6 + e) * n + m] = 0.0f;
  });
}

void BlockDiagonal::add_step(const NodeField<float>& b, const NodeField<float>* y, float keep,
                             float scale, const NodeField<float>& step,
                             const NodeField<float>& x) const {
  const int n = nodes_[0];
  const float* const inverse = inverse_.data();
  grid::for_each_line("smoothing step", nodes_, [&](const int line, int, int) {
    const float* __restrict d = inverse + 6 * static_cast<std::size_t>(line) * n;
    const float* __restrict b0 = b.line(0, line), * __restrict b1 = b.line(1, line), * __restrict b2 = b.line(2, line);
    float* __restrict s0 = step.line(0, line), * __restrict s1 = step.line(1, line), * __restrict s2 = step.line(2, line);
    float* __restrict x0 = x.line(0, line), * __restrict x1 = x.line(1, line), * __restrict x2 = x.line(2, line);
    if (y == nullptr) {
      for (int m = 0; m < n; ++m) {
        const float r0 = b0[m], r1 = b1[m], r2 = b2[m];
        const float xy = d[3 * n + m], yz = d[4 * n + m], zx = d[5 * n + m];
        s0[m] = keep * s0[m] + scale * (d[m] * r0 + xy * r1 + zx * r2);
        s1[m] = keep * s1[m] + scale * (xy * r0 + d[n + m] * r1 + yz * r2);
        s2[m] = keep * s2[m] + scale * (zx * r0 + yz * r1 + d[2 * n + m] * r2);
        x0[m] += s0[m];
        x1[m] += s1[m];
        x2[m] += s2[m];
      }
      return;
    }
    const float* __restrict y0 = y->line(0, line), * __restrict y1 = y->line(1, line), * __restrict y2 = y->line(2, line);
    for (int m = 0; m < n; ++m) {
      const float r0 = b0[m] - y0[m], r1 = b1[m] - y1[m], r2 = b2[m] - y2[m];
      const float xy = d[3 * n + m], yz = d[4 * n + m], zx = d[5 * n + m];
      s0[m] = keep * s0[m] + scale * (d[m] * r0 + xy * r1 + zx * r2);
      s1[m] = keep * s1[m] + scale * (xy * r0 + d[n + m] * r1 + yz * r2);
      s2[m] = keep * s2[m] + scale * (zx * r0 + yz * r1 + d[2 * n + m] * r2);
      x0[m] += s0[m];
      x1[m] += s1[m];
      x2[m] += s2[m];
    }
  });
}

}  // namespace stroma::multigrid
