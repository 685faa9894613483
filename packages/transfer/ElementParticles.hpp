// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Kinematics of the particles of one element: what every transfer kernel starts from.

#include "stroma/material/Drives.hpp"
#include "stroma/particles/Particles.hpp"
#include "stroma/shape/Place.hpp"
#include "stroma/tensor/Tensor3.hpp"
#include "stroma/transfer/ElementLoop.hpp"
#include "stroma/transfer/ParticleDomains.hpp"

namespace stroma::transfer {

using tensor::Tensor3;

/// The number of a point that is no particle.
constexpr int no_particle = -1;

/// One particle at the current configuration.
template <class Shape>
struct ParticlePoint {
  int p;                             ///< local number; no_particle: a fictitious point
  int like;                          ///< the particle whose material it is of: itself, if it is one
  int material;                      ///< index of its law
  double volume;                     ///< V0 [um^3]
  double value[Shape::nodes];        ///< N_a [-]
  double gradient[3][Shape::nodes];  ///< (j, a) dN_a/dx_j at the CURRENT configuration [1/um]
  Tensor3 H;                         ///< F - I, from the undeformed body [-]

  /// How far node a carries a point of the body that lies beside the particle, by F r for a vector
  /// r of the undeformed body [um], in the particle's linear field:
  /// d(x + F r)/dU_a = N_a + grad_x N_a . F r.
  KOKKOS_INLINE_FUNCTION double value_beside(int a, const double r[3]) const {
    double sum = value[a];
    for (int d = 0; d < 3; ++d) {
      const double along = r[d] + H(d, 0) * r[0] + H(d, 1) * r[1] + H(d, 2) * r[2];
      sum += gradient[d][a] * along;
    }
    return sum;
  }
};

/// The points of a rank, sorted by element, and its displaced nodes: what kernels work on, whatever
/// the shape functions.
template <class Device>
struct PointSet {
  using NodeView = Kokkos::View<const double* [3], Kokkos::LayoutRight, Device>;

  ElementBox box;
  particles::Particles<Device> particles;
  NodeView displacement;  ///< U of the touched nodes [um]
  /// (element) volume of each of its fictitious points [um^3], 0 for most; or empty: none.
  Kokkos::View<const float*, Device> fictitious_volume = {};
  ParticleDomains<Device> domains = {};  ///< as seeded
  bool stretches_domains = true;         ///< domains are F times as seeded
  bool averages_dilatation = false;      ///< over each element (MeanDilatation.hpp)
  double time_step = 0.0;                ///< since the histories [s]
  /// (material) what drives it; or empty: nothing does.
  Kokkos::View<const material::MaterialFactors*, Device> factors = {};
};

/// Particles and displaced nodes of a rank, element by element.
///
/// The nodes have moved by U since the base configuration, in which the grid is Cartesian. With
/// base gradients grad N this gives
///
///     f = I + sum_a U_a (x) grad N_a,    H = H_base + (f - I) + (f - I) H_base,
///     grad_x N_a = f^-T grad N_a.
///
/// The same formula serves a grid that convects (base = undeformed body, H_base = 0) and one that
/// is reset (base = last step): pulling gradients back to the base is what the inverse Jacobian of
/// a convected element does.
///
/// Elements that the body fills by less than half may hold fictitious points beside their
/// particles: a very soft material, at rest at the base configuration, that keeps nodes in place
/// which the body barely touches (docs/theory.md, "Barely filled elements").
///
/// Source: docs/theory.md, eq. (2.2) to (2.5).
template <class Shape, class Device>
struct ElementParticles : PointSet<Device> {
  using typename PointSet<Device>::NodeView;
  using PointSet<Device>::box;
  using PointSet<Device>::particles;
  using PointSet<Device>::displacement;
  using PointSet<Device>::fictitious_volume;
  using PointSet<Device>::domains;
  using PointSet<Device>::stretches_domains;
  using PointSet<Device>::averages_dilatation;
  using PointSet<Device>::time_step;

  /// Fictitious points of an element that has some: a regular pattern, as many per direction as
  /// there are functions.
  static constexpr int fictitious_points = Shape::nodes;

