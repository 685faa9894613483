// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The forces of unit strains and unit stresses on a body at rest.

#include <optional>

#include "stroma/mechanics/body/Body.hpp"
#include "stroma/mechanics/body/Lattice.hpp"
#include "stroma/mechanics/problem/StiffnessCases.hpp"
#include "stroma/mechanics/terms/Term.hpp"

namespace stroma::mechanics {

/// The fields of unit strains and the forces of unit stresses.
class UnitFields {
 public:
  /// \param body  outlives it. Collective.
  explicit UnitFields(const Body& body);

  /// The field of a unit strain about the middle of the body's box, v = eps (X - middle)  [um].
  grid::Vector displacement(int unit) const;

  /// Forces of the traction sigma n of a unit stress, 1 Pa, on the faces of the body's box,
  /// consistent with hats: sigma n times the integral of N_I over the face [pN]. For any u,
  ///
  ///     sum_I f_I . u_I = V <eps(u)> : sigma,   <eps> the mean strain of the box,
  ///
  /// of wider functions that of the hats with the same values at the nodes of the lattice. Collective.
  grid::Vector traction(int unit) const;

  /// The load of a case [pN]: of a unit stress its traction, of a unit strain -K times its field.
  /// Collective.
  grid::Vector load(UniformBoundary boundary, int unit) const;

 private:
  const Body& body_;
  std::optional<Lattice> lattice_;  ///< under wider functions
};

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
  /// UnitFields::load(). Collective.
  std::vector<grid::RCP<const grid::Vector>> dead_loads() const override;

 private:
  const Body& body_;
  UniformBoundary boundary_;
  std::vector<int> units_;
};

}  // namespace stroma::mechanics
