// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles and grid: points of the body's faces that springs hold where a condition wants them.

#include "stroma/transfer/Tangent.hpp"

namespace stroma::transfer {

/// A point X_b = X_p + r of a face of the undeformed body. It rides beside the particle p that it
/// belongs to, in whose linear field its displacement is u_b = u_p + H_p r.
struct BoundaryPoint {
  int particle;
  int condition;           ///< index of the condition that it helps to impose
  int components;          ///< bit c: component c is prescribed
  double spring;           ///< k = epsilon A [pN/um]
  double offset[3];        ///< r [um]
  double displacement[3];  ///< u* that the condition wants at the present load [um]
};

/// The boundary points of a rank, sorted by element.
template <class Device>
struct BoundaryPointSet {
  Kokkos::View<const BoundaryPoint*, Device> point;
  Kokkos::View<const int*, Device> element_begin;  ///< (elements + 1), as for particles
  bool lumped = false;  ///< the tangent is replaced by a diagonal one that is no softer
};

/// How far a boundary point is from where the condition wants it, in the components that are
/// prescribed: gap = u_p + H r - u*  [um].
template <class Shape, class Device>
KOKKOS_INLINE_FUNCTION void gap_of(const BoundaryPoint& b, const ParticlePoint<Shape>& point,
                                   const particles::Particles<Device>& particles,
                                   const double u[3][Shape::nodes], double gap[3]) {
  for (int c = 0; c < 3; ++c) {
    gap[c] = 0.0;
    if (!(b.components >> c & 1)) continue;
    double sum = -b.displacement[c];
    if (particles.base_displacement.extent(0) != 0) sum += particles.base_displacement(point.p, c);
    for (int a = 0; a < Shape::nodes; ++a) sum += point.value[a] * u[c][a];
    for (int d = 0; d < 3; ++d) sum += point.H(c, d) * b.offset[d];
    gap[c] = sum;
  }
}

/// Calls visit(number, BoundaryPoint, ParticlePoint, u, carried) for each boundary point of element
/// (i, j, k): with its particle, the displacements u of the element's nodes, and how far each of
/// them carries the point (ParticlePoint::value_beside).
template <class Shape, class Device, class Visit>
KOKKOS_INLINE_FUNCTION void for_each_boundary_point(const ElementParticles<Shape, Device>& elements,
                                                    const BoundaryPointSet<Device>& boundary, int i,
                                                    int j, int k, const Visit& visit) {
  const int element = elements.box.element(i, j, k);
  const int begin = boundary.element_begin(element), end = boundary.element_begin(element + 1);
  if (begin == end) return;
  double u[3][Shape::nodes];
  elements.gather(elements.displacement, i, j, k, u);
  for (int n = begin; n < end; ++n) {
    const BoundaryPoint& b = boundary.point(n);
    const ParticlePoint<Shape> point = elements.particle(b.particle, i, j, k, u);
    double carried[Shape::nodes];
    for (int a = 0; a < Shape::nodes; ++a) carried[a] = point.value_beside(a, b.offset);
    visit(n, b, point, u, carried);
  }
}

/// Adds the force of the boundary points' springs to the nodes, the derivative of the energy
/// sum_b k/2 |gap_b|^2 by U_I:
///
///     f_I = sum_b k gap_b (N_I + grad_x N_I . F r)       [pN]
///
/// Launch with for_each_element(). Source: docs/theory.md, eq. (8.3).
template <class Shape, class Device>
struct SpringForce {
  ElementParticles<Shape, Device> elements;
  BoundaryPointSet<Device> boundary;
  Kokkos::View<double* [3], Kokkos::LayoutRight, Device> force;  ///< (touched node, i), added to

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t&) const {
    for_each_boundary_point(
        elements, boundary, i, j, k,
        [&](int, const BoundaryPoint& b, const ParticlePoint<Shape>& point,
            const double(&u)[3][Shape::nodes], const double(&carried)[Shape::nodes]) {
          double gap[3];
          gap_of(b, point, elements.particles, u, gap);
          for (int a = 0; a < Shape::nodes; ++a) {
            const int node = elements.node_of(i, j, k, a);
            for (int c = 0; c < 3; ++c) force(node, c) += b.spring * gap[c] * carried[a];
          }
        });
  }
};

