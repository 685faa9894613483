// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The forces of unit strains and unit stresses on a body at rest.

#include "stroma/mechanics/body/Body.hpp"
#include "stroma/mechanics/problem/StiffnessCases.hpp"
#include "stroma/mechanics/terms/Term.hpp"

namespace stroma::mechanics {

/// The field of a unit strain about the middle of the body's box, v = eps (X - middle)  [um].
grid::Vector unit_displacement(const Body& body, int unit);

/// Forces of the traction sigma n of a unit stress, 1 Pa, on the faces of the body's box, consistent
/// with hats: sigma n times the integral of N_I over the face [pN]. For any u,
///
///     sum_I f_I . u_I = V <eps(u)> : sigma,   <eps> the mean strain of the box.
grid::Vector unit_traction(const Body& body, int unit);

/// K v, K the tangent of the stress of a body at rest, without regard to what is prescribed [pN].
/// Collective.
void elastic_force(const Body& body, const grid::Vector& v, grid::Vector& force);

/// A load for the right-hand sides of linear problems, not for the balance, to which it adds no
/// force: it lets supports know what they have to bear.
class UnitLoads : public Term {
 public:
  /// \param body      outlives the term
  /// \param boundary  whether the loads are those of stresses or, else, of strains
  /// \param units     which of them
  UnitLoads(const Body& body, UniformBoundary boundary, std::vector<int> units)
      : body_(body), boundary_(boundary), units_(std::move(units)) {}

  bool changes_with_load() const override { return false; }
  TermForce force(const TrialState& state, grid::Vector& force) const override;
  /// Of a unit stress unit_traction(), of a unit strain -K unit_displacement(). Collective.
  std::vector<grid::RCP<const grid::Vector>> dead_loads() const override;

 private:
  const Body& body_;
  UniformBoundary boundary_;
  std::vector<int> units_;
};

/// The load of one unit [pN], as above. Collective.
grid::Vector unit_load(const Body& body, UniformBoundary boundary, int unit);

}  // namespace stroma::mechanics
