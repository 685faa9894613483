// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The solid of Veronda and Westmann.

#include "stroma/material/OfInvariants.hpp"

namespace stroma::material {

/// Isotropic hyperelastic solid that stiffens exponentially, first of skin,
///
///     W = C1 (exp(C2 (Ibar1 - 3)) - 1) - C1 C2/2 (Ibar2 - 3) + U(J).
///
/// Source: Veronda & Westmann (1970), J Biomech 3:111; "Veronda-Westmann" of FEBio.
struct VerondaWestmann : OfInvariants<VerondaWestmann> {
  double c1;  ///< C1 [Pa], > 0
  double c2;  ///< C2 [-], > 0

  static const char* name() { return "Veronda-Westmann"; }
  static const char* meaning() {
    return "W = C1 (exp(C2 (Ibar1 - 3)) - 1) - C1 C2/2 (Ibar2 - 3) + U(J), mu = C1 C2";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("C1 [Pa]", &VerondaWestmann::c1, Range::positive(), "Modulus C1.");
    parameters.number("C2", &VerondaWestmann::c2, Range::positive(), "Exponent C2 of Ibar1 - 3.");
    declare_volume(parameters);
  }

  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const { return {c1 * c2, bulk_modulus}; }
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return c1 * expm1(c2 * isochoric_first_invariant_minus_3(H)) -
           0.5 * c1 * c2 * isochoric_second_invariant_minus_3(H) + of_volume;
  }
  KOKKOS_INLINE_FUNCTION InvariantSlopes slopes(double x) const {
    const double slope = c1 * c2 * exp(c2 * x);
    return {slope, c2 * slope, -0.5 * c1 * c2};
  }
};

}  // namespace stroma::material
