// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The change of volume of an element as a whole in place of its particles' own, against locking;
/// and the loops over points with stress and tangent by the one or the other.

#include "stroma/material/Law.hpp"
#include "stroma/transfer/LawAt.hpp"

namespace stroma::transfer {

/// Mean dilatation of the particles of one element. With j_p = det f_p and v_p = V0 J_base,p, a
/// particle's Jacobian since the base configuration and its volume there,
///
///     jbar = theta / sum_p v_p,     theta = sum_p v_p j_p = sum_p V0 J_p    (the element's volume)
///
/// and a particle's energy of volume is that at Jt_p = J_base,p jbar instead of J_p. Fictitious
/// points keep their own.
///
/// Source: docs/theory.md, eq. (6.1), (6.2).
struct MeanDilatation {
  bool is_on = false;       ///< else each particle has its own
  double volume = 0.0;      ///< theta [um^3]
  double log_change = 0.0;  ///< ln jbar [-]

  template <class Shape>
  KOKKOS_INLINE_FUNCTION bool holds_for(const ParticlePoint<Shape>& point) const {
    return is_on && point.p != no_particle;
  }
};

/// The mean dilatation of an element; off where it was not asked for, or no particle is.
template <class Shape, class Device>
KOKKOS_FUNCTION MeanDilatation mean_dilatation(const ElementParticles<Shape, Device>& elements,
                                               int i, int j, int k) {
  MeanDilatation mean;
  if (!elements.averages_dilatation) return mean;
  double before = 0.0, change = 0.0;  // sum_p v_p, sum_p v_p (j_p - 1)
  elements.for_each_base_gradient(i, j, k, [&](int p, const Tensor3& G) {
    const double v = elements.particles.volume(p) * (1.0 + elements.base_jacobian_minus_one(p));
    before += v;
    change += v * tensor::det_minus_one(G);
  });
  mean.is_on = before > 0.0;
  mean.volume = before + change;
  mean.log_change = log1p(change / before);
  return mean;
}

/// ln Jt of a particle [-].
template <class Shape, class Device>
KOKKOS_INLINE_FUNCTION double log_mean_jacobian(const ElementParticles<Shape, Device>& elements,
                                                const MeanDilatation& mean, int p) {
  return log1p(elements.base_jacobian_minus_one(p)) + mean.log_change;
}

/// H of a particle as results show it and as a step leaves it to the next: of F (Jt/J)^(1/3), whose
/// determinant is Jt. H itself where dilatation is pointwise, and where one of the two volumes is
/// not positive, for then the step is rejected.
template <class Shape, class Device>
KOKKOS_INLINE_FUNCTION Tensor3 with_mean_dilatation(const ElementParticles<Shape, Device>& elements,
                                                    const MeanDilatation& mean,
                                                    const ParticlePoint<Shape>& point) {
  if (!mean.holds_for(point)) return point.H;
  const double log_j = log1p(tensor::det_minus_one(point.H));
  const double growth = expm1((log_mean_jacobian(elements, mean, point.p) - log_j) / 3.0);
  if (!(growth > -1.0)) return point.H;
  return point.H + growth * (tensor::identity() + point.H);
}

/// The pressure that belongs to an element's volume: the derivative of the sum of V0 U(Jt_p) by it.
struct MeanPressure {
  double pressure = 0.0;  ///< P = sum_p V0 p(Jt_p) / theta [Pa], p = dU/d ln J
  double slope = 0.0;     ///< dP/dtheta = sum_p V0 (dp/d ln J - p) / theta^2 [Pa/um^3]
};

template <class Shape, class Law, class Device>
KOKKOS_FUNCTION MeanPressure mean_pressure(const ElementParticles<Shape, Device>& elements,
                                           const Kokkos::View<const Law*, Device>& law,
                                           const MeanDilatation& mean, int i, int j, int k) {
  MeanPressure result;
  if (!mean.is_on) return result;
  const auto& particles = elements.particles;
  LawAt<Law, Device> law_at(law, elements);
  const int element = elements.box.element(i, j, k);
  for (int p = particles.element_begin(element); p < particles.element_begin(element + 1); ++p) {
    const material::VolumetricStress stress =
        law_at(p).stress_of_volume(log_mean_jacobian(elements, mean, p));
    result.pressure += particles.volume(p) * stress.pressure;
    result.slope += particles.volume(p) * (stress.modulus - stress.pressure);
  }
  result.pressure /= mean.volume;
  result.slope /= mean.volume * mean.volume;
  return result;
}

/// A point's part of the force and tangent of its element's volume: with f_I = P dtheta/dU_I and
/// dtheta/dU_I = sum_p V0 J_p grad_x N_I it is that of a pressure J P and a modulus J P.
KOKKOS_INLINE_FUNCTION material::VolumetricStress share_of(const MeanPressure& mean, double log_j) {
  const double p = exp(log_j) * mean.pressure;
  return {p, p};
}

/// Calls visit(ParticlePoint, tau) for each point of element (i, j, k), as for_each_point(): the
/// internal force is sum_p V0 tau grad_x N (6.3).
template <class Shape, class Law, class Device, class Visit>
KOKKOS_FORCEINLINE_FUNCTION void for_each_stress(const ElementParticles<Shape, Device>& elements,
                                                 const Kokkos::View<const Law*, Device>& law, int i,
                                                 int j, int k, std::int64_t& bad,
                                                 const Visit& visit) {
  const MeanDilatation mean = mean_dilatation(elements, i, j, k);
  const MeanPressure pressure = mean_pressure(elements, law, mean, i, j, k);
  LawAt<Law, Device> law_at(law, elements);
  elements.for_each_point(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
    const Law& material = law_at(point);
    const double log_j = material::log_jacobian(point.H);
    visit(point,
          material.kirchhoff_stress(point.H, log_j,
                                    mean.holds_for(point) ? share_of(pressure, log_j)
                                                          : material.stress_of_volume(log_j)));
  });
}

