// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The force of inertia, and of Rayleigh's damping.

#include "stroma/mechanics/body/Body.hpp"
#include "stroma/mechanics/conditions/Supports.hpp"
#include "stroma/mechanics/terms/Term.hpp"

namespace stroma::mechanics {

/// f = M a + alpha_R M v + beta_R K v  [pN], with velocities and accelerations those of the time
/// scheme (TimeScheme) over the step from the last accepted state, whose motion this term keeps:
///
/// - with lumped masses at the nodes; on a grid that is reset, particles carry it from grid to grid:
///   a node's is the mass-weighted mean of what its particles' linear fields have there, and
///   particles take the change of velocity, its gradient and the acceleration from the nodes (affine
///   FLIP);
/// - with the consistent mass at the particles, whose motion obeys the scheme one by one. So no mass
///   matrix is inverted, whatever becomes of the grid, and the midpoint rule keeps momentum and
///   angular momentum to rounding.
///
/// Prescribed nodes move as they are told: their velocity is the rate of what is prescribed.
/// Densities are in kg/m^3, so that a mass [kg/m^3 um^3] times 1e-12 is a force [pN] per
/// acceleration [um/s^2]. Source: docs/theory.md, section 11.
class Inertia : public Term {
 public:
  /// Of particles that carry their motion, or of a body that begins (Dynamics::initial_velocity).
  /// Collective.
  /// \throws base::InputError without densities
  Inertia(const Body& body, double load);

  /// Whether nobody has told this term of a motion but the problem.
  bool begins() const { return begins_; }
  /// The supports of the body: their rates are the velocities of what they prescribe.
  void follow(const Supports& supports);
  /// The accelerations of a body that begins, from the force that nothing balances [pN]; prescribed
  /// components have those of their supports.
  void begin(const grid::Vector& unbalanced);
  /// Goes on from a motion at the nodes; particles have theirs.
  void resume(double load, const grid::Vector& u, const grid::Vector& velocity,
              const grid::Vector& acceleration);

  /// The load at which a step that ends at another one is in balance.
  double balance_load(double end) const;
  /// Whether there are nodes without a mass that are not prescribed: of fictitious points alone,
  /// they move as their neighbours let them.
  bool has_idle_nodes() const { return has_idle_nodes_; }
  /// Where the body is at a load if accelerations stay what they are [um].
  grid::Vector predicted(double load) const;
  /// The displacement at the end of a step, from that of the balance, but for prescribed components.
  void go_to_end(grid::Vector& u) const;
  /// Error in time of a step that ends at a load with this displacement [um]: what the next term of
  /// Taylor's series adds to it, dt^2 (beta - 1/6) (a_1 - a_0), in the root of its mass-weighted mean
  /// square. Source: Zienkiewicz, Xie, Earthquake Engng Struct. Dyn. 20 (1991) 871.
  double step_error(double load, const grid::Vector& u) const;
  /// The step to a load was accepted with this displacement: from now on the motion is that of its
  /// end, and so is the force, until there is another load.
  void arrive(double load, const grid::Vector& u);
  /// The same step of the same body on another grid: what its tangent depends on.
  void take_step(const Inertia& other) { step_ = other.step_; }

  void set_load(double load) override;
  TermForce force(const TrialState& state, grid::Vector& force) const override;
  std::int64_t add_tangent(const TrialState& state,
                           const transfer::BlockRows<Device>& rows) const override;
  std::int64_t add_tangent(const TrialState& state,
                           const transfer::StencilRows<Device>& rows) const override;
  void add_tangent_times(const TrialState& state, const ConstNodeView& direction,
                         const NodeView& product) const override;

  /// Of nodes, at the last accepted state [um/s], [um/s^2].
  const grid::Vector& velocity() const { return velocity_; }
  const grid::Vector& acceleration() const { return acceleration_; }
  /// The same velocity, of prescribed components before a corner that their load curves may have
  /// there [um/s].
  grid::Vector arriving_velocity() const;
  /// Of this rank's particles [um/s].
  ConstNodeView particle_velocity() const;
  /// Of the last accepted state [aJ].
  double kinetic_energy() const;
  /// What damping takes there [aJ/s].
  double damping_power(const TrialState& state) const;

 private:
  const Dynamics& dynamics() const { return *body_.problem().dynamics; }
  bool is_lumped() const { return dynamics().lumped; }
  void weigh();
  void begin_particles();
  void find_nodal_motion();
  void find_nodal_velocities();
  void prescribe(double end);
  void carry_idle_nodes(double dt, const grid::Vector& change);
  void go_from(const grid::Vector& u);
  NodeView carried_by(const grid::Vector& nodal) const;
  void carry(const grid::Vector& nodal, const NodeView& field) const;
  void carry_difference(const grid::Vector& from, const grid::Vector& to,
                        const NodeView& field) const;
  void carry_gradient(const grid::Vector& u) const;
  void nodal_force(const TrialState& state, grid::Vector& force) const;
  grid::Vector seen_by_scheme(const grid::Vector& u) const;
  void particle_force(const TrialState& state, grid::Vector& force) const;
  void add_stiffness_damping(const TrialState& state, grid::Vector& force) const;
  double mass_factor() const;
  template <class Rows>
  void add_to_tangent(const TrialState& state, const Rows& rows) const;

  const Body& body_;
  const Supports* supports_ = nullptr;
  Kokkos::View<const double*, Device> density_;  // (material) [pN s^2/um^4]
  NodeView mass_here_;                           // (touched node, 0) of this rank's particles
  grid::Vector mass_;                            // of owned nodes, in each component [pN s^2/um]
  double largest_mass_ = 0.0;
  bool begins_ = true, has_idle_nodes_ = false;

  double load_;            // of the last accepted state
  double step_ = 0.0;      // dt of the step that is tried [s]; 0: none is
  grid::Vector from_;      // displacement of the last accepted state [um]
  NodeView carried_from_;  // the same at the particles, of the consistent mass
  grid::Vector velocity_, acceleration_;
  // Of prescribed components at the end of the step, from within it [um/s^2], [um/s]; at the balance.
  grid::Vector prescribed_, arriving_, balancing_;
};

}  // namespace stroma::mechanics