  /// Values of a nodal vector at the nodes of an element, (component, a).
  KOKKOS_FORCEINLINE_FUNCTION void gather(const NodeView& nodal, int i, int j, int k,
                                          double value[3][Shape::nodes]) const {
    for (int a = 0; a < Shape::nodes; ++a) {
      const int node = node_of(i, j, k, a);
      for (int c = 0; c < 3; ++c) value[c][a] = nodal(node, c);
    }
  }

  /// Touched-node number of local node a of an element.
  KOKKOS_FORCEINLINE_FUNCTION int node_of(int i, int j, int k, int a) const {
    constexpr int w = Shape::width;
    return box.node(i + a % w, j + a / w % w, k + a / (w * w));
  }

  /// H_base of a particle, which must have one.
  KOKKOS_INLINE_FUNCTION Tensor3 base_gradient(int p) const {
    Tensor3 base;
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) base(c, d) = particles.base_gradient(p, c, d);
    return base;
  }

  /// J_base - 1 of a particle [-].
  KOKKOS_INLINE_FUNCTION double base_jacobian_minus_one(int p) const {
    return particles.base_gradient.extent(0) == 0 ? 0.0 : tensor::det_minus_one(base_gradient(p));
  }

  /// Calls visit(ParticlePoint) for each particle of element (i, j, k); counts in `bad` those that
  /// the displacement turns inside out (det F <= 0, or not a number).
  template <class Visit>
  KOKKOS_FORCEINLINE_FUNCTION void for_each_particle(int i, int j, int k, std::int64_t& bad,
                                                     const Visit& visit) const {
    const int element = box.element(i, j, k);
    const int begin = particles.element_begin(element);
    const int end = particles.element_begin(element + 1);
    if (begin == end) return;
    double u[3][Shape::nodes];
    gather(displacement, i, j, k, u);
    shape::Place place = place_in(i, j, k);
    ParticlePoint<Shape> point;
    for (int p = begin; p < end; ++p) {
      set(p, i, j, k, u, place, point);
      if (!(1.0 + tensor::det_minus_one(point.H) > 0.0)) ++bad;
      visit(point);
    }
  }

  /// One particle of element (i, j, k), whose nodes move by u.
  KOKKOS_INLINE_FUNCTION ParticlePoint<Shape> particle(int p, int i, int j, int k,
                                                       const double u[3][Shape::nodes]) const {
    shape::Place place = place_in(i, j, k);
    ParticlePoint<Shape> point;
    set(p, i, j, k, u, place, point);
    return point;
  }

  /// The same for the particles and then the fictitious points: all that resists deformation.
  template <class Visit>
  KOKKOS_FORCEINLINE_FUNCTION void for_each_point(int i, int j, int k, std::int64_t& bad,
                                                  const Visit& visit) const {
    for_each_particle(i, j, k, bad, visit);
    if (fictitious_volume.extent(0) == 0) return;
    const int element = box.element(i, j, k);
    if (!(fictitious_volume(element) > 0.0f)) return;
    double u[3][Shape::nodes];
    gather(displacement, i, j, k, u);
    ParticlePoint<Shape> point;
    point.p = no_particle;
    point.like = particles.element_begin(element);
    point.material = particles.material(point.like);
    point.volume = static_cast<double>(fictitious_volume(element));
    shape::Place place = place_in(i, j, k);
    constexpr int w = Shape::width;
    const int index[3] = {i, j, k};
    double lower[3], length[3];
    for (int d = 0; d < 3; ++d) {
      double upper;
      box.within_ends(d, index[d], lower[d], upper);
      length[d] = upper - lower[d];
      for (int e = 0; e < 3; ++e)
        place.domain[d][e] = d == e ? 0.5 / w * length[d] * box.spacing[d] : 0.0;
    }
    for (int q = 0; q < fictitious_points; ++q) {
      const int number[3] = {q % w, q / w % w, q / (w * w)};
      for (int d = 0; d < 3; ++d) place.xi[d] = lower[d] + (number[d] + 0.5) / w * length[d];
      point.H = move(place, u, point);
      if (!(1.0 + tensor::det_minus_one(point.H) > 0.0)) ++bad;
      visit(point);
    }
  }

