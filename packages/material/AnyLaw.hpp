// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a material of the deck is made of: a matrix, with families of fibres or without.

#include "stroma/material/AnyFiberLaw.hpp"
#include "stroma/material/AnyMatrix.hpp"
#include "stroma/material/FiberDirections.hpp"
#include "stroma/material/Viscosity.hpp"

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
/// families it is the matrix. Its stress relaxes, if it has a viscosity; its energy is that of the
/// law without. It has the contract of a law (Law.hpp).
class AnyLaw {
 public:
  static constexpr int most_families = 4;
  static constexpr int states = Viscosity::most_states;  ///< at most
  static_assert(AnyMatrix::states == 0, "the history is the viscosity's");
  using Tangent = FullTangent;

  AnyLaw() = default;
  template <class Law, class = std::enable_if_t<std::is_constructible_v<AnyMatrix, const Law&>>>
  AnyLaw(const Law& matrix) : matrix_(matrix) {}
  /// \pre fewer than most_families so far
  void add(const FiberFamily& family) { family_[families_++] = family; }
  void set_viscosity(const Viscosity& viscosity) { viscosity_ = viscosity; }

  const AnyMatrix& matrix() const { return matrix_; }
  bool is_matrix_alone() const { return families_ == 0 && viscosity_.terms == 0; }
  /// Numbers of history that it needs.
  int states_used() const { return viscosity_.states(); }

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
  KOKKOS_INLINE_FUNCTION AnyLaw with_shear_modulus(double mu) const {
    AnyLaw other = *this;
    other.matrix_ = matrix_.with_shear_modulus(mu);
    return other;
  }
  /// Not where the stress of volume relaxes, too.
  bool may_be_averaged() const {
    return matrix_.may_be_averaged() && (viscosity_.terms == 0 || viscosity_.is_deviatoric);
  }
  /// \param history    of the particle, states_used() numbers; it must stay where it is
  /// \param time_step  length of the step [s]
  KOKKOS_INLINE_FUNCTION void recall(const double* history, double time_step) {
    history_ = history;
    time_step_ = time_step;
  }
  KOKKOS_INLINE_FUNCTION void new_state(const Tensor3& H, double log_j, double log_of_volume,
                                        double* next) const {
    if (!relaxes()) return;
    const Tensor3 tau = elastic_stress(H, log_j, stress_of_volume(log_of_volume));
    viscosity_.advance(history_, time_step_, pulled_back(tau, H, log_j), next);
  }
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

