// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles to grid: the tangent (stiffness) matrix.

#include "stroma/transfer/MeanDilatation.hpp"

namespace stroma::transfer {

/// Where the 3 x 3 blocks of the tangent go. Row nodes are touched nodes; the column of a block is
/// the row's neighbour in the stencil of all nodes within a reach r = width - 1, side 2 r + 1,
/// s = (dx + r) + side (dy + r) + side^2 (dz + r).
///
/// Rows of owned nodes are summed straight into the values of a compressed row matrix with three
/// rows per node, whose blocks are found by arithmetic; rows of nodes that other ranks own go to
/// `shared` and travel to their owners afterwards. Entries in prescribed rows and columns are left
/// out.
template <class Device>
struct BlockRows {
  using Real = double;

  Kokkos::View<const int*, Device> row;  ///< (touched node) owned node, or ~shared if negative
  Kokkos::View<const std::size_t*, Device> row_begin;  ///< (3 owned node + i) first entry
  Kokkos::View<const std::uint16_t**, Kokkos::LayoutRight, Device>
      slot;                              ///< (owned node, s) block within its row
  Kokkos::View<double*, Device> values;  ///< entries of the matrix, added to
  Kokkos::View<double**, Kokkos::LayoutLeft, Device> shared;  ///< (shared, 9 s + 3 i + k), added to
  Kokkos::View<const std::uint8_t*, Device>
      held;  ///< (touched node) bit c: component c is prescribed

  /// Adds an element's blocks K(i, k, b) to the rows of one of its nodes, b being the element's
  /// nodes and s(b) their places in the node's stencil.
  template <int Nodes, int Padded>
  KOKKOS_INLINE_FUNCTION void add(int node, const double (&K)[3][3][Padded],
                                  const int (&s)[Nodes]) const {
    const int r = row(node);
    if (r < 0) {
      for (int b = 0; b < Nodes; ++b)
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < 3; ++k) shared(~r, 9 * s[b] + 3 * i + k) += K[i][k][b];
      return;
    }
    int first[Nodes];
    for (int b = 0; b < Nodes; ++b) first[b] = 3 * slot(r, s[b]);
    for (int i = 0; i < 3; ++i) {
      double* entries = &values(row_begin(3 * r + i));
      for (int b = 0; b < Nodes; ++b)
        for (int k = 0; k < 3; ++k) entries[first[b] + k] += K[i][k][b];
    }
  }
};

/// The blocks K(a, i, k, b) of one element's nodes a and b, on their way to a matrix.
template <class Shape, class Rows>
struct ElementBlocks {
  using Real = typename Rows::Real;
  static constexpr int n = Shape::nodes;
  static constexpr int w = Shape::width;
  static constexpr int reach = w - 1, side = 2 * reach + 1;
  static constexpr int lanes = 8;
  static constexpr int padded = (n + lanes - 1) / lanes * lanes;

  Real K[n][3][3][padded] = {};

  /// Adds them to the rows of the nodes of element (i, j, k), but for what is prescribed.
  template <class Elements>
  KOKKOS_INLINE_FUNCTION void add_to(const Rows& rows, const Elements& elements, int i, int j,
                                     int k) {
    int node[n], held[n], any_held = 0;
    for (int a = 0; a < n; ++a) {
      node[a] = elements.node_of(i, j, k, a);
      held[a] = rows.held(node[a]);
      any_held |= held[a];
    }
    if (any_held) leave_out(held);
    for (int a = 0; a < n; ++a) {
      int s[n];  // place of node b in the stencil of node a
      for (int b = 0; b < n; ++b) {
        const int dz = elements.box.flat ? 0 : b / (w * w) - a / (w * w);
        s[b] = (b % w - a % w + reach) + side * (b / w % w - a / w % w + reach) +
               side * side * (dz + reach);
      }
      rows.add(node[a], K[a], s);
    }
  }

 private:
  /// Clears the rows and columns of prescribed components.
  KOKKOS_INLINE_FUNCTION void leave_out(const int (&held)[n]) {
    for (int a = 0; a < n; ++a)
      for (int c = 0; c < 3; ++c)
        for (int m = 0; m < 3; ++m)
          for (int b = 0; b < n; ++b)
            if ((held[a] >> c & 1) || (held[b] >> m & 1)) K[a][c][m][b] = 0.0;
  }
};

