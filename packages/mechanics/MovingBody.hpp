// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A body through its load steps: which base configuration a step starts from, and what becomes of
/// its result.

#include <functional>
#include <memory>
#include <optional>

#include "stroma/mechanics/MomentumBalance.hpp"

namespace stroma::mechanics {

/// How far a body has come: what its particles and its displacement do not tell.
struct Motion {
  double load = 0.0;           ///< of the last accepted step
  double previous_load = 0.0;  ///< of the one before
  double history_load = 0.0;   ///< up to which laws remember
  double base_load = 0.0;      ///< at the base configuration
  bool has_news = false;       ///< no step has begun since the last accepted one
  /// Of the base configuration, once a grid was reset; else the undeformed body's.
  std::optional<grid::Grid> grid;
};

/// Keeps the particles and the grid under them from load step to load step:
///
///     if (body.begin_step()) ...        // a new balance(), on a new grid
///     ... solve body.balance() for a trial displacement ...
///     body.accept(load, trial);         // or nothing: a failed step leaves no trace
///
/// Without grid reset there is one base configuration, the undeformed body. With reset, an accepted
/// displacement is the start of the next step: the particles move with their nodes, and the nodes
/// return to the lattice, which is laid under the particles wherever they are by then.
class MovingBody {
 public:
  /// \param communicator  of the ranks that share the body
  /// \param partition     of the grid of the undeformed body
  /// \param particles     of the undeformed body; they are never written
  /// \param problem       materials, conditions, loads and the choice of method
  /// \throws base::InputError  see Supports
  MovingBody(const base::Communicator& communicator, const grid::Partition& partition,
             const particles::Particles<grid::Device>& particles, const Problem& problem);

  /// Goes on with a body that has moved.
  ///
  /// \param communicator  of the ranks that share the body; they may be others than before
  /// \param partition     of the grid of the undeformed body
  /// \param particles     of the undeformed body
  /// \param problem       materials, conditions, loads and the choice of method
  /// \param motion        how far it has come
  /// \param restore       gives the particles (of the undeformed body, movable if they are to be)
  ///                      what steps change of them, at the base configuration (Fields.hpp)
  /// \throws base::InputError  see Supports; and what restore throws
  MovingBody(const base::Communicator& communicator, const grid::Partition& partition,
             const particles::Particles<grid::Device>& particles, const Problem& problem,
             const Motion& motion,
             const std::function<void(particles::Particles<grid::Device>&)>& restore);
  /// The displacements of the last accepted step and, if it is known, of the one before (null: not
  /// known), over balance().owned_map(): the last that a body needs to go on.
  void resume(const grid::Vector& u, const grid::Vector* previous);
  /// The same of a body with inertia: the motion of its nodes at the last accepted step.
  void resume_motion(const grid::Vector& velocity, const grid::Vector& acceleration);

  MomentumBalance& balance() { return *balance_; }
  const MomentumBalance& balance() const { return *balance_; }

  /// Makes the accepted displacement the start of the next step: until then laws remember the step
  /// before, on which the accepted stresses rest. A second call without an accepted step in between
  /// does nothing. Collective.
  /// \return whether balance() is another one now, with other maps
  /// \throws base::RunError when the new configuration cannot be computed with
  bool begin_step();

  const Motion& motion() const { return motion_; }
  /// That of the step before, since the same base; null: not known.
  const grid::Vector* previous_displacement() const { return previous_.get(); }
  /// Displacement since the base configuration [um], of the last accepted step.
  const grid::Vector& displacement() const { return *displacement_; }
  /// Displacement at a load factor if the body goes on as in the last accepted step; nothing if
  /// there is none to go by, if load curves may turn it elsewhere, or if it has inertia
  /// (Inertia::predicted). Its prescribed components are not set.
  std::optional<grid::Vector> extrapolated(double load) const;

  /// Takes a converged displacement since the base.
  void accept(double load, const grid::Vector& u);
  /// Changes the method's stabilization [-], >= 0; solvers are to be attached anew.
  void stabilize(double stabilization);
  /// After a failed step: what happened in the last accepted one is no guide.
  void reject() {
    previous_.reset();
    is_predictable_ = false;
  }
  /// Displacement of a body with inertia at a load factor, if its motion tells: by velocities and
  /// accelerations, or on the straight line of the step before, whichever would have come closer to
  /// that. The latter does where steps are long for the body's vibrations. Prescribed components are
  /// not set.
  std::optional<grid::Vector> predicted(double load) const;

 private:
  std::optional<grid::Vector> on_the_line(double load) const;
  /// Makes the balance of these particles, which have not moved yet.
  void rest_on(const grid::Partition& partition,
               const particles::Particles<grid::Device>& particles);
  void reset_grid();
  void project();

  base::Communicator communicator_;
  Problem problem_;
  std::unique_ptr<MomentumBalance> balance_;
  std::unique_ptr<grid::Vector> displacement_;
  std::unique_ptr<grid::Vector> previous_;  // a step earlier, on the same base; null: not known
  Motion motion_;
  bool is_predictable_ = false, is_line_better_ = false;
};

}  // namespace stroma::mechanics
