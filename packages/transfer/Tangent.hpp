#pragma once

/// \file
/// Particles to grid: the tangent (stiffness) matrix.

#include "material/NeoHookean.hpp"
#include "transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// Where the 3 x 3 blocks of the tangent go. Row nodes are touched nodes; the column of a block is
/// the row's neighbour in the 3 x 3 x 3 stencil, s = (dx + 1) + 3 (dy + 1) + 9 (dz + 1).
///
/// Rows of owned nodes are summed straight into the values of a compressed row matrix with three
/// rows per node, whose blocks are found by arithmetic; rows of nodes that other ranks own go to
/// `shared` and travel to their owners afterwards. Entries in prescribed rows and columns are left
/// out.
template <class Device>
struct BlockRows {
  Kokkos::View<const int*, Device> row;  ///< (touched node) owned node, or ~shared if negative
  Kokkos::View<const std::size_t*, Device> row_begin;   ///< (3 owned node + i) first entry
  Kokkos::View<const std::uint8_t* [27], Device> slot;  ///< (owned node, s) block within its row
  Kokkos::View<double*, Device> values;                 ///< entries of the matrix, added to
  Kokkos::View<double**, Kokkos::LayoutLeft, Device> shared;  ///< (shared, 9 s + 3 i + k), added to
  Kokkos::View<const std::uint8_t*, Device>
      held;  ///< (touched node) bit c: component c is prescribed

  /// Adds an element's blocks K(i, k, b) to the rows of one of its nodes, b being the element's
  /// nodes and s(b) their places in the node's stencil.
  template <int Nodes>
  KOKKOS_INLINE_FUNCTION void add(int node, const double K[3][3][Nodes], const int s[Nodes]) const {
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

/// Adds the tangent of each element's particles to the rows of its nodes:
///
///     K_IiJk = sum_p V0 dN_I/dx_j a_ijkl dN_J/dx_l       [pN/um] = [Pa um]
///
/// with the law's spatial tangent a (material and geometric part). Formed element by element in two
/// sweeps per particle, T_ijk(b) = V0 a_ijkl dN_b/dx_l and K(a,i,k,b) += dN_a/dx_j T_ijk(b), whose
/// inner loops run over b and vectorise. Launch with for_each_element(): no atomics, the same bit
/// for bit for any number of threads. Source: docs/theory.md, eq. (T.11).
///
/// \tparam Rows  where blocks go: BlockRows or StencilRows
template <class Shape, class Law, class Device, class Rows = BlockRows<Device>>
struct Tangent {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const Law*, Device> law;
  Rows rows;

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    constexpr int n = Shape::nodes;
    constexpr int w = Shape::width;
    const int element = elements.box.element(i, j, k);
    if (elements.particles.element_begin(element) == elements.particles.element_begin(element + 1))
      return;
    double K[n][3][3][n] = {};
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      Tensor3 tau;
      material::Tensor4 tangent;
      law(elements.particles.material(point.p)).stress_and_tangent(point.H, tau, tangent);
      double T[3][3][3][n];  // (j, i, k, b)
      for (int jj = 0; jj < 3; ++jj)
        for (int c = 0; c < 3; ++c)
          for (int m = 0; m < 3; ++m) {
            const double t0 = point.volume * tangent(c, jj, m, 0);
            const double t1 = point.volume * tangent(c, jj, m, 1);
            const double t2 = point.volume * tangent(c, jj, m, 2);
            for (int b = 0; b < n; ++b)
              T[jj][c][m][b] =
                  t0 * point.gradient[0][b] + t1 * point.gradient[1][b] + t2 * point.gradient[2][b];
          }
      for (int a = 0; a < n; ++a) {
        const double g0 = point.gradient[0][a], g1 = point.gradient[1][a],
                     g2 = point.gradient[2][a];
        for (int c = 0; c < 3; ++c)
          for (int m = 0; m < 3; ++m)
            for (int b = 0; b < n; ++b)
              K[a][c][m][b] += g0 * T[0][c][m][b] + g1 * T[1][c][m][b] + g2 * T[2][c][m][b];
      }
    });
    int node[n], held[n], any_held = 0;
    for (int a = 0; a < n; ++a) {
      node[a] = elements.node_of(i, j, k, a);
      held[a] = rows.held(node[a]);
      any_held |= held[a];
    }
    if (any_held) leave_out(held, K);
    for (int a = 0; a < n; ++a) {
      int s[n];  // place of node b in the stencil of node a
      for (int b = 0; b < n; ++b) {
        const int dz = elements.box.flat ? 0 : b / (w * w) - a / (w * w);
        s[b] = (b % w - a % w + 1) + 3 * (b / w % w - a / w % w + 1) + 9 * (dz + 1);
      }
      rows.template add<n>(node[a], K[a], s);
    }
  }

 private:
  /// Clears the rows and columns of prescribed components.
  KOKKOS_INLINE_FUNCTION static void leave_out(const int held[Shape::nodes],
                                               double K[][3][3][Shape::nodes]) {
    for (int a = 0; a < Shape::nodes; ++a)
      for (int c = 0; c < 3; ++c)
        for (int m = 0; m < 3; ++m)
          for (int b = 0; b < Shape::nodes; ++b)
            if ((held[a] >> c & 1) || (held[b] >> m & 1)) K[a][c][m][b] = 0.0;
  }
};

}  // namespace stroma::transfer
