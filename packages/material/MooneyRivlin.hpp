// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The solid of Mooney and Rivlin.

#include "stroma/material/OfInvariants.hpp"

namespace stroma::material {

/// Isotropic hyperelastic solid,
///
///     W = C1 (Ibar1 - 3) + C2 (Ibar2 - 3) + U(J).
///
/// With C2 = 0 it is NeoHookean, mu = 2 C1. Source: Holzapfel (2000), section 6.5.
struct MooneyRivlin : OfInvariants<MooneyRivlin> {
  double c1, c2;  ///< [Pa], C1 + C2 > 0

  static const char* name() { return "Mooney-Rivlin"; }
  static const char* meaning() {
    return "W = C1 (Ibar1 - 3) + C2 (Ibar2 - 3) + U(J), mu = 2 (C1 + C2)";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("C1 [Pa]", &MooneyRivlin::c1, Range::any(), "Modulus C1 of Ibar1.");
    parameters.number("C2 [Pa]", &MooneyRivlin::c2, Range::any(), "Modulus C2 of Ibar2.");
    declare_volume(parameters);
  }

  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const {
    return {2.0 * (c1 + c2), bulk_modulus};
  }
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return c1 * isochoric_first_invariant_minus_3(H) + c2 * isochoric_second_invariant_minus_3(H) +
           of_volume;
  }
  KOKKOS_INLINE_FUNCTION InvariantSlopes slopes(double) const { return {c1, 0.0, c2}; }
};

}  // namespace stroma::material
