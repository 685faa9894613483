// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Forces that do not depend on the deformation.

#include "stroma/mechanics/body/Body.hpp"
#include "stroma/mechanics/terms/Term.hpp"

namespace stroma::mechanics {

/// f = -sum_k s_k(load) f_k, with f_k the nodal force, at a factor of 1, of all that acts per
/// volume, per mass and per area of the undeformed body (transfer::ExternalForce) and follows the
/// load curve s_k.
class DeadForces : public Term {
 public:
  /// Collective.
  explicit DeadForces(const Body& body);

  void set_load(double load) override { load_ = load; }
  TermForce force(const TrialState& state, grid::Vector& force) const override;
  std::vector<grid::RCP<const grid::Vector>> dead_loads() const override;

 private:
  struct Group {
    LoadCurve curve;
    grid::RCP<grid::Vector> full;
    double size;  ///< of full [pN]
  };

  std::vector<Group> groups_;
  double load_ = 0.0;
};

/// Whether a problem has such forces.
bool has_dead_forces(const Problem& problem);

}  // namespace stroma::mechanics
