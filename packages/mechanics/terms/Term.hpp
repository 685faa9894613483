// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A summand of the balance of momentum.

#include <array>
#include <vector>

#include "stroma/grid/Types.hpp"
#include "stroma/mechanics/conditions/BoundaryPoints.hpp"
#include "stroma/transfer/StencilRows.hpp"
#include "stroma/transfer/Tangent.hpp"

namespace stroma::mechanics {

/// A displacement of the nodes as terms see it.
struct TrialState {
  const grid::Vector& u;                    ///< at owned unknowns [um]
  transfer::PointSet<grid::Device> points;  ///< with the same at touched nodes
};

/// What a term says of its force at a displacement.
struct TermForce {
  std::int64_t inverted = 0;  ///< particles of this rank that are turned inside out
  /// Euclidean norm over all ranks [pN], of a force that counts among those to which a residual is
  /// compared; 0: it does not.
  double size = 0.0;
  /// How far rounding alone puts it from what it should be [pN].
  double rounding = 0.0;
};

/// One summand f(u, load) of the residual, with its share of the tangent, df/du. A term lives as
/// long as one base configuration; what it needs of the body it refers to. Of the functions below
/// only force() must be there: a term without a tangent is a dead force.
///
/// Functions that launch kernels see the touched nodes of their rank; "added to" is zeroed by the
/// caller, who sums over ranks. force() writes owned unknowns, and sums over ranks itself
/// (grid::Halo::contributions() and sum_to_owner()). All but add_tangent(), add_tangent_times() and
/// visit_held() are collective.
class Term {
 public:
  using Device = grid::Device;
  using NodeView = grid::NodeView;
  using ConstNodeView = grid::ConstNodeView;
  using PerCondition = std::vector<std::array<double, 3>>;

  Term() = default;
  Term(const Term&) = delete;
  Term& operator=(const Term&) = delete;
  virtual ~Term() = default;

  /// Whether the force depends on the load factor.
  virtual bool changes_with_load() const { return true; }
  /// The load factor from now on.
  virtual void set_load(double) {}

  /// Writes the force [pN] at all owned unknowns; internal forces are positive.
  virtual TermForce force(const TrialState& state, grid::Vector& force) const = 0;
  /// Adds to the tangent [pN/um]. \return points of this rank that are turned inside out
  virtual std::int64_t add_tangent(const TrialState&, const transfer::BlockRows<Device>&) const {
    return 0;
  }
  virtual std::int64_t add_tangent(const TrialState&, const transfer::StencilRows<Device>&) const {
    return 0;
  }
  /// Adds the tangent's product with a vector.
  virtual void add_tangent_times(const TrialState&, const ConstNodeView& /*direction*/,
                                 const NodeView& /*product*/) const {}

  /// Size of the term's largest entries on the tangent's diagonal [pN/um]; 0: no larger than an
  /// element's.
  virtual double stiffest_diagonal() const { return 0.0; }
  /// From now on a diagonal tangent that is no softer will do: the body only preconditions.
  virtual void lump() {}

  /// Forces on the undeformed body, the sum of which its supports must balance: those that grow
  /// together are one, at their full size; several stand for all that they add up to in the run.
  virtual std::vector<grid::RCP<const grid::Vector>> dead_loads() const { return {}; }
  /// Visits the components that the term holds in place.
  virtual void visit_held(const Pieces&, const HeldVisitor&) const {}
  /// Adds what the term does for conditions [pN]: the force of their supports on the body.
  virtual void add_reactions(const TrialState&, PerCondition&) const {}
  /// Adds their moments about the axes of conditions whose faces turn [aJ].
  virtual void add_torques(const TrialState&, std::vector<double>&) const {}
  /// Energy that the supports of the term store because they pull [aJ].
  virtual double support_energy(const TrialState&) const { return 0.0; }

  /// Whether it has a history, on which its force depends; else it is not told of accepted steps.
  virtual bool remembers() const { return false; }
  /// The displacement is that of an accepted step, and the next one begins: histories may be written.
  /// Until then the accepted forces rest on the histories before.
  virtual void accept(const TrialState&) {}
};

}  // namespace stroma::mechanics
