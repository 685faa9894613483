// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A law whose stress relaxes.

#include "stroma/material/Reinforced.hpp"
#include "stroma/material/Viscosity.hpp"

namespace stroma::material {

/// A matrix with its fibres and a viscosity over both. Its energy is that of the law without. It
/// has the contract of a law (Law.hpp).
class Relaxing {
 public:
  static constexpr int states = Viscosity::most_states;  ///< at most
  static_assert(AnyMatrix::states == 0, "the history is the viscosity's");
  using Tangent = FullTangent;

  Relaxing() = default;
  template <class Law, class = std::enable_if_t<std::is_constructible_v<AnyMatrix, const Law&>>>
  Relaxing(const Law& matrix) : law_(matrix) {}
  void add(const FiberFamily& family) { law_.add(family); }
  void set_viscosity(const Viscosity& viscosity) { viscosity_ = viscosity; }

  KOKKOS_INLINE_FUNCTION const AnyMatrix& matrix() const { return law_.matrix(); }
  bool is_matrix_alone() const { return !law_.has_fibers() && viscosity_.terms == 0; }
  /// Numbers of history that it needs.
  int states_used() const { return viscosity_.states(); }

  SmallStrainModuli small_strain() const { return law_.small_strain(); }
  /// visit(NumberName, double&) for each number.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    law_.for_each_number(visit);
    if (viscosity_.terms > 0) visit(NumberName{"Viscosity G0"}, viscosity_.long_term);
    for (int i = 0; i < viscosity_.terms; ++i) {
      visit(NumberName{"Viscosity Modulus", NumberName::none, i}, viscosity_.modulus[i]);
      visit(NumberName{"Relaxation Time [s]", NumberName::none, i}, viscosity_.time[i]);
    }
  }
  /// Not where the stress of volume relaxes, too.
  bool may_be_averaged() const {
    return law_.may_be_averaged() && (viscosity_.terms == 0 || viscosity_.is_deviatoric);
  }
  /// \param history    of the particle, states_used() numbers; it must stay where it is
  /// \param time_step  length of the step [s]
  KOKKOS_INLINE_FUNCTION void recall(const double* history, double time_step) {
    history_ = history;
    if (viscosity_.prepared_for != time_step) viscosity_.prepare(time_step);
  }
  /// To be called where numbers have been changed.
  KOKKOS_INLINE_FUNCTION void forget_step() { viscosity_.prepared_for = -1.0; }
  KOKKOS_INLINE_FUNCTION void new_state(const Tensor3& H, double log_j, double log_of_volume,
                                        double* next) const {
    if (!relaxes()) return;
    const Tensor3 tau = law_.kirchhoff_stress(H, log_j, law_.stress_of_volume(log_of_volume));
    viscosity_.advance(history_, pulled_back(tau, H, log_j), next);
  }
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    return law_.energy_of_volume(log_j);
  }
  KOKKOS_INLINE_FUNCTION VolumetricStress stress_of_volume(double log_j) const {
    return law_.stress_of_volume(log_j);
  }
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return law_.energy(H, of_volume);
  }

  /// tau_e without viscosity. With it k tau_e + F Q F^T; or, of the deviatoric part alone,
  ///
  ///     tau_e + (k - 1) dev tau_e + dev(Fbar Q Fbar^T),   Fbar = J^(-1/3) F.
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    const Tensor3 tau = law_.kirchhoff_stress(H, log_j, volume);
    return relaxes() ? relaxed(tau, viscosity_.factor, memory(H, log_j)) : tau;
  }

  /// With viscosity c = k c_e; or, of the deviatoric part alone of a law whose W1 is isochoric, with
  /// q = Fbar Q Fbar^T, s = dev q and P = I4 - 1/3 I x I,
  ///
  ///     c = c_e + (k - 1) (c_e - c_volume) - 2/3 (s x I + I x s) + 2/3 tr q P,
  ///     c_volume = M I x I - 2 p I4.
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    FullTangent result = law_.tangent(H, log_j, volume);
    if (!relaxes()) return result;
    const double k = viscosity_.factor;
    const Tensor3 q = memory(H, log_j);
    result.tau = relaxed(result.tau, k, q);
    result.c.scale(k);
    if (viscosity_.is_deviatoric)
      result.c.add_isotropic(-2.0 / 9.0 * tensor::trace(q) - (k - 1.0) * volume.modulus,
                             tensor::trace(q) / 3.0 + (k - 1.0) * volume.pressure,
                             tensor::deviator(q));
    return result;
  }

 private:
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
    return F * viscosity_.memory(history_) * tensor::transpose(F);
  }
  KOKKOS_INLINE_FUNCTION Tensor3 relaxed(const Tensor3& tau, double k, const Tensor3& q) const {
    return viscosity_.is_deviatoric ? tau + (k - 1.0) * tensor::deviator(tau) + tensor::deviator(q)
                                    : k * tau + q;
  }

  Reinforced law_;
  Viscosity viscosity_;
  const double* history_ = nullptr;
};

}  // namespace stroma::material
