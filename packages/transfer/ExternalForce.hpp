// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles to grid: the forces that act on the particles from outside.

#include "stroma/transfer/ElementParticles.hpp"

namespace stroma::transfer {

/// A force per reference volume on all particles. A dead traction t on a face of the undeformed
/// body is one as well: t / s on the outermost layer of particles, of thickness s, which acts at
/// the points of the face that ride beside them.
struct VolumeForce {
  double per_volume[3];  ///< [pN/um^3]; or, with per_mass, an acceleration times 1e-6 [m/s^2]
  bool per_mass;         ///< multiply by the density of the particle's material
  int axis;              ///< of the face's normal; -1: all particles, at their own places
  double face;           ///< where the face is along the axis [um]
  double thickness;      ///< of the layer of particles [um]
};

/// (particle, i) A force per reference volume that differs from particle to particle [pN/um^3], or
/// empty: none.
template <class Device>
using ForceAtParticles = Kokkos::View<const double* [3], Kokkos::LayoutRight, Device>;

/// Adds the external force at full load of each element's particles to its nodes:
///
///     f_Ii = sum_p N_I(x_p) f_pi,   f_p = V0 (b_p + sum (per_volume, times rho if per mass))   [pN]
///
/// with N_I + grad N_I . F r for N_I when the force acts at X_p + r. The forces are dead (they do
/// not change with the deformation), and N_I is that of the base configuration, as it is in the
/// whole step. Launch with for_each_element(). Source:
/// docs/theory.md, eq. (8.5).
template <class Shape, class Device>
struct ExternalForce {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const VolumeForce*, Device> forces;
  Kokkos::View<const double*, Device> density;                   ///< (material) [kg/m^3]
  ForceAtParticles<Device> at_particles;                         ///< b_p
  Kokkos::View<double* [3], Kokkos::LayoutRight, Device> force;  ///< (touched node, i), added to

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    const auto& particles = elements.particles;
    double f[3][Shape::nodes] = {};
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      for (std::size_t n = 0; n < forces.extent(0); ++n) {
        const VolumeForce& one = forces(n);
        double r[3] = {};
        if (one.axis >= 0) {
          r[one.axis] = one.face - particles.undeformed_position(point.p, one.axis);
          if (fabs(r[one.axis]) > one.thickness) continue;
        }
        const double scale = point.volume * (one.per_mass ? density(point.material) : 1.0);
        for (int a = 0; a < Shape::nodes; ++a) {
          const double carried = point.value_beside(a, r);
          for (int c = 0; c < 3; ++c) f[c][a] += scale * one.per_volume[c] * carried;
        }
      }
      if (at_particles.extent(0) != 0)
        for (int c = 0; c < 3; ++c)
          for (int a = 0; a < Shape::nodes; ++a)
            f[c][a] += point.volume * at_particles(point.p, c) * point.value[a];
    });
    for (int a = 0; a < Shape::nodes; ++a) {
      const int node = elements.node_of(i, j, k, a);
      for (int c = 0; c < 3; ++c) force(node, c) += f[c][a];
    }
  }
};

}  // namespace stroma::transfer