/// Adds the tangent of each element's points to the rows of its nodes:
///
///     K_IiJk = sum_p V0 dN_I/dx_j a_ijkl dN_J/dx_l       [pN/um] = [Pa um]
///
/// with the law's spatial tangent a (material and geometric part). For an isotropic a, given by the
/// few numbers of material::IsotropicTangent, each particle's block is a sum of dyads of vectors,
///
///     K_ab = p_a (x) g_b + g_a (x) q_b + sym g_b (x) g_a + (g_a . t_b) I,      g = grad_x N,
///     p = V0 (vol g - 2/3 s g),   q = -2/3 V0 s g,   t = V0 (sym g + tau g),   sym *= V0,
///
/// which takes 33 multiplications where the general contraction takes 54 and a table of 81 moduli.
/// Particles are collected eight at a time; then the sums over them stay in registers while the
/// inner loops run over eight nodes b and vectorise. Launch with for_each_element(): no atomics,
/// the same bit for bit for any number of threads. Source: docs/theory.md, eq. (4.4).
///
/// \tparam Rows  where blocks go: BlockRows or StencilRows; also says in which precision they are
///              summed
template <class Shape, class Law, class Device, class Rows = BlockRows<Device>>
struct Tangent {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const Law*, Device> law;
  Rows rows;

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    const int element = elements.box.element(i, j, k);
    if (elements.particles.element_begin(element) == elements.particles.element_begin(element + 1))
      return;
    Blocks blocks;
    Batch batch;
    for_each_tangent(elements, law, i, j, k, bad, [&](const auto& point, const auto& tangent) {
      batch.add(point, tangent);
      if (batch.count == Batch::size) batch.add_blocks(blocks.K);
    });
    batch.add_blocks(blocks.K);
    blocks.add_to(rows, elements, i, j, k);
  }

 private:
  using Blocks = ElementBlocks<Shape, Rows>;
  using Real = typename Blocks::Real;
  static constexpr int n = Blocks::n, lanes = Blocks::lanes, padded = Blocks::padded;

  /// The vectors of a few particles, (particle, component, node).
  struct Batch {
    static constexpr int size = 8;
    int count = 0;
    Real g[size][3][padded], p[size][3][padded], q[size][3][padded], t[size][3][padded];
    Real symmetric[size];

    KOKKOS_INLINE_FUNCTION void add(const ParticlePoint<Shape>& point,
                                    const material::IsotropicTangent& a) {
      const int m = count++;
      const auto volume = static_cast<Real>(point.volume);
      const auto vol = static_cast<Real>(a.volumetric), sym = static_cast<Real>(a.symmetric);
      symmetric[m] = volume * sym;
      for (int c = 0; c < 3; ++c) {
        for (int b = 0; b < n; ++b) g[m][c][b] = static_cast<Real>(point.gradient[c][b]);
        for (int b = n; b < padded; ++b) g[m][c][b] = 0;
      }
      for (int c = 0; c < 3; ++c) {
        Real s[3], tau[3];
        for (int d = 0; d < 3; ++d) {
          s[d] = static_cast<Real>(-2.0 / 3.0 * a.s(c, d));
          tau[d] = static_cast<Real>(a.tau(c, d));
        }
        for (int b = 0; b < padded; ++b) {
          const Real sg = s[0] * g[m][0][b] + s[1] * g[m][1][b] + s[2] * g[m][2][b];
          const Real tau_g = tau[0] * g[m][0][b] + tau[1] * g[m][1][b] + tau[2] * g[m][2][b];
          p[m][c][b] = volume * (vol * g[m][c][b] + sg);
          q[m][c][b] = volume * sg;
          t[m][c][b] = volume * (sym * g[m][c][b] + tau_g);
        }
      }
    }

    /// K += the blocks of the particles collected, which are then forgotten.
    KOKKOS_INLINE_FUNCTION void add_blocks(Real (&K)[n][3][3][padded]) {
      for (int a = 0; a < n; ++a)
        for (int first = 0; first < padded; first += lanes) {
          Real sum[3][3][lanes];
          for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d)
              for (int b = 0; b < lanes; ++b) sum[c][d][b] = K[a][c][d][first + b];
          for (int m = 0; m < count; ++m) {
            Real in_line[lanes];  // g_a . t_b
            for (int b = 0; b < lanes; ++b)
              in_line[b] = g[m][0][a] * t[m][0][first + b] + g[m][1][a] * t[m][1][first + b] +
                           g[m][2][a] * t[m][2][first + b];
            for (int c = 0; c < 3; ++c) {
              const Real pa = p[m][c][a], ga = g[m][c][a];
              for (int d = 0; d < 3; ++d) {
                const Real across = symmetric[m] * g[m][d][a];
                for (int b = 0; b < lanes; ++b)
                  sum[c][d][b] += pa * g[m][d][first + b] + ga * q[m][d][first + b] +
                                  across * g[m][c][first + b];
              }
              for (int b = 0; b < lanes; ++b) sum[c][c][b] += in_line[b];
            }
          }
          for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d)
              for (int b = 0; b < lanes; ++b) K[a][c][d][first + b] = sum[c][d][b];
        }
      count = 0;
    }
  };
};

}  // namespace stroma::transfer
