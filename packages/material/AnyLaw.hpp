// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a material of the deck is made of.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "stroma/material/Drives.hpp"
#include "stroma/material/Relaxing.hpp"

namespace stroma::material {

/// A matrix with its fibres and viscosity, which grows, and which contracts by itself:
///
///     tau = g tau_e(F F_g^-1) + F S_active F^T,   W = g W_e(F F_g^-1),   g = det F_g;
///
/// each of these if wanted. Or a pressure, whose factor is that of the active stress. It has the contract of a law (Law.hpp).
class AnyLaw {
 public:
  static constexpr int most_families = Reinforced::most_families;
  static constexpr int states = Relaxing::states;  ///< at most
  static constexpr int most_own = 32;              ///< numbers that particles may give
  using Tangent = FullTangent;

  AnyLaw() = default;
  template <class Law, class = std::enable_if_t<std::is_constructible_v<AnyMatrix, const Law&>>>
  AnyLaw(const Law& matrix) : law_(matrix), is_pressure_(law_.matrix().is<Pressure>()) {}
  /// \pre fewer than most_families so far
  void add(const FiberFamily& family) { law_.add(family); }
  void set_viscosity(const Viscosity& viscosity) { law_.set_viscosity(viscosity); }
  void set_active_stress(const ActiveStress& active) { active_ = active; }
  void set_growth(const Growth& growth) { growth_ = growth; }

  KOKKOS_INLINE_FUNCTION const AnyMatrix& matrix() const { return law_.matrix(); }
  bool is_matrix_alone() const {
    return law_.is_matrix_alone() && active_.t0 == 0.0 && growth_.ratio == 1.0;
  }
  /// Numbers of history that it needs.
  int states_used() const { return law_.states_used(); }

  /// Before it has grown, and without active stress.
  SmallStrainModuli small_strain() const { return law_.small_strain(); }
  /// visit(NumberName, double&) for each of its numbers, in an order that depends on what it is made
  /// of alone.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    law_.for_each_number(visit);
    visit(NumberName{"Active Stress T0 [Pa]"}, active_.t0);
    for (int d = 0; d < 3; ++d)
      visit(NumberName{"Active Direction", NumberName::none, d}, active_.direction[d]);
    visit(NumberName{"Growth Ratio"}, growth_.ratio);
    for (int d = 0; d < 3; ++d)
      visit(NumberName{"Growth Direction", NumberName::none, d}, growth_.direction[d]);
  }
  /// From now on particles give these of its numbers (take()).
  /// \param which  places in the order of for_each_number(), ascending
  /// \pre no more than most_own
  void let_vary(const std::vector<int>& which) {
    own_numbers_ = 0;
    int place = 0;
    for_each_number([&](const NumberName&, double& number) {
      if (std::binary_search(which.begin(), which.end(), place++))
        own_[own_numbers_++] = static_cast<std::uint16_t>(reinterpret_cast<const char*>(&number) -
                                                          reinterpret_cast<const char*>(this));
    });
  }
  int own_numbers() const { return own_numbers_; }
  /// \param own  the numbers of a particle, in the order of let_vary(); own_numbers() are read
  KOKKOS_INLINE_FUNCTION void take(const double* own) {
    for (int n = 0; n < own_numbers_; ++n)
      *reinterpret_cast<double*>(reinterpret_cast<char*>(this) + own_[n]) = own[n];
    law_.forget_step();
  }
  bool may_be_averaged() const { return law_.may_be_averaged(); }
  KOKKOS_INLINE_FUNCTION void recall(const double* history, double time_step) {
    law_.recall(history, time_step);
  }
  /// From now on at these factors; at first nothing has grown and nothing contracts.
  KOKKOS_INLINE_FUNCTION void drive(const MaterialFactors& factors) {
    active_factor_ = factors.active;
    ratio_ = growth_.ratio_at(factors.growth);
  }
  KOKKOS_INLINE_FUNCTION void new_state(const Tensor3& H, double log_j, double log_of_volume,
                                        double* next) const {
    law_.new_state(elastic(H), elastic(log_j), elastic(log_of_volume), next);
  }

  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    const double energy = ratio_ * law_.energy_of_volume(elastic(log_j));
    return is_pressure_ ? energy - pressure() * expm1(log_j) : energy;
  }
  KOKKOS_INLINE_FUNCTION VolumetricStress stress_of_volume(double log_j) const {
    const VolumetricStress volume = law_.stress_of_volume(elastic(log_j));
    const double pressure_and_modulus = is_pressure_ ? -pressure() * exp(log_j) : 0.0;
    return {ratio_ * volume.pressure + pressure_and_modulus,
            ratio_ * volume.modulus + pressure_and_modulus};
  }
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return ratio_ * law_.energy(elastic(H), of_volume / ratio_);
  }
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    const Tensor3 tau =
        ratio_ * law_.kirchhoff_stress(elastic(H), elastic(log_j), before_growth(volume));
    return active_factor_ == 0.0 ? tau : tau + active_stress(H);
  }
  /// The active stress adds nothing to c: its second Piola-Kirchhoff stress is constant.
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    FullTangent result = law_.tangent(elastic(H), elastic(log_j), before_growth(volume));
    if (ratio_ == 1.0 && active_factor_ == 0.0) return result;
    result.tau = ratio_ * result.tau + active_stress(H);
    result.c.scale(ratio_);
    return result;
  }

 private:
  /// Of a Pressure, now [Pa].
  KOKKOS_INLINE_FUNCTION double pressure() const {
    return active_factor_ * law_.matrix().as<Pressure>().pressure;
  }
  KOKKOS_INLINE_FUNCTION Tensor3 elastic(const Tensor3& H) const {
    return ratio_ == 1.0 ? H : growth_.elastic_part(H, ratio_);
  }
  KOKKOS_INLINE_FUNCTION double elastic(double log_j) const {
    return ratio_ == 1.0 ? log_j : log_j - log(ratio_);
  }
  KOKKOS_INLINE_FUNCTION VolumetricStress before_growth(const VolumetricStress& volume) const {
    return {volume.pressure / ratio_, volume.modulus / ratio_};
  }
  KOKKOS_INLINE_FUNCTION Tensor3 active_stress(const Tensor3& H) const {
    const Tensor3 F = tensor::identity() + H;
    return active_factor_ * (F * active_.second_piola() * tensor::transpose(F));
  }

  Relaxing law_;
  ActiveStress active_;
  Growth growth_;
  double active_factor_ = 0.0, ratio_ = 1.0;
  bool is_pressure_ = false;
  std::uint16_t own_[most_own] = {};  // where the numbers lie that particles give [bytes]
  int own_numbers_ = 0;
};

static_assert(std::is_trivially_copyable_v<AnyLaw>, "views of laws are copied as bytes");

/// Its kernels ask each particle for what it has of its own.
template <>
inline constexpr bool is_asked_by_particle<AnyLaw> = true;
inline bool may_be_averaged(const AnyLaw& law) { return law.may_be_averaged(); }
inline int states_used(const AnyLaw& law) { return law.states_used(); }
inline int numbers_taken(const AnyLaw& law) { return law.own_numbers(); }
KOKKOS_INLINE_FUNCTION void recall(AnyLaw& law, const double* history, double time_step) {
  law.recall(history, time_step);
}

KOKKOS_INLINE_FUNCTION void drive(AnyLaw& law, const MaterialFactors& factors) {
  law.drive(factors);
}

}  // namespace stroma::material