  /// tau_e without viscosity. With it k tau_e + F Q F^T; or, of the deviatoric part alone,
  ///
  ///     tau_e + (k - 1) dev tau_e + dev(Fbar Q Fbar^T),   Fbar = J^(-1/3) F.
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    const Tensor3 tau = elastic_stress(H, log_j, volume);
    return relaxes() ? relaxed(tau, H, log_j) : tau;
  }

  /// With viscosity c = k c_e; or, of the deviatoric part alone of a law whose W1 is isochoric, with
  /// q = Fbar Q Fbar^T, s = dev q and P = I4 - 1/3 I x I,
  ///
  ///     c = c_e + (k - 1) (c_e - c_volume) - 2/3 (s x I + I x s) + 2/3 tr q P,
  ///     c_volume = M I x I - 2 p I4.
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    FullTangent result = elastic_tangent(H, log_j, volume);
    if (!relaxes()) return result;
    const Tensor3 elastic = result.tau;
    const double k = viscosity_.factor(time_step_);
    result.tau = relaxed(elastic, H, log_j);
    IsotropicTangent added{{}, {}, 0.0, 0.0};
    if (viscosity_.is_deviatoric) {
      const Tensor3 q = memory(H, log_j);
      added.s = tensor::deviator(q);
      added.symmetric = tensor::trace(q) / 3.0 + (k - 1.0) * volume.pressure;
      added.volumetric = -2.0 / 9.0 * tensor::trace(q) - (k - 1.0) * volume.modulus;
    }
    const Tensor4 more = added.in_full();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int l = 0; l < 3; ++l)
          for (int m = 0; m < 3; ++m) {
            const double geometric = (i == l) * elastic(j, m);
            result.a(i, j, l, m) = k * (result.a(i, j, l, m) - geometric) + more(i, j, l, m) +
                                   (i == l) * result.tau(j, m);
          }
    return result;
  }

 private:
  /// tau = tau_matrix + sum weight 2 psi' m x m,   m = F N.
  KOKKOS_INLINE_FUNCTION Tensor3 elastic_stress(const Tensor3& H, double log_j,
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
  KOKKOS_INLINE_FUNCTION FullTangent elastic_tangent(const Tensor3& H, double log_j,
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

  KOKKOS_INLINE_FUNCTION bool relaxes() const {
    return viscosity_.terms > 0 && history_ != nullptr;
  }
  /// F scaled as the viscosity's stress wants it.
  KOKKOS_INLINE_FUNCTION Tensor3 carrier(const Tensor3& H, double log_j) const {
    const Tensor3 F = tensor::identity() + H;
    return viscosity_.is_deviatoric ? exp(-log_j / 3.0) * F : F;
  }
  /// S_e of a Kirchhoff stress.
  KOKKOS_INLINE_FUNCTION Tensor3 pulled_back(const Tensor3& tau, const Tensor3& H,
                                             double log_j) const {
    const Tensor3 back = tensor::inverse(carrier(H, log_j));
    return back * (viscosity_.is_deviatoric ? tensor::deviator(tau) : tau) *
           tensor::transpose(back);
  }
  /// F Q F^T.
  KOKKOS_INLINE_FUNCTION Tensor3 memory(const Tensor3& H, double log_j) const {
    const Tensor3 F = carrier(H, log_j);
    return F * viscosity_.memory(history_, time_step_) * tensor::transpose(F);
  }
  KOKKOS_INLINE_FUNCTION Tensor3 relaxed(const Tensor3& tau, const Tensor3& H, double log_j) const {
    const double k = viscosity_.factor(time_step_);
    const Tensor3 q = memory(H, log_j);
    return viscosity_.is_deviatoric ? tau + (k - 1.0) * tensor::deviator(tau) + tensor::deviator(q)
                                    : k * tau + q;
  }

  /// f(m, weight, psi) for each direction of each family, m = F N, psi at x = I - 1 =
  /// 2 N.H.N + |H N|^2.
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_each_fiber(const Tensor3& H, const F& f) const {
    for (int family = 0; family < families_; ++family) {
      const FiberFamily& fibers = family_[family];
      for (int d = 0; d < fibers.count; ++d) {
        const FiberDirection& direction = fibers.directions[d];
        double m[3], x = 0.0;
        for (int i = 0; i < 3; ++i) {
          double change = 0.0;
          for (int j = 0; j < 3; ++j) change += H(i, j) * direction.n[j];
          m[i] = direction.n[i] + change;
          x += change * (2.0 * direction.n[i] + change);
        }
        f(m, direction.weight, fibers.law.visit([=](const auto& law) { return law.at(x); }));
      }
    }
  }

  AnyMatrix matrix_;
  FiberFamily family_[most_families];
  int families_ = 0;
  Viscosity viscosity_;
  const double* history_ = nullptr;
  double time_step_ = 0.0;
};

/// Its kernels ask each particle for what it has of its own.
template <>
inline constexpr bool is_asked_by_particle<AnyLaw> = true;
inline bool may_be_averaged(const AnyLaw& law) { return law.may_be_averaged(); }
inline int states_used(const AnyLaw& law) { return law.states_used(); }
KOKKOS_INLINE_FUNCTION void recall(AnyLaw& law, const double* history, double time_step) {
  law.recall(history, time_step);
}

}  // namespace stroma::material