  /// Calls visit(p, G) for each particle p of element (i, j, k), G = sum_a U_a (x) grad N_a with
  /// gradients at the base configuration.
  template <class Visit>
  KOKKOS_INLINE_FUNCTION void for_each_base_gradient(int i, int j, int k,
                                                     const Visit& visit) const {
    const int element = box.element(i, j, k);
    double u[3][Shape::nodes];
    gather(displacement, i, j, k, u);
    shape::Place place = place_in(i, j, k);
    for (int p = particles.element_begin(element); p < particles.element_begin(element + 1); ++p) {
      double value[Shape::nodes], base_gradient[3][Shape::nodes];
      put(p, i, j, k, place);
      Shape::evaluate(place, value, base_gradient);
      visit(p, displacement_gradient(u, base_gradient));
    }
  }

 private:
  /// A place in an element, but for the point's own coordinates and domain.
  KOKKOS_FORCEINLINE_FUNCTION shape::Place place_in(int i, int j, int k) const {
    shape::Place place;
    const int index[3] = {i, j, k};
    for (int d = 0; d < 3; ++d) {
      place.inverse_h[d] = box.inverse_spacing[d];
      if constexpr (Shape::knows_ends) {
        place.element[d] = box.first[d] + index[d];
        place.elements[d] = box.all[d];
      }
    }
    return place;
  }

  /// Puts a particle into its place.
  KOKKOS_FORCEINLINE_FUNCTION void put(int p, int i, int j, int k, shape::Place& place) const {
    const int index[3] = {i, j, k};
    for (int d = 0; d < 3; ++d)
      place.xi[d] = (particles.position(p, d) - box.corner[d]) * box.inverse_spacing[d] - index[d];
    if constexpr (Shape::has_domain) {
      double half_edge[3];
      domains.half_edges(particles.id, p, half_edge);
      const bool stretched = stretches_domains && particles.base_gradient.extent(0) != 0;
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d) {
          const double F =
              (c == d ? 1.0 : 0.0) + (stretched ? particles.base_gradient(p, c, d) : 0.0);
          place.domain[c][d] = F * half_edge[d];
        }
    }
  }

  /// Everything about a particle; its place is given but for what put() sets.
  KOKKOS_FORCEINLINE_FUNCTION void set(int p, int i, int j, int k, const double u[3][Shape::nodes],
                                       shape::Place& place, ParticlePoint<Shape>& point) const {
    point.p = point.like = p;
    point.material = particles.material(p);
    point.volume = particles.volume(p);
    put(p, i, j, k, place);
    const Tensor3 G = move(place, u, point);
    point.H = G;
    if (particles.base_gradient.extent(0) == 0) return;
    const Tensor3 base = base_gradient(p);
    point.H = base + G + G * base;
  }

  KOKKOS_FORCEINLINE_FUNCTION static Tensor3 displacement_gradient(
      const double u[3][Shape::nodes], const double gradient[3][Shape::nodes]) {
    Tensor3 G;
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) {
        double sum = 0.0;
        for (int a = 0; a < Shape::nodes; ++a) sum += u[c][a] * gradient[d][a];
        G(c, d) = sum;
      }
    return G;
  }

  /// Values and current gradients of a point; returns f - I there.
  KOKKOS_FORCEINLINE_FUNCTION Tensor3 move(const shape::Place& place,
                                           const double u[3][Shape::nodes],
                                           ParticlePoint<Shape>& point) const {
    double base_gradient[3][Shape::nodes];
    Shape::evaluate(place, point.value, base_gradient);
    const Tensor3 G = displacement_gradient(u, base_gradient);
    const Tensor3 f_inverse = tensor::inverse(tensor::identity() + G);
    for (int d = 0; d < 3; ++d)
      for (int a = 0; a < Shape::nodes; ++a)
        point.gradient[d][a] = f_inverse(0, d) * base_gradient[0][a] +
                               f_inverse(1, d) * base_gradient[1][a] +
                               f_inverse(2, d) * base_gradient[2][a];
    return G;
  }
};

}  // namespace stroma::transfer
