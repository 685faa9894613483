// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles to grid and back: the projection of what particles carry, and of displacements as the
/// paper's equations 1 and 2 describe it.

#include "stroma/transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// Adds the mass, and the mass times a vector u_p, of each element's particles to its nodes:
///
///     m_I = sum_p m_p N_I,    (m u)_I = sum_p m_p N_I u_p,     m_p = V0 rho
///
/// whose quotient is, with the displacement from the undeformed body, the paper's equation 1; with
/// a velocity, (m v)_I is the nodes' momentum. Launch with for_each_element(). Source:
/// docs/theory.md, eq. (2.8).
template <class Shape, class Device>
struct ProjectToNodes {
  using NodeView = Kokkos::View<double* [3], Kokkos::LayoutRight, Device>;

  ElementParticles<Shape, Device> elements;
  Kokkos::View<const double* [3], Kokkos::LayoutRight, Device> field;  ///< u_p
  Kokkos::View<const double*, Device> density;                         ///< (material), any unit
  NodeView mass;      ///< (touched node, 0), added to
  NodeView momentum;  ///< (touched node, i) m u, added to

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    double m[Shape::nodes] = {}, mu[3][Shape::nodes] = {};
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      const double mass_of_particle = point.volume * density(point.material);
      for (int a = 0; a < Shape::nodes; ++a) {
        m[a] += mass_of_particle * point.value[a];
        for (int c = 0; c < 3; ++c)
          mu[c][a] += mass_of_particle * point.value[a] * field(point.p, c);
      }
    });
    for (int a = 0; a < Shape::nodes; ++a) {
      const int node = elements.node_of(i, j, k, a);
      mass(node, 0) += m[a];
      for (int c = 0; c < 3; ++c) momentum(node, c) += mu[c][a];
    }
  }
};

/// Sets each particle's deformation at the base from the nodal displacements u_I, the paper's
/// equation 2. Gradients on the grid are those of the deformed configuration x = X + u, so
///
///     F = dx/dX = (dX/dx)^-1 = (I - sum_I u_I (x) grad_x N_I)^-1.
///
/// `elements.displacement` holds u_I. Source: docs/theory.md, eq. (2.9).
template <class Shape, class Device>
struct GradientFromDisplacement {
  ElementParticles<Shape, Device> elements;

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    elements.for_each_base_gradient(i, j, k, [&](int p, const Tensor3& G) {
      const Tensor3 F = tensor::inverse(tensor::identity() - G);
      const Tensor3 H = F * G;  // (I - G)^-1 - I, without cancellation
      if (!(1.0 + tensor::det_minus_one(H) > 0.0)) ++bad;
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d) elements.particles.base_gradient(p, c, d) = H(c, d);
    });
  }
};

/// Adds to a vector of each particle what nodal values v carry: w_p += sum_I N_I v_I.
/// `elements.displacement` holds v.
template <class Shape, class Device>
struct AddAtParticles {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<double* [3], Kokkos::LayoutRight, Device> field;  ///< (particle, i) w, added to

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    double v[3][Shape::nodes];
    elements.gather(elements.displacement, i, j, k, v);
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      for (int c = 0; c < 3; ++c)
        for (int a = 0; a < Shape::nodes; ++a) field(point.p, c) += point.value[a] * v[c][a];
    });
  }
};

/// Sets each particle's gradient of nodal values v at the current configuration:
/// G_p = sum_I v_I (x) grad_x N_I. `elements.displacement` is that of the nodes.
template <class Shape, class Device>
struct GradientAtParticles {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const double* [3], Kokkos::LayoutRight, Device> nodal;  ///< (touched node, i) v
  Kokkos::View<double* [3][3], Kokkos::LayoutRight, Device> gradient;  ///< (particle, i, j)

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    double v[3][Shape::nodes];
    elements.gather(nodal, i, j, k, v);
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d) {
          double sum = 0.0;
          for (int a = 0; a < Shape::nodes; ++a) sum += v[c][a] * point.gradient[d][a];
          gradient(point.p, c, d) = sum;
        }
    });
  }
};

}  // namespace stroma::transfer
