// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Grid to particles: displacement and its gradient, stress and energy of each particle at the current
/// configuration.

#include "stroma/transfer/MeanDilatation.hpp"

namespace stroma::transfer {

/// Results at consecutive particles of a rank.
template <class Device>
struct ParticleFields {
  Kokkos::View<double* [3], Kokkos::LayoutRight, Device>
      displacement;  ///< u, from the undeformed body [um]
  Kokkos::View<double* [6], Kokkos::LayoutRight, Device>
      stress;  ///< Cauchy, xx yy zz xy yz zx [Pa]
  Kokkos::View<double* [3][3], Kokkos::LayoutRight, Device> gradient;  ///< H = F - I [-]
  Kokkos::View<double*, Device> jacobian;                              ///< J [-]
  Kokkos::View<double*, Device> energy;  ///< W, per reference volume [Pa]

  explicit ParticleFields(int count)
      : displacement(Kokkos::view_alloc("displacement", Kokkos::WithoutInitializing), count),
        stress(Kokkos::view_alloc("stress", Kokkos::WithoutInitializing), count),
        gradient(Kokkos::view_alloc("gradient", Kokkos::WithoutInitializing), count),
        jacobian(Kokkos::view_alloc("jacobian", Kokkos::WithoutInitializing), count),
        energy(Kokkos::view_alloc("energy", Kokkos::WithoutInitializing), count) {}
};

/// Calls visit(view of the first, view of the second ...) for each of the results.
template <class Visit, class... Fields>
void for_each_result(const Visit& visit, Fields&&... fields) {
  visit(fields.displacement...);
  visit(fields.stress...);
  visit(fields.gradient...);
  visit(fields.jacobian...);
  visit(fields.energy...);
}

/// Fills ParticleFields, whose entry 0 is the particle `first`: u_p = u_base + sum_I N_I U_I, and
/// the law at H, its energy of volume at the element's mean dilatation where that is asked for;
/// H has that dilatation too, so that det(I + H) = J.
/// Each particle is written by its own element alone: nothing is atomic.
template <class Shape, class Law, class Device>
struct GridToParticles {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const Law*, Device> law;
  ParticleFields<Device> fields;
  int first = 0;

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    double u[3][Shape::nodes];
    elements.gather(elements.displacement, i, j, k, u);
    const MeanDilatation mean = mean_dilatation(elements, i, j, k);
    LawAt<Law, Device> law_at(law, elements);
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      const int p = point.p;
      const bool has_base = elements.particles.base_displacement.extent(0) != 0;
      for (int c = 0; c < 3; ++c) {
        double sum = has_base ? elements.particles.base_displacement(p, c) : 0.0;
        for (int a = 0; a < Shape::nodes; ++a) sum += point.value[a] * u[c][a];
        fields.displacement(p - first, c) = sum;
      }
      const Law& material = law_at(point);
      const double growth = tensor::det_minus_one(point.H), log_j = log1p(growth);
      double jacobian = 1.0 + growth, log_of_volume = log_j;
      if (mean.holds_for(point)) {
        log_of_volume = log_mean_jacobian(elements, mean, p);
        jacobian = exp(log_of_volume);
      }
      const Tensor3 sigma =
          (1.0 / jacobian) *
          material.kirchhoff_stress(point.H, log_j, material.stress_of_volume(log_of_volume));
      const double components[6] = {sigma(0, 0), sigma(1, 1), sigma(2, 2),
                                    sigma(0, 1), sigma(1, 2), sigma(2, 0)};
      for (int c = 0; c < 6; ++c) fields.stress(p - first, c) = components[c];
      const Tensor3 H = with_mean_dilatation(elements, mean, point);
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d) fields.gradient(p - first, c, d) = H(c, d);
      fields.jacobian(p - first) = jacobian;
      fields.energy(p - first) = material.energy(point.H, material.energy_of_volume(log_of_volume));
    });
  }
};

}  // namespace stroma::transfer
