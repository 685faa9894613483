// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The displacement components that are prescribed, and the forces it takes to prescribe them.

#include <array>
#include <string>
#include <vector>

#include "stroma/grid/Halo.hpp"
#include "stroma/mechanics/conditions/BodyStatics.hpp"
#include "stroma/mechanics/conditions/RigidMotion.hpp"
#include "stroma/mechanics/problem/Problem.hpp"

namespace stroma::mechanics {

/// Calls the visitor for each component that conditions hold by other means than nodes.
using HeldComponents = std::function<void(const HeldVisitor& visit)>;

/// What Supports must know of the body on its grid.
struct SupportedBody {
  using NodeCounts = Kokkos::View<std::uint8_t*, grid::Device>;

  /// (touched node) elements around it that hold particles, of any rank; 0: no particle touches it
  NodeCounts filled_around;
  /// (condition)(touched node) the same, counting only elements that hold particles of the
  /// condition's grip; read for ImposedBy::grip only
  std::vector<NodeCounts> gripped;
  const Pieces& pieces;
  HeldComponents held_otherwise;
  /// Whether a body that nothing holds against its loads is refused; else it is held all the same.
  bool is_refused_if_loose = true;
};

/// All prescribed components of this rank's owned nodes: those of the face conditions (but for
/// those imposed by penalty, which prescribe nothing: see BoundaryPoints.hpp); u_z
/// everywhere in plane strain; the nodes that no particle touches, and those of pieces that nothing
/// strains (BodyStatics), which leave the system; and the few that hold a free rigid motion.
///
/// Displacements are those since the base configuration, at which the load factor was base_load: of
/// a condition that moves a point X by u(X, load), u(X, load) - u(X, base_load).
class Supports {
 public:
  using Device = grid::Device;
  using NodeCounts = SupportedBody::NodeCounts;

  /// Collective.
  /// \param halo       this rank's nodes and their owners
  /// \param problem    with the conditions; outlives the supports, as the halo does
  /// \param base_load  load factor at the base configuration
  /// \param body       its nodes that particles touch, and its pieces
  /// \param statics    knows of the body's elements and loads; gets to know what is held
  /// \throws base::InputError when two conditions prescribe one component differently, when a
  ///         condition's face has no particle near it, when a condition cannot be followed by a
  ///         grid that is reset, or when loads move what nothing holds (BodyStatics)
  Supports(const grid::Halo& halo, const Problem& problem, double base_load,
           const SupportedBody& body, BodyStatics& statics);

  /// (touched node) bit c: component c is prescribed.
  const Kokkos::View<std::uint8_t*, Device>& held() const { return held_; }

  /// Lets displacements within a step be those on its line, from now on.
  void go_straight(const StraightStep& step) { step_ = step; }

  /// Sets the prescribed components of u [um] to their values at a load factor (base_load to 1).
  void impose(double load, grid::Vector& u) const;
  /// How much the prescribed components of u must change for a load factor; 0 at the others.
  grid::Vector change(double load, const grid::Vector& u) const;
  /// Whether the prescribed components of u are what impose() makes them, to a share of the largest
  /// of them; 0: to the last bit. Collective.
  bool are_imposed(double load, const grid::Vector& u, double share = 0.0) const;
  /// Sets the prescribed components of a vector to how much those of u exceed their values at a load
  /// factor, times a stiffness [pN/um].
  void excess(double load, const grid::Vector& u, double stiffness, grid::Vector& excess) const;
  /// Derivative of the prescribed components by the load factor [um]; 0 at the others.
  void rate(double load, grid::Vector& rate) const;
  /// Sets the prescribed components of a vector to zero.
  void clear(grid::Vector& v) const;
  /// The prescribed components of a vector; 0 at the others.
  grid::Vector prescribed_part(const grid::Vector& v) const;
  /// Euclidean norm of the unbalanced force (internal minus external) at the prescribed components
  /// of face conditions [pN]. Collective.
  double reaction_norm(const grid::Vector& unbalanced_force) const;

  /// The same at the components that hold a free rigid motion [pN]; 0 without any. Collective.
  double hold_norm(const grid::Vector& unbalanced_force) const;

  /// Force of each condition's prescribed nodes on the body [pN]: the sum of the unbalanced forces
  /// at its prescribed components; 0 of a condition imposed by penalty. A component that two
  /// conditions prescribe counts for the first. Collective.
  std::vector<std::array<double, 3>> reactions(const grid::Vector& unbalanced_force) const;

  /// Moment of each condition's prescribed nodes, at a displacement u, on the body about the axis that
  /// its face turns about [aJ], sum of f . a x (x + u - center); 0 of a face that does not turn.
  /// Collective.
  std::vector<double> torques(const grid::Vector& u, const grid::Vector& unbalanced_force) const;

  /// Sets v to 1 at the components of one axis that reactions() counts for a condition, and to 0 at
  /// all others: the reaction is v . unbalanced_force.
  void mark_reaction(std::size_t condition, int component, grid::Vector& v) const;

  /// Components held against free rigid motion.
  const std::vector<NodeComponent>& rigid_holds() const { return rigid_holds_; }
  /// The pieces of the body, and those that left the system.
  const PiecesSummary& pieces() const { return pieces_; }
  /// What the user should know of both, in a sentence each.
  std::vector<std::string> notes() const;
  /// Unknowns of the whole problem: components of active nodes that are not prescribed.
  std::int64_t unknowns() const { return unknowns_; }

 private:
  /// Calls use(unknown, value) for each prescribed component.
  template <class Use>
  void for_each_value(double load, const Use& use) const;

  struct Prescribed {
    int unknown;         ///< 3 * owned node + component
    int condition;       ///< index, or one of the reasons below
    double rate;         ///< displacement per load factor, at load 0 [um]
    bool turns = false;  ///< its displacement is not proportional to the load
  };
  /// One whose displacement is not proportional to the load.
  struct Turned {
    int unknown;
    const BoundaryCondition* condition;
    std::array<double, 3> X;  ///< where the condition has the node in the undeformed body [um]
  };
  enum Reason { plane_strain = -1, untouched = -2, rigid_motion = -3, carried = -4 };

  template <class Condition>
  double norm_where(const grid::Vector& unbalanced_force, const Condition& is_one) const;
  void prescribe_faces(const Problem& problem, const SupportedBody& supported);
  void hold_what_is_loose(const SupportedBody& body, const BodyStatics& statics);
  void carry_idle_pieces(const SupportedBody& body, const BodyStatics& statics);
  void hold_free_motions(const SupportedBody& body, const std::vector<std::int64_t>& free_pieces,
                         bool only_deep_nodes);
  void mark_held();
  NodeComponent component(int unknown) const;
  int piece_of(const Pieces& pieces, int unknown) const;

  grid::Halo const* halo_;
  Problem const* problem_;
  int conditions_;
  double base_load_;
  StraightStep step_;
  std::vector<Prescribed> prescribed_;
  std::vector<Turned> turned_;
  std::vector<std::uint8_t> held_owned_;  // (owned node) bits as in held_
  std::vector<NodeComponent> rigid_holds_;
  PiecesSummary pieces_;
  std::int64_t active_nodes_ = 0;
  Kokkos::View<std::uint8_t*, Device> held_;
  std::int64_t unknowns_ = 0;
};

}  // namespace stroma::mechanics
