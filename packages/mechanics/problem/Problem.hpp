// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What is solved: the body, its materials, its supports, its loads, and by which variant of the
/// method.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "stroma/mechanics/problem/BoundaryConditions.hpp"
#include "stroma/mechanics/problem/Dynamics.hpp"
#include "stroma/mechanics/problem/ExternalForces.hpp"
#include "stroma/mechanics/problem/Laws.hpp"
#include "stroma/mechanics/problem/Method.hpp"

namespace stroma::mechanics {

class Body;
class Term;

/// How the drives of a material follow the load: its active stress, and its growth.
struct MaterialDrives {
  LoadCurve active, growth;
};

/// Everything about a run that does not change with the load.
struct Problem {
  grid::Grid body;  ///< the grid at load 0; it fills the body's box
  Laws laws;        ///< of each material
  NamedConditions conditions;
  NamedForces forces = {};
  std::vector<MaterialDrives> drives = {};  ///< of each material; empty: nothing drives any
  /// Besides, a force per reference volume [pN/um^3] at full load that depends on where a particle
  /// was in the undeformed body, X [um]; empty: none. For applications and tests, not for decks.
  std::function<std::array<double, 3>(const std::array<double, 3>& X)> body_force = {};
  double duration = 1.0;  ///< time at full load [s]
  /// Of each material [kg/m^3]; empty: all alike, which inertia does not take.
  std::vector<double> density = {};
  /// Of the particles next to the body's faces across each axis, at load 0 [um]; tractions,
  /// penalties and the ends of a grid that is reset need it.
  std::array<double, 3> outer_thickness{};
  /// Half the edges of the particles' domains at load 0 [um], for each layer of particles along an
  /// axis (particles::LayoutSizes); hats do without.
  std::array<std::vector<double>, 3> particle_half_edge{};

  Method method = {};
  std::optional<Dynamics> dynamics = {};  ///< absent: without inertia
  /// An application's own terms of the balance (terms/Term.hpp), made anew with each base
  /// configuration.
  std::vector<std::function<std::unique_ptr<Term>(const Body&)>> terms = {};

  /// How a condition is imposed. Where the deck does not say: at nodes; on a grid that is reset, by
  /// penalty if one of its faces is not is_kept_plane().
  ImposedBy imposed_by(const BoundaryCondition& condition) const;
  /// Whether nodes keep a face a plane, so that a grid that is reset can have nodes on it.
  bool is_kept_plane(Face face) const { return keeper_of_plane(face) != nullptr; }
  /// Where such a face is at a load factor, along its axis [um]; of others, where it was at first.
  double place_of_plane(Face face, double load) const;

  /// Whether the springs of a condition imposed by penalty pull on (Method::springs_pull_on).
  bool pulls_on(const BoundaryCondition& condition) const {
    return method.springs_pull_on && !condition.penalty_factor;
  }
  /// Stiffness per area of such springs, on a face across an axis: epsilon = factor M / L, without
  /// a factor 2e4 M / L, or 10 M / h of springs that pull on [Pa/um]; M the stiffest K + 4/3 mu, L
  /// the body's length along the axis, and h that of its elements.
  double spring_stiffness(const BoundaryCondition& condition, int axis) const;

 private:
  const BoundaryCondition* keeper_of_plane(Face face) const;
};

}  // namespace stroma::mechanics
