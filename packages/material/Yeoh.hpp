// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The solid of Yeoh.

#include "stroma/material/OfInvariants.hpp"

namespace stroma::material {

/// Isotropic hyperelastic solid, a polynomial of the first invariant,
///
///     W = sum_i C_i (Ibar1 - 3)^i + U(J),   i = 1 to n.
///
/// Source: Yeoh (1993), Rubber Chem Technol 66:754; uncoupled "Yeoh" of FEBio.
struct Yeoh : OfInvariants<Yeoh> {
  int terms;    ///< n, 1 to 6
  double c[6];  ///< C_i [Pa], C_1 > 0

  static const char* name() { return "Yeoh"; }
  static const char* meaning() { return "W = sum C_i (Ibar1 - 3)^i + U(J), mu = 2 C_1"; }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.numbers("C [Pa]", &Yeoh::c, &Yeoh::terms, Range::any(),
                       "Moduli C_1 to C_n of the powers of Ibar1 - 3.");
    declare_volume(parameters);
  }

  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const {
    return {2.0 * c[0], bulk_modulus};
  }
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    const double x = isochoric_first_invariant_minus_3(H);
    double sum = 0.0;
    for (int i = terms - 1; i >= 0; --i) sum = (sum + c[i]) * x;
    return sum + of_volume;
  }
  KOKKOS_INLINE_FUNCTION InvariantSlopes slopes(double x) const {
    InvariantSlopes slope{};
    for (int i = terms; i >= 1; --i) {
      if (i > 1) slope.first_first = slope.first_first * x + i * (i - 1) * c[i - 1];
      slope.first = slope.first * x + i * c[i - 1];
    }
    return slope;
  }
};

}  // namespace stroma::material
