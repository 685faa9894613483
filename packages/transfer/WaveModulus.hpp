// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How far particles are from losing ellipticity.

#include "stroma/material/FiberDirections.hpp"
#include "stroma/tensor/PrincipalValues.hpp"
#include "stroma/transfer/MeanDilatation.hpp"

namespace stroma::transfer {

/// The least modulus of a plane wave through each particle [Pa],
///
///     min over n, m of  m_i Q_ik m_k,   Q_ik = n_j a_ijkl n_l   (acoustic tensor, Kirchhoff),
///
/// over the directions n given, of every n-th particle; of others nothing is set. Where it is
/// negative the tangent is not elliptic: a band across n softens, and strains localise in it, on any
/// grid in as few elements as they can. Not a number for a particle turned inside out. Launch as
/// InternalForce.
/// Source: J. Rice, in Theoretical and Applied Mechanics (1976) 207; Ogden (1984), section 6.2.7.
template <class Shape, class Law, class Device>
struct WaveModulus {
  ElementParticles<Shape, Device> elements;
  Kokkos::View<const Law*, Device> law;
  Kokkos::View<const material::FiberDirection*, Device> directions;
  int every;                            ///< 1: all particles
  Kokkos::View<double*, Device> least;  ///< (particle) set

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    LawAt<Law, Device> law_at(law, elements);
    elements.for_each_particle(i, j, k, bad, [&](const ParticlePoint<Shape>& point) {
      if (point.p % every != 0) return;
      const Law& material = law_at(point);
      const double log_j = log1p(tensor::det_minus_one(point.H));
      const material::Tensor4 a =
          material.tangent(point.H, log_j, material.stress_of_volume(log_j)).in_full();
      double smallest = 0.0;
      for (std::size_t d = 0; d < directions.extent(0); ++d) {
        const double* const n = directions(d).n;
        Tensor3 Q;
        for (int r = 0; r < 3; ++r)
          for (int s = 0; s < 3; ++s)
            for (int p = 0; p < 3; ++p)
              for (int q = 0; q < 3; ++q) Q(r, s) += n[p] * a(r, p, s, q) * n[q];
        const double value = tensor::principal_values(Q)(2);
        if (d == 0 || !(value >= smallest)) smallest = value;
      }
      least(point.p) = smallest;
    });
  }
};

}  // namespace stroma::transfer
