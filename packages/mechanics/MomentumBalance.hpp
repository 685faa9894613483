// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The balance of momentum of a body of particles on a grid: what a solver, or another Trilinos
/// application, couples to.

#include <Teuchos_RCP.hpp>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "stroma/mechanics/body/Body.hpp"
#include "stroma/mechanics/conditions/Supports.hpp"
#include "stroma/mechanics/terms/Inertia.hpp"
#include "stroma/mechanics/terms/Springs.hpp"
#include "stroma/tangent/StencilMatrix.hpp"
#include "stroma/tangent/TangentMatrix.hpp"

namespace stroma::mechanics {

/// How the tangent is stored: compressed rows for any package of Trilinos, or the stencil, which
/// takes a sixth of the memory.
enum class TangentForm { compressed_rows, stencil };

/// The forces on the nodes at one displacement and load.
struct ForceBalance {
  /// Internal less external force [pN] at all owned unknowns; at prescribed ones it is the support's.
  grid::RCP<const grid::Vector> unbalanced;
  /// Size of the forces to which a residual is compared [pN]: the largest of the Euclidean norms of
  /// the reactions and of those that terms name.
  double scale = 0.0;
  /// Euclidean norm of the forces at the components that hold a free rigid motion [pN].
  double hold = 0.0;
  /// How far rounding alone puts the residual from zero [pN].
  double rounding = 0.0;
  /// Particles, over all ranks, that are turned inside out; forces are not finite then.
  std::int64_t inverted = 0;
};

/// Residual and tangent of the balance of momentum on the grid of one base
/// configuration. The unknown u is the displacement of the grid's nodes since then [um], in a
/// Tpetra vector over owned_map(); the residual is the sum of the terms' forces (terms/):
///
///     r(u) = f_elastic(u) + f_springs(u, load) - load f_dead + ...      [pN],   K = dr/du [pN/um],
///
/// with the force of inertia among them if the problem has dynamics: then u is the displacement at
/// which momentum is in balance, one point of a time step (Inertia).
///
/// Prescribed components of u (see Supports) are set by
/// supports().impose(load, u); their rows of the residual are zero and their rows and columns of
/// the tangent hold only a diagonal, so that K is symmetric and every Newton increment keeps them.
///
/// Every member function is collective. Where a displacement turns particles inside out, forces are
/// not finite, and the caller rejects it.
class MomentumBalance {
 public:
  using Device = grid::Device;

  /// \param communicator         of the ranks that share the body
  /// \param partition            which elements and nodes are whose
  /// \param particles            this rank's, in the order of their elements
  /// \param problem              materials, conditions, loads and the choice of method
  /// \param base_load            load factor at the base configuration
  /// \param is_refused_if_loose  whether the loads must be held (SupportedBody)
  /// \throws base::InputError  see Body, Supports and Springs
  MomentumBalance(const base::Communicator& communicator, const grid::Partition& partition,
                  const particles::Particles<Device>& particles, const Problem& problem,
                  double base_load = 0.0, bool is_refused_if_loose = true);
  /// A body without external forces on a grid that is not reset.
  MomentumBalance(const base::Communicator& communicator, const grid::Partition& partition,
                  const particles::Particles<Device>& particles, const Laws& laws,
                  const NamedConditions& conditions);

  const grid::RCP<const grid::Map>& owned_map() const { return body_.halo().owned_map(); }
  const grid::Halo& halo() const { return body_.halo(); }
  const Problem& problem() const { return body_.problem(); }
  const Body& body() const { return body_; }
  Body& body() { return body_; }
  const Supports& supports() const { return *supports_; }

  /// Load factor at which forces are evaluated; that of the base at the start.
  double load() const { return load_; }
  void set_load(double load);
  /// Lets prescribed displacements go straight along a step, from now on; of others, and at its ends,
  /// nothing changes.
  void go_straight(const StraightStep& step);

  /// The forces at a displacement, evaluated unless they are those of the last call: terms that do
  /// not change with the load, not even when the load has changed. Good until the next call.
  const ForceBalance& forces(const grid::Vector& u);
  /// The residual r(u): the unbalanced force, and zero at prescribed components.
  /// \return ForceBalance::inverted
  std::int64_t residual(const grid::Vector& u, grid::Vector& r);
  /// Derivative of the residual by the load factor, with prescribed components moving along [pN].
  void load_derivative(const grid::Vector& u, grid::Vector& derivative);
  /// Force of each condition's support on the body [pN].
  std::vector<std::array<double, 3>> reactions(const grid::Vector& u);
  /// Moment of the support of each condition that turns, in their order, on the body about the axis
  /// that it turns about [aJ].
  std::vector<double> torques(const grid::Vector& u);
  /// Energy that supports store because they pull [aJ] (Springs); 0 without any.
  double support_energy(const grid::Vector& u) const;
  /// Whether conditions are imposed by springs that pull on.
  bool has_springs_that_pull_on() const { return springs_ != nullptr && springs_->some_pull_on(); }
  /// Lets springs that pull on begin with the stress at a displacement (Springs); before the first
  /// solution of a step.
  void begin_pulling(const grid::Vector& u);
  /// Whether such springs miss more at a solution than `share` of the forces, and not by rounding
  /// alone: then they pull on, and there is another balance to be solved.
  bool pull_on(const grid::Vector& u, double share);
  /// How far they are from where conditions want faces [um] (Springs::distance).
  double distance_of_faces(const grid::Vector& u) const;
  /// The internal force alone, of stress [pN], evaluated anew.
  /// \return ForceBalance::inverted
  std::int64_t internal_force(const grid::Vector& u, grid::Vector& force) const;
  /// The same of particles with other laws, which remember nothing: what a number of a law does to
  /// the force at a given displacement. There are as many laws as the problem has.
  std::int64_t internal_force(const std::shared_ptr<const StressKernels>& laws,
                              const grid::Vector& u, grid::Vector& force) const;

