// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A matrix with families of fibres.

#include <type_traits>

#include "stroma/material/AnyFiberLaw.hpp"
#include "stroma/material/AnyMatrix.hpp"
#include "stroma/material/EachNumber.hpp"
#include "stroma/material/FiberDirections.hpp"

namespace stroma::material {

/// A few directions side by side, for loops that take all at once; those beyond the last have no
/// weight.
template <int few = 8>
struct FewDirections {
  static constexpr int size = few;
  double n[3][few], weight[few];

  /// \param list,count  directions, as many or more
  /// \param share  factor of their weights
  /// \param axis   if not null, their z axis is turned onto it: by a reflection, which fibres do not
  ///              tell from a turn, n - 2 v (v.n) / v.v, v = e_z - N
  KOKKOS_INLINE_FUNCTION FewDirections(const FiberDirection* list, int count, double share,
                                       const double* axis) {
    for (int d = 0; d < few; ++d) {
      const FiberDirection& direction = list[d < count ? d : 0];
      for (int c = 0; c < 3; ++c) n[c][d] = direction.n[c];
      weight[d] = d < count ? share * direction.weight : 0.0;
    }
    if (axis == nullptr || axis[2] == 1.0) return;
    const double v[3] = {-axis[0], -axis[1], 1.0 - axis[2]};
    const double factor = 2.0 / (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int d = 0; d < few; ++d) {
      const double along = factor * (v[0] * n[0][d] + v[1] * n[1][d] + v[2] * n[2][d]);
      for (int c = 0; c < 3; ++c) n[c][d] -= along * v[c];
    }
  }
};

/// Fibres of one law, in one direction or several.
struct FiberFamily {
  AnyFiberLaw law;
  const FiberDirection* directions = nullptr;  ///< `count` of them; whoever made it keeps them
  int count = 0;
  bool are_turned = false;  ///< their z axis onto the direction `own`
  /// The only direction, where there are no others, and a factor of all weights.
  FiberDirection own{{0.0, 0.0, 1.0}, 1.0};
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

  KOKKOS_INLINE_FUNCTION const AnyMatrix& matrix() const { return matrix_; }
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
    for_each_family([&](const auto& law, auto size, const auto& for_each_few) {
      constexpr int few = decltype(size)::value;
      for_each_few([&](const auto& directions) {
        const StretchedFibers<few> fibers(H, directions);
        for (int d = 0; d < few; ++d) sum += fibers.weight[d] * law.energy(fibers.x[d]);
      });
    });
    return sum;
  }

  /// tau = tau_matrix + sum weight 2 psi' m x m,   m = F N.
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    Tensor3 tau = matrix_.kirchhoff_stress(H, log_j, volume);
    for_each_family([&](const auto& law, auto size, const auto& for_each_few) {
      constexpr int few = decltype(size)::value;
      double of_tau[6][few] = {};
      for_each_few([&](const auto& directions) {
        const StretchedFibers<few> fibers(H, directions);
        for (int d = 0; d < few; ++d) {
          const double factor = 2.0 * fibers.weight[d] * law.slopes(fibers.x[d]).first;
          for (int ij = 0; ij < 6; ++ij) of_tau[ij][d] += factor * fibers.square(ij, d);
        }
      });
      add_sums(of_tau, tau);
    });
    return tau;
  }

  /// c = c_matrix + sum weight 4 psi'' m x m x m x m.
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    FullTangent result = matrix_.tangent(H, log_j, volume);
    for_each_family([&](const auto& law, auto size, const auto& for_each_few) {
      constexpr int few = decltype(size)::value;
      double of_tau[6][few] = {}, of_c[6][6][few] = {};
      for_each_few([&](const auto& directions) {
        const StretchedFibers<few> fibers(H, directions);
        double first[few], second[few];
        for (int d = 0; d < few; ++d) {
          const FiberSlopes psi = law.slopes(fibers.x[d]);
          first[d] = 2.0 * fibers.weight[d] * psi.first;
          second[d] = 4.0 * fibers.weight[d] * psi.second;
        }
        for (int ij = 0; ij < 6; ++ij)
          for (int d = 0; d < few; ++d) of_tau[ij][d] += first[d] * fibers.square(ij, d);
        for (int ij = 0; ij < 6; ++ij)
          for (int kl = ij; kl < 6; ++kl)
            for (int d = 0; d < few; ++d)
              of_c[ij][kl][d] += second[d] * fibers.square(ij, d) * fibers.square(kl, d);
      });
      add_sums(of_tau, result.tau);
      for (int ij = 0; ij < 6; ++ij)
        for (int kl = ij; kl < 6; ++kl) {
          const double sum = sum_of(of_c[ij][kl]);
          result.c.value[ij][kl] += sum;
          if (kl != ij) result.c.value[kl][ij] += sum;
        }
    });
    return result;
  }

 private:
  /// A few fibres carried along by F = I + H: m = F N, and x = I_N - 1 (StretchedFiber).
  template <int few>
  struct StretchedFibers {
    double m[3][few], x[few], weight[few];

    KOKKOS_INLINE_FUNCTION StretchedFibers(const Tensor3& H, const FewDirections<few>& directions) {
      for (int d = 0; d < few; ++d) {
        x[d] = 0.0;
        weight[d] = directions.weight[d];
      }
      for (int i = 0; i < 3; ++i)
        for (int d = 0; d < few; ++d) {
          const double change = H(i, 0) * directions.n[0][d] + H(i, 1) * directions.n[1][d] +
                                H(i, 2) * directions.n[2][d];
          m[i][d] = directions.n[i][d] + change;
          x[d] += change * (2.0 * directions.n[i][d] + change);
        }
    }
    /// m x m of one of them.
    KOKKOS_INLINE_FUNCTION double square(int ij, int d) const {
      return m[Elasticity::first(ij)][d] * m[Elasticity::second(ij)][d];
    }
  };

  template <int few>
  KOKKOS_INLINE_FUNCTION static double sum_of(const double (&value)[few]) {
    double sum = 0.0;
    for (int d = 0; d < few; ++d) sum += value[d];
    return sum;
  }
  template <int few>
  KOKKOS_INLINE_FUNCTION static void add_sums(const double (&value)[6][few], Tensor3& tau) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) tau(i, j) += sum_of(value[Elasticity::pair(i, j)]);
  }

  /// f(law, size, for_each_few) for each family, with for_each_few(visit) that calls
  /// visit(FewDirections<size>): one at a time of a single direction, else several.
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_family(const F& f) const {
    for (int n = 0; n < families_; ++n) {
      const FiberFamily& family = family_[n];
      family.law.visit([&](const auto& law) {
        if (family.directions == nullptr)
          f(law, std::integral_constant<int, 1>(),
            [&](const auto& visit) { visit(FewDirections<1>(&family.own, 1, 1.0, nullptr)); });
        else
          f(law, std::integral_constant<int, FewDirections<>::size>(), [&](const auto& visit) {
            for (int first = 0; first < family.count; first += FewDirections<>::size)
              visit(FewDirections<>(family.directions + first, family.count - first,
                                    family.own.weight, family.are_turned ? family.own.n : nullptr));
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