/// Calls visit(ParticlePoint, Law::Tangent) for each point of element (i, j, k): the tangent is
/// sum_p V0 grad_x N a grad_x N (6.4). With mean dilatation a last point stands for the element as
/// a whole: its "gradient" is dtheta/dU and its tangent dP/dtheta alone, so that it adds
/// dP/dtheta dtheta/dU (x) dtheta/dU.
template <class Shape, class Law, class Device, class Visit>
KOKKOS_FORCEINLINE_FUNCTION void for_each_tangent(const ElementParticles<Shape, Device>& elements,
                                                  const Kokkos::View<const Law*, Device>& law,
                                                  int i, int j, int k, std::int64_t& bad,
                                                  const Visit& visit) {
  const MeanDilatation mean = mean_dilatation(elements, i, j, k);
  const MeanPressure pressure = mean_pressure(elements, law, mean, i, j, k);
  ParticlePoint<Shape> whole = {};
  LawAt<Law, Device> law_at(law, elements);
  elements.for_each_point(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
    const Law& material = law_at(point);
    const double log_j = material::log_jacobian(point.H);
    material::VolumetricStress volume;
    if (mean.holds_for(point)) {
      volume = share_of(pressure, log_j);
      const double now = point.volume * exp(log_j);
      for (int c = 0; c < 3; ++c)
        for (int a = 0; a < Shape::nodes; ++a) whole.gradient[c][a] += now * point.gradient[c][a];
    } else {
      volume = material.stress_of_volume(log_j);
    }
    visit(point, material.tangent(point.H, log_j, volume));
  });
  if (!mean.is_on) return;
  whole.p = no_particle;
  whole.volume = 1.0;
  visit(whole, Law::Tangent::of_volume(pressure.slope));
}

}  // namespace stroma::transfer
