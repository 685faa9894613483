#pragma once

/// \file
/// The displacement components that are prescribed, and the forces it takes to prescribe them.

#include <array>
#include <string>
#include <vector>

#include "grid/Halo.hpp"
#include "mechanics/BoundaryConditions.hpp"
#include "mechanics/RigidMotion.hpp"

namespace stroma::mechanics {

/// All prescribed components of this rank's owned nodes: those of the face conditions; u_z
/// everywhere in plane strain; the nodes that no particle touches, which leave the system; and the
/// few that hold a free rigid motion.
class Supports {
 public:
  using Device = grid::Device;

  /// Collective.
  /// \param active  (touched node) whether a particle of any rank touches it
  /// \throws base::InputError when two conditions prescribe one component differently, or when a
  ///         condition's face has no particle near it
  Supports(const grid::Halo& halo, const NamedConditions& conditions,
           const Kokkos::View<std::uint8_t*, Device>& active);

  /// (touched node) bit c: component c is prescribed.
  const Kokkos::View<std::uint8_t*, Device>& held() const { return held_; }

  /// Sets the prescribed components of u [um] to their values at a load factor (0 to 1).
  void impose(double load, grid::Vector& u) const;
  /// Sets the prescribed components of a vector to zero.
  void clear(grid::Vector& v) const;
  /// Euclidean norm of the internal force at the prescribed components of face conditions [pN].
  /// Collective.
  double reaction_norm(const grid::Vector& internal_force) const;

  /// Force of each condition's support on the body [pN]: the sum of the internal forces at its
  /// prescribed components. A component that two conditions prescribe counts for the first.
  /// Collective.
  std::vector<std::array<double, 3>> reactions(const grid::Vector& internal_force) const;

  /// Components held against free rigid motion.
  const std::vector<NodeComponent>& rigid_holds() const { return rigid_holds_; }
  /// Unknowns of the whole problem: components of active nodes that are not prescribed.
  std::int64_t unknowns() const { return unknowns_; }

 private:
  struct Prescribed {
    int unknown;    ///< 3 * owned node + component
    int condition;  ///< index, or one of the reasons below
    double value;   ///< displacement at full load [um]
  };
  enum Reason { plane_strain = -1, untouched = -2, rigid_motion = -3 };

  grid::Halo const* halo_;
  int conditions_;
  std::vector<Prescribed> prescribed_;
  std::vector<NodeComponent> rigid_holds_;
  Kokkos::View<std::uint8_t*, Device> held_;
  std::int64_t unknowns_ = 0;
};

}  // namespace stroma::mechanics
