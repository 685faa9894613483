#pragma once

/// \file
/// Particles to grid: the tangent (stiffness) matrix.

#include "material/NeoHookean.hpp"
#include "transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// Where the 3 x 3 blocks of the tangent go. Row nodes are touched nodes; the column of a block is the
/// row's neighbour in the 3 x 3 x 3 stencil, s = (dx + 1) + 3 (dy + 1) + 9 (dz + 1).
///
/// Rows of owned nodes are summed straight into the values of a compressed row matrix with three rows
/// per node, whose blocks are found by arithmetic; rows of nodes that other ranks own go to `shared`
/// and travel to their owners afterwards.
template <class Device>
struct BlockRows {
  Kokkos::View<const int*, Device> row;  ///< (touched node) owned node, or ~shared if negative
  Kokkos::View<const std::size_t*, Device> row_begin;      ///< (3 owned node + i) first entry
  Kokkos::View<const std::uint8_t* [27], Device> slot;     ///< (owned node, s) block within its row
  Kokkos::View<double*, Device> values;                    ///< entries of the matrix, added to
  Kokkos::View<double**, Kokkos::LayoutLeft, Device> shared;  ///< (shared, 9 s + 3 i + k), added to
  Kokkos::View<const std::uint8_t*, Device> held;  ///< (touched node) bit c: component c is prescribed

  /// Adds block(i, k) to row node I, neighbour s. Entries in prescribed rows or columns are left out.
  KOKKOS_INLINE_FUNCTION void add(int node, int neighbour, int s, const double block[3][3]) const {
    const int r = row(node);
    const int held_row = held(node), held_column = held(neighbour);
    for (int i = 0; i < 3; ++i) {
      if (held_row >> i & 1) continue;
      double* entry =
          r >= 0 ? &values(row_begin(3 * r + i) + 3 * slot(r, s)) : nullptr;
      for (int k = 0; k < 3; ++k) {
        if (held_column >> k & 1) continue;
        if (r >= 0) {
          entry[k] += block[i][k];
        } else {
          shared(~r, 9 * s + 3 * i + k) += block[i][k];
        }
      }
    }
  }
};

/// Adds the tangent of each element's particles to the rows of its nodes:
///
///     K_IiJk = sum_p V0 dN_I/dx_j a_ijkl dN_J/dx_l       [pN/um] = [Pa um]
///
/// with the law's spatial tangent a (material and geometric part). Formed element by element in two
/// sweeps per particle, T_ijk(b) = V0 a_ijkl dN_b/dx_l and K(a,i,k,b) += dN_a/dx_j T_ijk(b), whose inner
/// loops run over b and vectorise. Launch with for_each_element(): no atomics, the same bit for bit
/// for any number of threads. Source: docs/theory.md, eq. (T.11).
template <class Shape, class Law, class Device>
struct Tangent {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const Law*, Device> law;
  BlockRows<Device> rows;

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
              T[jj][c][m][b] = t0 * point.gradient[0][b] + t1 * point.gradient[1][b] +
                               t2 * point.gradient[2][b];
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
    for (int a = 0; a < n; ++a) {
      const int node = elements.node_of(i, j, k, a);
      for (int b = 0; b < n; ++b) {
        const int neighbour = elements.node_of(i, j, k, b);
        const int dz = elements.box.flat ? 0 : b / (w * w) - a / (w * w);
        const int s = (b % w - a % w + 1) + 3 * (b / w % w - a / w % w + 1) + 9 * (dz + 1);
        double block[3][3];
        for (int c = 0; c < 3; ++c)
          for (int m = 0; m < 3; ++m) block[c][m] = K[a][c][m][b];
        rows.add(node, neighbour, s, block);
      }
    }
  }
};

}  // namespace stroma::transfer
