// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The solid of Arruda and Boyce.

#include "stroma/material/OfInvariants.hpp"

namespace stroma::material {

/// Isotropic hyperelastic solid, a network of eight chains in a cube,
///
///     W = mu sum_i c_i/N^(i-1) (Ibar1^i - 3^i) + U(J),   c = 1/2, 1/20, 11/1050, 19/7000, 519/673750,
///
/// the first five terms of the inverse Langevin function. Its shear modulus of small strain is
/// larger than mu: 2 mu sum_i i c_i (3/N)^(i-1).
/// Source: Arruda & Boyce (1993), J Mech Phys Solids 41:389; "Arruda-Boyce" of FEBio.
struct ArrudaBoyce : OfInvariants<ArrudaBoyce> {
  double shear_modulus;  ///< mu [Pa], > 0
  double links;          ///< N [-], of a chain, > 0

  static const char* name() { return "Arruda-Boyce"; }
  static const char* meaning() {
    return "W = mu sum c_i/N^(i-1) (Ibar1^i - 3^i) + U(J), c = 1/2, 1/20, 11/1050, 19/7000, 519/673750";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("Shear Modulus [Pa]", &ArrudaBoyce::shear_modulus, Range::positive(),
                      "Modulus mu; the shear modulus of small strain is mu (1 + 3/(5 N) + ...).");
    parameters.number("N", &ArrudaBoyce::links, Range::positive(),
                      "Links N of a chain; sqrt(N) is the stretch at which chains lock.");
    declare_volume(parameters);
  }

  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const {
    return {2.0 * slope_at(3.0).first, bulk_modulus};
  }
  /// With x = Ibar1 - 3: Ibar1^i - 3^i = x (Ibar1^(i-1) + 3 Ibar1^(i-2) + ... + 3^(i-1)).
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    const double x = isochoric_first_invariant_minus_3(H);
    double sum = 0.0, quotient = 1.0, power_of_3 = 1.0, scale = shear_modulus;
    for (int i = 0; i < 5; ++i) {
      sum += coefficient(i) * scale * quotient;
      power_of_3 *= 3.0;
      quotient = quotient * (3.0 + x) + power_of_3;
      scale /= links;
    }
    return sum * x + of_volume;
  }
  KOKKOS_INLINE_FUNCTION InvariantSlopes slopes(double x) const { return slope_at(3.0 + x); }

 private:
  KOKKOS_INLINE_FUNCTION static double coefficient(int i) {
    constexpr double c[5] = {1.0 / 2.0, 1.0 / 20.0, 11.0 / 1050.0, 19.0 / 7000.0, 519.0 / 673750.0};
    return c[i];
  }
  KOKKOS_INLINE_FUNCTION InvariantSlopes slope_at(double i1) const {
    InvariantSlopes slope{};
    for (int i = 5; i >= 1; --i) {
      if (i > 1)
        slope.first_first = slope.first_first * (i1 / links) + i * (i - 1) * coefficient(i - 1);
      slope.first = slope.first * (i1 / links) + i * coefficient(i - 1);
    }
    // c_i i (i-1) i1^(i-2) / N^(i-1): one power of N more than the polynomial in i1 / N has
    slope.first_first *= shear_modulus / links;
    slope.first *= shear_modulus;
    return slope;
  }
};

}  // namespace stroma::material
