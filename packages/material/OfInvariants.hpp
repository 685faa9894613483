// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What uncoupled laws share: the energy of volume, and stress and tangent of an energy of the
/// isochoric invariants.

#include "stroma/material/LawParameters.hpp"

namespace stroma::material {

/// The energy of volume of an uncoupled law.
struct Uncoupled {
  double bulk_modulus;  ///< K [Pa], > 0
  VolumetricEnergy volumetric_energy = VolumetricEnergy::logarithmic;

  KOKKOS_FORCEINLINE_FUNCTION double energy_of_volume(double log_j) const {
    return material::energy_of_volume(volumetric_energy, bulk_modulus, log_j);
  }
  KOKKOS_FORCEINLINE_FUNCTION VolumetricStress stress_of_volume(double log_j) const {
    return material::stress_of_volume(volumetric_energy, bulk_modulus, log_j);
  }
  template <class Parameters>
  static void declare_volume(Parameters& parameters) {
    declare_bulk_modulus(parameters, &Uncoupled::bulk_modulus);
    parameters.volumetric_energy(&Uncoupled::volumetric_energy);
  }
};

/// Of an energy W1 = f(Ibar1) + c Ibar2, with the invariants of bbar = J^(-2/3) b, b = F F^T [Pa].
struct InvariantSlopes {
  double first;        ///< f'
  double first_first;  ///< f''
  double second;       ///< c
};

/// bbar by e = b - I, which is small where the strain is.
struct IsochoricLeftCauchyGreen {
  double growth;  ///< J^(-2/3) - 1
  Tensor3 e;
  double factor = 1.0 + growth;

  KOKKOS_INLINE_FUNCTION IsochoricLeftCauchyGreen(const Tensor3& H, double log_j)
      : growth(expm1(-2.0 / 3.0 * log_j)), e(tensor::left_cauchy_green_minus_identity(H)) {}
  KOKKOS_INLINE_FUNCTION double first_invariant_minus_3(const Tensor3& H, double log_j) const {
    return isochoric_first_invariant_minus_3(H, e, -2.0 / 3.0 * log_j, growth);
  }
  KOKKOS_FORCEINLINE_FUNCTION Tensor3 value() const { return factor * (tensor::identity() + e); }
  KOKKOS_FORCEINLINE_FUNCTION Tensor3 deviator() const { return factor * tensor::deviator(e); }
};

/// tau = 2 f' dev(bbar) + 2 c dev(Ibar1 bbar - bbar^2) + p I [Pa]; with b = I + e,
/// dev(I1 b - b^2) = dev((1 + tr e) e - e^2).
KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress_of_invariants(const InvariantSlopes& slope,
                                                              const IsochoricLeftCauchyGreen& bbar,
                                                              const VolumetricStress& volume) {
  const Tensor3& e = bbar.e;
  Tensor3 tau = (2.0 * bbar.factor) *
                tensor::deviator(slope.first * e + (slope.second * bbar.factor) *
                                                       ((1.0 + tensor::trace(e)) * e - e * e));
  for (int i = 0; i < 3; ++i) tau(i, i) += volume.pressure;
  return tau;
}

/// With s = dev tau, f_1 = 2 f' Ibar1, f_2 = 4 c Ibar2 the traces of the two parts of tau before the
/// deviator is taken, and P = I4 - 1/3 I x I,
///
///     c = 4 f'' dev bbar x dev bbar + 4 c P : (bbar x bbar - bbar (.) bbar) : P
///         + 2/3 (f_1 + f_2) P - 2/3 (s x I + I x s) + M I x I - 2 p I4,
///
///     (b (.) b)_ijkl = (b_ik b_jl + b_il b_jk) / 2,     P : (b x b) : P = dev b x dev b,
///     P : (b (.) b) : P = b (.) b - 1/3 (b^2 x I + I x b^2) + 1/9 tr(b^2) I x I.
///
/// Source: Holzapfel (2000), section 6.6.
KOKKOS_FORCEINLINE_FUNCTION FullTangent tangent_of_invariants(const InvariantSlopes& slope,
                                                              const IsochoricLeftCauchyGreen& bbar,
                                                              const VolumetricStress& volume) {
  const Tensor3 b = bbar.value();
  const Tensor3 b2 = b * b;
  const double i1 = tensor::trace(b), tr_b2 = tensor::trace(b2);
  const double traces = 2.0 * slope.first * i1 + 2.0 * slope.second * (i1 * i1 - tr_b2);
  FullTangent result;
  result.tau = kirchhoff_stress_of_invariants(slope, bbar, volume);
  // s of the isotropic part, with P : (b (.) b) : P - b (.) b, which is of its form
  const Tensor3 s = tensor::deviator(result.tau) - (2.0 * slope.second) * b2;
  result.c.add_isotropic(volume.modulus - 2.0 / 9.0 * traces - 4.0 / 9.0 * slope.second * tr_b2,
                         traces / 3.0 - volume.pressure, s);
  result.c.add_dyad(4.0 * (slope.first_first + slope.second), tensor::deviator(b));
  if (slope.second != 0.0) result.c.add_square(-4.0 * slope.second, b);
  return result;
}

/// Stress and tangent of a law `Law` with such an energy, which gives energy(), small_strain() and
/// its slopes(x) at x = Ibar1 - 3.
template <class Law>
struct OfInvariants : Uncoupled {  // NOLINT(bugprone-crtp-constructor-accessibility): aggregates
  using Tangent = FullTangent;

  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    const IsochoricLeftCauchyGreen bbar(H, log_j);
    return kirchhoff_stress_of_invariants(slopes_at(H, log_j, bbar), bbar, volume);
  }
  KOKKOS_FORCEINLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    const IsochoricLeftCauchyGreen bbar(H, log_j);
    return tangent_of_invariants(slopes_at(H, log_j, bbar), bbar, volume);
  }

 private:
  KOKKOS_INLINE_FUNCTION InvariantSlopes slopes_at(const Tensor3& H, double log_j,
                                                   const IsochoricLeftCauchyGreen& bbar) const {
    return static_cast<const Law&>(*this).slopes(bbar.first_invariant_minus_3(H, log_j));
  }
};

}  // namespace stroma::material
