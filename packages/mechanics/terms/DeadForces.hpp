// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Forces that do not depend on the deformation.

#include "stroma/mechanics/body/Body.hpp"
#include "stroma/mechanics/terms/Term.hpp"

namespace stroma::mechanics {

/// f = -load f_full, with f_full the nodal force at full load of what acts per volume, per mass and
/// per area of the undeformed body (transfer::ExternalForce).
class DeadForces : public Term {
 public:
  /// Collective.
  explicit DeadForces(const Body& body);

  void set_load(double load) override { load_ = load; }
  TermForce force(const TrialState& state, grid::Vector& force) const override;
  grid::RCP<const grid::Vector> dead_load() const override { return at_full_load_; }

 private:
  grid::RCP<grid::Vector> at_full_load_;
  double size_at_full_load_;  // [pN]
  double load_ = 0.0;
};

/// Whether a problem has such forces.
bool has_dead_forces(const Problem& problem);

}  // namespace stroma::mechanics
