// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// From a body and its conditions to its supports.

#include <memory>

#include "stroma/mechanics/body/Body.hpp"
#include "stroma/mechanics/conditions/Supports.hpp"

namespace stroma::mechanics {

/// What else than nodes acts on a body.
struct OtherActions {
  /// Visits the components of pieces that are held otherwise.
  std::function<void(const Pieces& pieces, const HeldVisitor& visit)> visit_held;
  /// Forces whose sum supports must balance [pN], at owned unknowns: one at full load, or several,
  /// which stand for all that they add up to in the run.
  std::vector<grid::RCP<const grid::Vector>> loads;
  /// Force of the stress at the base configuration [pN]; null: none.
  grid::RCP<const grid::Vector> stress;
};

/// The supports of a body: grips and pieces are found, and the statics of these. Collective.
///
/// \param body                 outlives the supports
/// \param others               what else acts
/// \param base_load            load factor at the base configuration
/// \param is_refused_if_loose  whether the loads must be held (SupportedBody)
/// \throws base::InputError  see Supports
std::unique_ptr<Supports> find_supports(const Body& body, const OtherActions& others,
                                        double base_load, bool is_refused_if_loose);

}  // namespace stroma::mechanics
