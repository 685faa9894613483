// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A matrix with families of fibres.

#include "stroma/material/AnyFiberLaw.hpp"
#include "stroma/material/AnyMatrix.hpp"
#include "stroma/material/FiberDirections.hpp"

namespace stroma::material {

/// Fibres of one law, in one direction or several.
struct FiberFamily {
  AnyFiberLaw law;
  const FiberDirection* directions = nullptr;  ///< `count` of them; whoever made it keeps them
  int count = 0;
};

/// A matrix law with the stress of fibres added, which are embedded in it:
///
///     W = W_matrix + sum_families sum_N weight psi(I_N),   I_N = N.C.N.
///
/// Fibres see all of the deformation, change of volume included, whatever the matrix is. Without
/// families it is the matrix. It has the contract of a law (Law.hpp).
class Reinforced {
 public:
  static constexpr int most_families = 4;
  using Tangent = FullTangent;

  Reinforced() = default;
  template <class Law, class = std::enable_if_t<std::is_constructible_v<AnyMatrix, const Law&>>>
  Reinforced(const Law& matrix) : matrix_(matrix) {}
  /// \pre fewer than most_families so far
  void add(const FiberFamily& family) { family_[families_++] = family; }

  const AnyMatrix& matrix() const { return matrix_; }
  bool has_fibers() const { return families_ > 0; }

  /// The matrix's, and of each family a shear modulus of E/15 and a bulk modulus of E/9, with E its
  /// modulus in small stretches: exact if it points everywhere alike and resists compression, too.
  SmallStrainModuli small_strain() const {
    SmallStrainModuli moduli = matrix_.small_strain();
    for (int f = 0; f < families_; ++f) {
      const double modulus =
          family_[f].law.visit([](const auto& law) { return law.small_strain_modulus(); });
      moduli.shear += modulus / 15.0;
      moduli.bulk += modulus / 9.0;
    }
    return moduli;
  }
  /// Of the matrix; fibres stay as they are.
  KOKKOS_INLINE_FUNCTION Reinforced with_shear_modulus(double mu) const {
    Reinforced other = *this;
    other.matrix_ = matrix_.with_shear_modulus(mu);
    return other;
  }
  bool may_be_averaged() const { return matrix_.may_be_averaged(); }
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    return matrix_.energy_of_volume(log_j);
  }
  KOKKOS_INLINE_FUNCTION VolumetricStress stress_of_volume(double log_j) const {
    return matrix_.stress_of_volume(log_j);
  }

  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    double sum = matrix_.energy(H, of_volume);
    for_each_fiber(H, [&](const double[3], double weight, const FiberResponse& psi) {
      sum += weight * psi.energy;
    });
    return sum;
  }

  /// tau = tau_matrix + sum weight 2 psi' m x m,   m = F N.
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    Tensor3 tau = matrix_.kirchhoff_stress(H, log_j, volume);
    for_each_fiber(H, [&](const double m[3], double weight, const FiberResponse& psi) {
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) tau(i, j) += 2.0 * weight * psi.slope * m[i] * m[j];
    });
    return tau;
  }

  /// c = c_matrix + sum weight 4 psi'' m x m x m x m. The sum is symmetric in all subscripts: its
  /// 15 numbers belong to the powers x^a y^b z^c of degree 4.
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    FullTangent result = matrix_.tangent(H, log_j, volume);
    if (families_ == 0) return result;
    Tensor3 tau;
    double of_power[5][5] = {};  // [a][b], c = 4 - a - b
    for_each_fiber(H, [&](const double m[3], double weight, const FiberResponse& psi) {
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) tau(i, j) += 2.0 * weight * psi.slope * m[i] * m[j];
      double power[3][5];
      for (int d = 0; d < 3; ++d) {
        power[d][0] = 1.0;
        for (int n = 1; n <= 4; ++n) power[d][n] = power[d][n - 1] * m[d];
      }
      const double factor = 4.0 * weight * psi.curvature;
      for (int a = 0; a <= 4; ++a)
        for (int b = 0; a + b <= 4; ++b)
          of_power[a][b] += factor * power[0][a] * power[1][b] * power[2][4 - a - b];
    });
    result.tau = result.tau + tau;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            result.a(i, j, k, l) += of_power[(i == 0) + (j == 0) + (k == 0) + (l == 0)]
                                            [(i == 1) + (j == 1) + (k == 1) + (l == 1)] +
                                    (i == k) * tau(j, l);
    return result;
  }

 private:
  /// f(m, weight, psi) for each direction of each family, m = F N.
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_fiber(const Tensor3& H, const F& f) const {
    for (int family = 0; family < families_; ++family) {
      const FiberFamily& fibers = family_[family];
      for (int d = 0; d < fibers.count; ++d) {
        const FiberDirection& direction = fibers.directions[d];
        const StretchedFiber fiber(H, direction.n);
        f(fiber.m, direction.weight,
          fibers.law.visit([&](const auto& law) { return law.at(fiber.x); }));
      }
    }
  }

  AnyMatrix matrix_;
  FiberFamily family_[most_families];
  int families_ = 0;
};

}  // namespace stroma::material