  /// How the tangent is stored from now on; compressed rows unless told otherwise.
  void choose_tangent(TangentForm form);
  /// Frees its memory, once nobody else has it; it is built anew when it is asked for.
  void forget_tangent();
  /// Assembles the tangent at u.
  /// \return particles, over all ranks, that u turns inside out
  std::int64_t assemble_tangent(const grid::Vector& u);
  /// The tangent's operator; built at the first call.
  grid::RCP<Tpetra::Operator<double>> tangent();
  /// The same as a matrix, when it is stored as compressed rows.
  grid::RCP<tangent::Matrix> tangent_matrix();
  /// product = K(u) v without forming K and without regard to what is prescribed.
  void tangent_times(const grid::Vector& u, const grid::Vector& v, grid::Vector& product) const;
  /// Where the tangent was last assembled [um]; null: nowhere yet.
  const grid::RCP<const grid::Vector>& linearization_point() const { return linearized_at_; }
  /// How many times stiffer than an element the stiffest term is; 1 for bodies without springs. The
  /// residual tells so much less of the body's.
  double stiffness_contrast() const { return stiffest_diagonal_ / body_.typical_diagonal(); }

  /// The same body, conditions and base with hats on the lattice under the shape functions: what
  /// multigrid coarsens from. Springs are lumped, for a field of hats that satisfies theirs does
  /// not satisfy those of wider functions. Collective.
  std::unique_ptr<MomentumBalance> with_hats(const grid::Partition& lattice) const;

  /// The term of inertia; null: there is none.
  Inertia* inertia() { return inertia_; }
  const Inertia* inertia() const { return inertia_; }
  /// The step to a load was accepted: a motion is at its end from now on.
  void arrive(double load, const grid::Vector& u);
  /// Makes the tangent that of a step of the same body on another grid.
  void follow(const MomentumBalance& other);
  /// What acts on a moving body besides its stress and its inertia, supports included [pN]; with
  /// inertia only.
  grid::Vector external_force(const grid::Vector& u);
  /// What damping takes [aJ/s].
  double damping_power(const grid::Vector& u) const;

  /// Tells the terms that a displacement is that of an accepted step, and that what they will be
  /// asked comes after it: histories may be written.
  void accept(const grid::Vector& u);
  /// Goes on with a body whose histories were written at one load factor, and which was solved at
  /// another.
  void resume(double history_load, double load);
  /// Changes the method's stabilization [-], >= 0, from the next force and tangent on.
  void stabilize(double stabilization);
  /// The body's particles have another state than before: forces are to be evaluated anew.
  void forget_forces();

 private:
  using Terms = std::vector<std::unique_ptr<Term>>;
  TrialState state(const grid::Vector& u) const { return {u, body_.points(u)}; }
  Terms terms_of(const Problem& problem);
  bool has_forces_at(const grid::Vector& u) const;
  /// Whether the same displacement has other stresses at another load: by time, or driven.
  bool stress_follows_load() const;
  grid::RCP<grid::Vector> with_terms(bool changing, const TrialState& state,
                                     grid::RCP<grid::Vector> sum, TermForce& all) const;
  void find_steady_forces(const TrialState& state);
  void find_supports(bool is_refused_if_loose);
  void begin_motion();

  Body body_;
  double base_load_, load_;
  double history_load_;         // at which histories were written last
  Inertia* inertia_ = nullptr;  // one of the terms, as the next
  Springs* springs_ = nullptr;
  Terms terms_;
  double stiffest_diagonal_;  // [pN/um]
  std::unique_ptr<Supports> supports_;

  // The last evaluation: where; the sum of the forces that do not change with the load; and at a
  // load, if there was one, all of them.
  grid::RCP<const grid::Vector> forces_at_;
  grid::RCP<grid::Vector> steady_;
  std::optional<double> forces_load_;
  TermForce of_steady_;
  ForceBalance forces_;

  TangentForm form_ = TangentForm::compressed_rows;
  std::unique_ptr<tangent::TangentMatrix> rows_;
  grid::RCP<tangent::StencilMatrix> stencil_;
  grid::RCP<const grid::Vector> linearized_at_;
};

}  // namespace stroma::mechanics