/// The gap of each boundary point [um]; 0 in components that are not prescribed.
template <class Shape, class Device>
struct BoundaryGaps {
  ElementParticles<Shape, Device> elements;
  BoundaryPointSet<Device> boundary;
  Kokkos::View<double* [3], Kokkos::LayoutRight, Device> gap;  ///< (boundary point, c), written

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t&) const {
    for_each_boundary_point(elements, boundary, i, j, k,
                            [&](int n, const BoundaryPoint& b, const ParticlePoint<Shape>& point,
                                const double(&u)[3][Shape::nodes], const double(&)[Shape::nodes]) {
                              gap_of(b, point, elements.particles, u, &gap(n, 0));
                            });
  }
};

/// Adds the springs' tangent, which does not depend on the displacement:
///
///     K_IcJc = sum_b k (N_I + grad_x N_I . F r) (N_J + grad_x N_J . F r)       [pN/um]
///
/// for each prescribed component c; or, lumped, the diagonal sum_b k |w_I| sum_J |w_J| with
/// w = N + grad_x N . F r, whose energy is as large or larger in every direction. Source:
/// docs/theory.md, eq. (8.4).
template <class Shape, class Device, class Rows>
struct SpringTangent {
  ElementParticles<Shape, Device> elements;
  BoundaryPointSet<Device> boundary;
  Rows rows;

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t&) const {
    using Blocks = ElementBlocks<Shape, Rows>;
    const int element = elements.box.element(i, j, k);
    if (boundary.element_begin(element) == boundary.element_begin(element + 1)) return;
    Blocks blocks;
    for_each_boundary_point(
        elements, boundary, i, j, k,
        [&](int, const BoundaryPoint& b, const ParticlePoint<Shape>&,
            const double(&)[3][Shape::nodes], const double(&carried)[Shape::nodes]) {
          using Real = typename Blocks::Real;
          double all = 0.0;
          for (int a = 0; a < Shape::nodes; ++a) all += fabs(carried[a]);
          for (int c = 0; c < 3; ++c) {
            if (!(b.components >> c & 1)) continue;
            for (int a = 0; a < Shape::nodes; ++a) {
              if (boundary.lumped) {
                blocks.K[a][c][c][a] += static_cast<Real>(b.spring * fabs(carried[a]) * all);
                continue;
              }
              for (int m = 0; m < Shape::nodes; ++m)
                blocks.K[a][c][c][m] += static_cast<Real>(b.spring * carried[a] * carried[m]);
            }
          }
        });
    blocks.add_to(rows, elements, i, j, k);
  }
};

/// Adds the product of the springs' tangent with a vector v.
template <class Shape, class Device>
struct SpringTangentTimes {
  ElementParticles<Shape, Device> elements;
  BoundaryPointSet<Device> boundary;
  Kokkos::View<const double* [3], Kokkos::LayoutRight, Device> direction;  ///< v (touched node, i)
  Kokkos::View<double* [3], Kokkos::LayoutRight, Device> product;          ///< added to

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t&) const {
    for_each_boundary_point(
        elements, boundary, i, j, k,
        [&](int, const BoundaryPoint& b, const ParticlePoint<Shape>&,
            const double(&)[3][Shape::nodes], const double(&carried)[Shape::nodes]) {
          for (int c = 0; c < 3; ++c) {
            if (!(b.components >> c & 1)) continue;
            double along = 0.0;
            for (int a = 0; a < Shape::nodes; ++a)
              along += carried[a] * direction(elements.node_of(i, j, k, a), c);
            for (int a = 0; a < Shape::nodes; ++a)
              product(elements.node_of(i, j, k, a), c) += b.spring * along * carried[a];
          }
        });
  }
};

}  // namespace stroma::transfer
