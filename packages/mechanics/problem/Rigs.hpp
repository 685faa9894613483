// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Rigs: what a laboratory does to a specimen, as lists of conditions on faces of the body's box.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "stroma/mechanics/problem/BoundaryConditions.hpp"

namespace stroma::mechanics {

/// What the faces beside those that are moved and held do in Simple Shear.
enum class RigSides { free, sheared };

/// A rig as the deck has it. Which of the values a kind takes stands in rigs().
struct RigParameters {
  std::string kind;                              ///< name of one of rigs()
  std::optional<Face> face;                      ///< the one that moves
  std::optional<double> strain;                  ///< along its outward normal; of a shear, gamma
  std::optional<double> displacement;            ///< the same as a length [um]
  std::optional<int> direction;                  ///< axis along which Simple Shear moves the face
  std::optional<RigSides> sides;                 ///< of Simple Shear; else free
  std::optional<std::array<int, 2>> axes;        ///< of Biaxial
  std::optional<std::array<double, 2>> strains;  ///< along each of the axes
  std::optional<std::array<double, 2>> displacements;  ///< the same as lengths [um]
  std::optional<double> angle;  ///< of Torsion, right-handed about the axis [deg]
  std::optional<std::array<double, 3>>
      center;  ///< on the axis of Torsion [um]; else the box's middle
  std::optional<std::vector<std::string>>
      boundary;  ///< of Stiffness, names of uniform_boundaries(); else all

  std::optional<std::string> load_curve;  ///< of all that moves
  std::optional<ImposedBy> imposed_by;    ///< of all conditions
  std::optional<double> penalty_factor;   ///< of all conditions
};

/// A kind of rig: a pure function from its parameters to conditions.
struct Rig {
  std::string name;
  std::vector<std::string> takes;  ///< names of the deck's parameters beside those that all take
  std::string meaning;             ///< one sentence for the deck reference
  NamedConditions (*conditions)(const RigParameters&);
  bool compresses = false;  ///< strain and displacement must be negative
  bool has_steps = true;    ///< takes Load Curve, Imposed By and Penalty Factor
};

/// All kinds. Conditions are called `held` and `moved`, in Biaxial with the axis behind it, and
/// `wall` with the face behind it.
const std::vector<Rig>& rigs();

/// The kind of a name of the table.
const Rig& rig_of(const std::string& name);

/// The rig whose conditions change from load case to load case (StiffnessCases.hpp): it has none of
/// its own.
constexpr const char* stiffness_rig = "Stiffness";

/// The conditions of a rig whose parameters were checked.
NamedConditions conditions_of(const RigParameters& rig);

}  // namespace stroma::mechanics
