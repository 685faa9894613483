// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The solid of Gasser, Holzapfel and Ogden: dispersed fibres in a neo-Hookean matrix.

#include "stroma/material/FiberLaw.hpp"
#include "stroma/material/OfInvariants.hpp"

namespace stroma::material {

/// Hyperelastic solid of artery walls, with families f of fibres of mean direction N_f,
///
///     W = C/2 (Ibar1 - 3) + K1/(2 K2) sum_f (exp(K2 <E_f>^2) - 1) + K/4 (J^2 - 1 - 2 ln J),
///     E_f = Kappa (Ibar1 - 3) + (1 - 3 Kappa) (Ibar4_f - 1),   <x> = max(x, 0),
///
/// Ibar4 = J^(-2/3) N.C.N. Kappa = 0: all fibres along N; 1/3: everywhere alike.
/// Source: Gasser, Ogden, Holzapfel (2006), J R Soc Interface 3:15; "Holzapfel-Gasser-Ogden" of FEBio.
struct HolzapfelGasserOgden : Uncoupled {
  static constexpr int most_families = 4;

  double c;                            ///< C [Pa], > 0
  double k1;                           ///< K1 [Pa], > 0
  double k2;                           ///< K2 [-], > 0
  double kappa;                        ///< Kappa [-], 0 to 1/3
  int families;                        ///< 1 to most_families
  double direction[most_families][3];  ///< N_f, unit vectors

  static const char* name() { return "Holzapfel-Gasser-Ogden"; }
  static const char* meaning() {
    return "W = C/2 (Ibar1 - 3) + K1/(2 K2) sum (exp(K2 <E>^2) - 1) + K/4 (J^2 - 1 - 2 ln J), E = "
           "Kappa (Ibar1 - 3) + (1 - 3 Kappa)(Ibar4 - 1) of each family of Fibers, of which it "
           "takes the Direction alone";
  }
  template <class Parameters>
  static void declare(Parameters& parameters) {
    parameters.number("C [Pa]", &HolzapfelGasserOgden::c, Range::positive(),
                      "Shear modulus C of the matrix.");
    parameters.number("K1 [Pa]", &HolzapfelGasserOgden::k1, Range::positive(),
                      "Modulus K1 of the fibres.");
    parameters.number("K2", &HolzapfelGasserOgden::k2, Range::positive(),
                      "Exponent K2 of the fibres.");
    parameters.number("Kappa", &HolzapfelGasserOgden::kappa, Range::between(0.0, 1.0 / 3.0),
                      "Dispersion of the fibres: 0 none, 1/3 everywhere alike.");
    parameters.directions(&HolzapfelGasserOgden::direction, &HolzapfelGasserOgden::families);
    declare_bulk_modulus(parameters, &HolzapfelGasserOgden::bulk_modulus);
  }

  using Tangent = FullTangent;

  /// Of the matrix: fibres do not resist until they are stretched.
  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const { return {c, bulk_modulus}; }
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    return material::energy_of_volume(VolumetricEnergy::quadratic, bulk_modulus, log_j);
  }
  KOKKOS_INLINE_FUNCTION VolumetricStress stress_of_volume(double log_j) const {
    return material::stress_of_volume(VolumetricEnergy::quadratic, bulk_modulus, log_j);
  }

  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    const double x = isochoric_first_invariant_minus_3(H), log_j = log1p(tensor::det_minus_one(H));
    double sum = 0.5 * c * x;
    for (int f = 0; f < families; ++f) {
      const double e = Family(*this, f, H, log_j, x).e;
      if (e > 0.0) sum += 0.5 * k1 / k2 * expm1(k2 * e * e);
    }
    return sum + of_volume;
  }

  /// tau = dev(C bbar + sum 2 psi' h) + p I, with h = Kappa bbar + (1 - 3 Kappa) m x m, whose trace
  /// is E + 1, m = J^(-1/3) F N, psi' = K1 E exp(K2 E^2), of each family that pulls.
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    const IsochoricLeftCauchyGreen bbar(H, log_j);
    Tensor3 tau = kirchhoff_stress_of_invariants({0.5 * c, 0.0, 0.0}, bbar, volume);
    const Tensor3 dev_b = bbar.deviator();
    const double x = bbar.first_invariant_minus_3(H, log_j);
    for (int f = 0; f < families; ++f) {
      const Family family(*this, f, H, log_j, x);
      if (family.e > 0.0) tau = tau + (2.0 * family.slope) * structure(family, dev_b);
    }
    return tau;
  }

  /// c = that of the matrix + sum (4 psi'' dev h x dev h + 4/3 psi' tr h P
  ///     - 2/3 (s_f x I + I x s_f)),   s_f = 2 psi' dev h,   P = I4 - 1/3 I x I.
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    const IsochoricLeftCauchyGreen bbar(H, log_j);
    FullTangent result = tangent_of_invariants({0.5 * c, 0.0, 0.0}, bbar, volume);
    const Tensor3 dev_b = bbar.deviator();
    const double x = bbar.first_invariant_minus_3(H, log_j);
    for (int f = 0; f < families; ++f) {
      const Family family(*this, f, H, log_j, x);
      if (!(family.e >= 0.0)) continue;  // at rest as in tension, as all fibres have it
      const Tensor3 dev_h = structure(family, dev_b);
      const Tensor3 s = (2.0 * family.slope) * dev_h;
      const double symmetric = 2.0 / 3.0 * family.slope * (1.0 + family.e);
      result.c.add_isotropic(-2.0 / 3.0 * symmetric, symmetric, s);
      result.c.add_dyad(4.0 * family.curvature, dev_h);
      result.tau = result.tau + s;
    }
    return result;
  }

 private:
  /// A family's E, m, and psi' = K1 E exp(K2 E^2), psi'' by E.
  struct Family {
    double m[3], e, slope, curvature;

    KOKKOS_INLINE_FUNCTION Family(const HolzapfelGasserOgden& law, int f, const Tensor3& H,
                                  double log_j, double first_minus_3) {
      const StretchedFiber fiber(H, law.direction[f]);
      const double shrink = exp(-log_j / 3.0), x = fiber.x;
      for (int i = 0; i < 3; ++i) m[i] = shrink * fiber.m[i];
      const double fourth_minus_1 = expm1(-2.0 / 3.0 * log_j) * (1.0 + x) + x;
      e = law.kappa * first_minus_3 + (1.0 - 3.0 * law.kappa) * fourth_minus_1;
      const double growth = law.k1 * exp(law.k2 * e * e);
      slope = growth * e;
      curvature = growth * (1.0 + 2.0 * law.k2 * e * e);
    }
  };

  /// dev h.
  KOKKOS_INLINE_FUNCTION Tensor3 structure(const Family& family, const Tensor3& dev_b) const {
    Tensor3 h;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) h(i, j) = (1.0 - 3.0 * kappa) * family.m[i] * family.m[j];
    return kappa * dev_b + tensor::deviator(h);
  }
};

}  // namespace stroma::material
