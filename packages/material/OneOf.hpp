// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A law that is one of several, in bodies whose materials obey different ones.

#include "stroma/material/Law.hpp"
#include "stroma/material/TaggedUnion.hpp"

namespace stroma::material {

/// One of several laws, with the contract of a law itself (Law.hpp) and the full tangent. Its
/// kernels ask each particle for what it has of its own (transfer::law_at).
template <class... Laws>
class OneOf : public TaggedUnion<Laws...> {
 public:
  using Tangent = FullTangent;
  static constexpr int states = std::max({states_of<Laws>...});

  using TaggedUnion<Laws...>::TaggedUnion;
  using TaggedUnion<Laws...>::visit;

  KOKKOS_INLINE_FUNCTION SmallStrainModuli small_strain() const {
    return visit([](const auto& law) { return law.small_strain(); });
  }
  KOKKOS_INLINE_FUNCTION void recall(const double* history, double time_step) {
    this->change([=](auto& law) { material::recall(law, history, time_step); });
  }
  KOKKOS_INLINE_FUNCTION void new_state(const Tensor3& H, double log_j, double log_of_volume,
                                        double* next) const {
    visit([&](const auto& law) {
      if constexpr (states_of < std::decay_t < decltype(law) >>> 0)
        law.new_state(H, log_j, log_of_volume, next);
      return 0;
    });
  }
  /// Of the law that it is.
  bool may_be_averaged() const {
    return visit([](const auto& law) {
      return material::has_energy_of_volume<std::decay_t<decltype(law)>>;
    });
  }
  KOKKOS_INLINE_FUNCTION double energy_of_volume(double log_j) const {
    return visit([=](const auto& law) { return law.energy_of_volume(log_j); });
  }
  KOKKOS_INLINE_FUNCTION VolumetricStress stress_of_volume(double log_j) const {
    return visit([=](const auto& law) { return law.stress_of_volume(log_j); });
  }
  KOKKOS_INLINE_FUNCTION double energy(const Tensor3& H, double of_volume) const {
    return visit([&](const auto& law) { return law.energy(H, of_volume); });
  }
  KOKKOS_INLINE_FUNCTION Tensor3 kirchhoff_stress(const Tensor3& H, double log_j,
                                                  const VolumetricStress& volume) const {
    return visit([&](const auto& law) { return law.kirchhoff_stress(H, log_j, volume); });
  }
  KOKKOS_INLINE_FUNCTION FullTangent tangent(const Tensor3& H, double log_j,
                                             const VolumetricStress& volume) const {
    return visit([&](const auto& law) { return FullTangent(law.tangent(H, log_j, volume)); });
  }
};

/// Whether mean dilatation may average a law's energy of volume.
template <class Law>
bool may_be_averaged(const Law&) {
  return has_energy_of_volume<Law>;
}
template <class... Laws>
bool may_be_averaged(const OneOf<Laws...>& law) {
  return law.may_be_averaged();
}

template <class... Laws>
KOKKOS_INLINE_FUNCTION void recall(OneOf<Laws...>& law, const double* history, double time_step) {
  law.recall(history, time_step);
}

/// Whether kernels ask for a law particle by particle: for one that remembers or takes numbers of
/// theirs, and for OneOf. Another, such as NeoHookean, is that of the material alone.
template <class Law>
constexpr bool is_asked_by_particle = states_of<Law> > 0 || takes_numbers<Law>;
template <class... Laws>
constexpr bool is_asked_by_particle<OneOf<Laws...>> = true;

}  // namespace stroma::material
