// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The springs of conditions that are imposed by penalty.

#include "stroma/mechanics/body/Body.hpp"
#include "stroma/mechanics/terms/Term.hpp"

namespace stroma::mechanics {

/// The force of the springs that hold points of the body's faces where conditions want them
/// (boundary_points(), transfer::SpringForce).
///
/// Springs that pull on (Problem::pulls_on) are soft, and aim beyond the place u* that a condition
/// wants, by s: their force is k (u_b - u* - s), and -k s in the end, when u_b = u*. That is the
/// method of multipliers. A step begins with the s that the stress of the particles calls for,
///
///     s = P N / epsilon,
///
/// P the first Piola-Kirchhoff stress, N the face's normal; after each solution pull_on() sets
/// s <- s - (u_b - u*), until slack() is small. Source: Hestenes, J Optim Theory Appl 4:303, 1969;
/// docs/theory.md, section 8.
class Springs : public Term {
 public:
  /// Collective.
  /// \throws base::InputError  see boundary_points()
  explicit Springs(const Body& body);

  void set_load(double load) override;
  void go_straight(const StraightStep& step) { step_ = step; }
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

  bool some_pull_on() const { return some_pull_on_; }
  /// Lets springs that pull on begin with the stress at a displacement. Collective, as the next.
  void begin_pulling(const TrialState& state);
  /// The force at the nodes that springs miss that pull on [pN], the norm of that of k (u_b - u*); 0
  /// without any.
  double slack(const TrialState& state) const;
  /// How far faces are from where such springs want them [um], root mean square over all points and
  /// components; 0 without any.
  double distance(const TrialState& state) const;
  /// Lets them aim further, for the solution at the present load.
  void pull_on(const TrialState& state);

 private:
  /// Calls use(number, boundary point, its gap [um]) for each of this rank's, on the host.
  template <class Use>
  void for_each_gap(const TrialState& state, const Use& use) const;

  bool pulls_on(const transfer::BoundaryPoint& point) const;
  void aim();

  const Body& body_;
  BoundaryPoints springs_;
  double load_ = 0.0;
  StraightStep step_;
  bool some_pull_on_;
  std::vector<std::array<double, 3>> beyond_;  // (point) s [um]; empty: none pulls on yet
};

/// Whether a problem has conditions imposed by penalty.
bool has_springs(const Problem& problem);

}  // namespace stroma::mechanics
