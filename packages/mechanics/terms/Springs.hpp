// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The springs of conditions that are imposed by penalty.

#include "stroma/mechanics/body/Body.hpp"
#include "stroma/mechanics/terms/Term.hpp"

namespace stroma::mechanics {

/// The force of the springs that hold points of the body's faces where conditions want them
/// (boundary_points(), transfer::SpringForce).
class Springs : public Term {
 public:
  /// Collective.
  /// \throws base::InputError  see boundary_points()
  explicit Springs(const Body& body);

  void set_load(double load) override;
  TermForce force(const TrialState& state, grid::Vector& force) const override;
  std::int64_t add_tangent(const TrialState& state,
                           const transfer::BlockRows<Device>& rows) const override;
  std::int64_t add_tangent(const TrialState& state,
                           const transfer::StencilRows<Device>& rows) const override;
  void add_tangent_times(const TrialState& state, const ConstNodeView& direction,
                         const NodeView& product) const override;
  double stiffest_diagonal() const override;
  void lump() override { springs_.points.lumped = true; }
  void visit_held(const Pieces& pieces, const HeldVisitor& visit) const override;
  void add_reactions(const TrialState& state, PerCondition& of_conditions) const override;
  void add_torques(const TrialState& state, std::vector<double>& of_conditions) const override;
  /// sum R^2 / (2 sum k) over conditions and components. Its share of all energy is what the
  /// springs take off the stiffness of the body between its supports.
  double support_energy(const TrialState& state) const override;

 private:
  /// Calls use(number, boundary point, its gap [um]) for each of this rank's, on the host.
  template <class Use>
  void for_each_gap(const TrialState& state, const Use& use) const;

  const Body& body_;
  BoundaryPoints springs_;
};

/// Whether a problem has conditions imposed by penalty.
bool has_springs(const Problem& problem);

}  // namespace stroma::mechanics
