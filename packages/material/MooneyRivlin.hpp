// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The solid of Mooney and Rivlin.

#include "stroma/material/LawParameters.hpp"

namespace stroma::material {

/// Isotropic hyperelastic solid,
///
///     W = C1 (Ibar1 - 3) + C2 (Ibar2 - 3) + U(J),
///
/// with the invariants of bbar = J^(-2/3) b, b = F F^T. With C2 = 0 it is NeoHookean, mu = 2 C1.
/// Source: Holzapfel (2000), sections 6.4 and 6.6.
struct MooneyRivlin {
  double c1, c2;        ///< [Pa], C1 + C2 > 0
  double bulk_modulus;  ///< K [Pa], > 0
  VolumetricEnergy volumetric_energy = VolumetricEnergy::logarithmic;

  static const char* name() { return "Mooney-Rivlin"; }
  static const char* meaning() {
    return "W = C1 (Ibar1 - 3) + C2 (Ibar2 - 3) + U(J), mu = 2 (C1 + C2)";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("C1 [Pa]", &MooneyRivlin::c1, Range::any(), "Modulus C1 of Ibar1.");
    parameters.number("C2 [Pa]", &MooneyRivlin::c2, Range::any(), "Modulus C2 of Ibar2.");
    declare_bulk_modulus(parameters, &MooneyRivlin::bulk_modulus);
    parameters.volumetric_energy(&MooneyRivlin::volumetric_energy);
  }

  using Tangent = FullTangent;

  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const {
    return {2.0 * (c1 + c2), bulk_modulus};
  }
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    return material::energy_of_volume(volumetric_energy, bulk_modulus, log_j);
  }
  KOKKOS_INLINE_FUNCTION VolumetricStress stress_of_volume(double log_j) const {
    return material::stress_of_volume(volumetric_energy, bulk_modulus, log_j);
  }

  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return c1 * isochoric_first_invariant_minus_3(H) + c2 * isochoric_second_invariant_minus_3(H) +
           of_volume;
  }

  /// tau = 2 C1 dev(bbar) + 2 C2 dev(Ibar1 bbar - bbar^2) + p I. With b = I + e, e small where the
  /// strain is, dev(I1 b - b^2) = dev((1 + tr e) e - e^2).
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    const double factor = exp(-2.0 / 3.0 * log_j);
    const Tensor3 e = tensor::left_cauchy_green_minus_identity(H);
    Tensor3 tau = (2.0 * factor) *
                  tensor::deviator(c1 * e + (c2 * factor) * ((1.0 + tensor::trace(e)) * e - e * e));
    for (int i = 0; i < 3; ++i) tau(i, i) += volume.pressure;
    return tau;
  }

  /// With s = dev tau, f_1 = 2 C1 Ibar1, f_2 = 4 C2 Ibar2 the traces of the two parts of tau before
  /// the deviator is taken, and P = I4 - 1/3 I x I,
  ///
  ///     c = 4 C2 P : (bbar x bbar - bbar (.) bbar) : P + 2/3 (f_1 + f_2) P - 2/3 (s x I + I x s)
  ///         + M I x I - 2 p I4,     (b (.) b)_ijkl = (b_ik b_jl + b_il b_jk) / 2,
  ///
  ///     P : (b x b) : P = dev b x dev b,
  ///     P : (b (.) b) : P = b (.) b - 1/3 (b^2 x I + I x b^2) + 1/9 tr(b^2) I x I.
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    const double factor = exp(-2.0 / 3.0 * log_j);
    const Tensor3 b = factor * (tensor::identity() + tensor::left_cauchy_green_minus_identity(H));
    const Tensor3 b2 = b * b, dev_b = tensor::deviator(b);
    const double i1 = tensor::trace(b), tr_b2 = tensor::trace(b2);
    const double traces = 2.0 * c1 * i1 + 2.0 * c2 * (i1 * i1 - tr_b2);
    IsotropicTangent simple;
    simple.tau = kirchhoff_stress(H, log_j, volume);
    simple.s = tensor::deviator(simple.tau);
    simple.volumetric = volume.modulus - 2.0 / 9.0 * traces;
    simple.symmetric = traces / 3.0 - volume.pressure;
    FullTangent result(simple);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l) {
            const double ij = i == j, kl = k == l;
            const double projected = 0.5 * (b(i, k) * b(j, l) + b(i, l) * b(j, k)) -
                                     (b2(i, j) * kl + ij * b2(k, l)) / 3.0 + tr_b2 / 9.0 * ij * kl;
            result.a(i, j, k, l) += 4.0 * c2 * (dev_b(i, j) * dev_b(k, l) - projected);
          }
    return result;
  }
};

}  // namespace stroma::material
