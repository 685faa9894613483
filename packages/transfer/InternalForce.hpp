// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles to grid: the internal force at the nodes, and its directional derivative.

#include "stroma/transfer/MeanDilatation.hpp"

namespace stroma::transfer {

/// Adds the internal force of each element's points to its nodes:
///
///     f_Ii = sum_p V0 tau_ij dN_I/dx_j       [pN] = [Pa um^2]
///
/// Launch with for_each_element(): no atomics, the same bit for bit for any number of threads.
/// Source: docs/theory.md, eq. (4.3).
template <class Shape, class Law, class Device>
struct InternalForce {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const Law*, Device> law;  ///< (material)
  Kokkos::View<double* [3], Kokkos::LayoutRight, Device>
      force;  ///< (touched node, i) [pN], added to

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    double f[3][Shape::nodes] = {};
    for_each_stress(elements, law, i, j, k, bad, [&](const auto& point, const Tensor3& tau) {
      for (int c = 0; c < 3; ++c)
        for (int a = 0; a < Shape::nodes; ++a)
          f[c][a] +=
              point.volume * (tau(c, 0) * point.gradient[0][a] + tau(c, 1) * point.gradient[1][a] +
                              tau(c, 2) * point.gradient[2][a]);
    });
    for (int a = 0; a < Shape::nodes; ++a) {
      const int node = elements.node_of(i, j, k, a);
      for (int c = 0; c < 3; ++c) force(node, c) += f[c][a];
    }
  }
};

/// Adds the change of the internal force along a direction v (the tangent times v, never formed):
///
///     df_Ii = sum_p V0 (a : D)_ij dN_I/dx_j,   D = sum_I v_I (x) grad_x N_I       [pN]
///
/// with the spatial tangent a of the law. Launch as InternalForce.
template <class Shape, class Law, class Device>
struct TangentTimes {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const Law*, Device> law;
  Kokkos::View<const double* [3], Kokkos::LayoutRight, Device> direction;  ///< v (touched node, i)
  Kokkos::View<double* [3], Kokkos::LayoutRight, Device> product;          ///< added to

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    double v[3][Shape::nodes];
    elements.gather(direction, i, j, k, v);
    double f[3][Shape::nodes] = {};
    for_each_tangent(elements, law, i, j, k, bad, [&](const auto& point, const auto& a_of_point) {
      const material::Tensor4 tangent = a_of_point.in_full();
      Tensor3 D;
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
          for (int a = 0; a < Shape::nodes; ++a) D(c, d) += v[c][a] * point.gradient[d][a];
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d) {
          double stress = 0.0;
          for (int m = 0; m < 3; ++m)
            for (int n = 0; n < 3; ++n) stress += tangent(c, d, m, n) * D(m, n);
          for (int a = 0; a < Shape::nodes; ++a)
            f[c][a] += point.volume * stress * point.gradient[d][a];
        }
    });
    for (int a = 0; a < Shape::nodes; ++a) {
      const int node = elements.node_of(i, j, k, a);
      for (int c = 0; c < 3; ++c) product(node, c) += f[c][a];
    }
  }
};

}  // namespace stroma::transfer
