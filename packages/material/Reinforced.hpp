// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A matrix with families of fibres.

#include "stroma/material/AnyFiberLaw.hpp"
#include "stroma/material/AnyMatrix.hpp"
#include "stroma/material/EachNumber.hpp"
#include "stroma/material/FiberDirections.hpp"

namespace stroma::material {

/// Fibres of one law, in one direction or several.
struct FiberFamily {
  AnyFiberLaw law;
  const FiberDirection* directions = nullptr;  ///< `count` of them; whoever made it keeps them
  int count = 0;
  bool are_turned = false;  ///< their z axis onto the direction `own`
  /// The only direction, where there are no others, and a factor of all weights.
  FiberDirection own{{0.0, 0.0, 1.0}, 1.0};

  /// f(direction) for each of them. The turn is a reflection, which fibres do not tell from one:
  /// n - 2 v (v.n) / v.v, v = e_z - N.
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_direction(const F& f) const {
    const FiberDirection* list = directions == nullptr ? &own : directions;
    const double v[3] = {-own.n[0], -own.n[1], 1.0 - own.n[2]};
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    const double factor = are_turned && square > 0.0 ? 2.0 / square : 0.0;
    const double share = directions == nullptr ? 1.0 : own.weight;
    for (int d = 0; d < (directions == nullptr ? 1 : count); ++d) {
      FiberDirection direction = list[d];
      const double along =
          factor * (v[0] * direction.n[0] + v[1] * direction.n[1] + v[2] * direction.n[2]);
      for (int c = 0; c < 3; ++c) direction.n[c] -= along * v[c];
      direction.weight *= share;
      f(direction);
    }
  }
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
      const double modulus = family_[f].own.weight * family_[f].law.visit([](const auto& law) {
        return law.small_strain_modulus();
      });
      moduli.shear += modulus / 15.0;
      moduli.bulk += modulus / 9.0;
    }
    return moduli;
  }
  /// visit(NumberName, double&) for each number.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    matrix_.change([&](auto& law) { material::for_each_number(law, visit); });
    for (int f = 0; f < families_; ++f) {
      family_[f].law.change([&](auto& law) {
        material::for_each_number(law, [&](NumberName name, double& number) {
          name.family = f;
          visit(name, number);
        });
      });
      for (int d = 0; d < 3; ++d) visit(NumberName{"Direction", f, d}, family_[f].own.n[d]);
      visit(NumberName{"Share", f}, family_[f].own.weight);
    }
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
      tau = tau + (2.0 * weight * psi.slope) * tensor::square_of(m);
    });
    return tau;
  }

  /// c = c_matrix + sum weight 4 psi'' m x m x m x m.
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    FullTangent result = matrix_.tangent(H, log_j, volume);
    for_each_fiber(H, [&](const double m[3], double weight, const FiberResponse& psi) {
      const Tensor3 mm = tensor::square_of(m);
      result.tau = result.tau + (2.0 * weight * psi.slope) * mm;
      result.c.add_dyad(4.0 * weight * psi.curvature, mm);
    });
    return result;
  }

 private:
  /// f(m, weight, psi) for each direction of each family, m = F N.
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_fiber(const Tensor3& H, const F& f) const {
    for (int family = 0; family < families_; ++family) {
      const FiberFamily& fibers = family_[family];
      fibers.law.visit([&](const auto& law) {
        fibers.for_each_direction([&](const FiberDirection& direction) {
          const StretchedFiber fiber(H, direction.n);
          f(fiber.m, direction.weight, law.at(fiber.x));
        });
        return 0;
      });
    }
  }

  AnyMatrix matrix_;
  FiberFamily family_[most_families];
  int families_ = 0;
};

}  // namespace stroma::material
