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
  /// Of the particles next to the body's faces across each axis, at load 0 [um]; tractions and
  /// penalties need it.
  std::array<double, 3> outer_thickness{};
  /// Half the edges of the particles' domains at load 0 [um], for each layer of particles along an
  /// axis (particles::LayoutSizes); hats do without.
  std::array<std::vector<double>, 3> particle_half_edge{};

  Method method = {};
  std::optional<Dynamics> dynamics = {};  ///< absent: without inertia
  /// An application's own terms of the balance (terms/Term.hpp), made anew with each base
  /// configuration.
  std::vector<std::function<std::unique_ptr<Term>(const Body&)>> terms = {};

  ImposedBy imposed_by(const BoundaryCondition& condition) const {
    return condition.imposed_by.value_or(method.reset ? ImposedBy::grip : ImposedBy::nodes);
  }
};

}  // namespace stroma::mechanics
