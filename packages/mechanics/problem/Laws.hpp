// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The materials' laws, as the balance of momentum asks for them.

#include <functional>
#include <initializer_list>
#include <memory>
#include <vector>

#include "stroma/mechanics/kernels/StressKernels.hpp"

namespace stroma::mechanics {

/// Of each material its moduli; of all together the kernels that know their stress. The laws that a
/// deck may name convert to this; an application with a law of its own gives the first two members
/// (docs/extending.md).
struct Laws {
  std::vector<material::SmallStrainModuli> moduli;  ///< (material)
  std::function<std::shared_ptr<const StressKernels>(shape::ShapeFunctions, bool flat)> kernels;
  /// The softest and stiffest that particles have, where those of a material differ; else empty.
  std::vector<material::SmallStrainModuli> extremes;

  Laws() = default;
  Laws(const LawList& laws);
  /// \tparam Law  one of those that AnyLaw may be
  template <class Law>
  Laws(const std::vector<Law>& laws) : Laws(LawList{{laws.begin(), laws.end()}}) {}
  /// Neo-Hookean ones, by their moduli.
  Laws(std::initializer_list<material::NeoHookean> laws)
      : Laws(LawList{{laws.begin(), laws.end()}}) {}

  /// The largest modulus of a confined stretch, K + 4/3 mu, of the particles [Pa].
  double stiffest_modulus() const;
  std::size_t size() const { return moduli.size(); }
  /// Moduli between which those of all particles lie: where scales are asked for.
  const std::vector<material::SmallStrainModuli>& range() const {
    return extremes.empty() ? moduli : extremes;
  }
};

}  // namespace stroma::mechanics
