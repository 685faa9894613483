// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What is written and said of a specimen's stiffness.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stiffness/ApparentStiffness.hpp"
#include "stroma/material/Bounds.hpp"

namespace stroma {

/// What was found with one boundary, and what follows.
struct BoundaryResults {
  BoundaryResults(std::string boundary, ApparentStiffness apparent);

  std::string name;  ///< of the boundary
  ApparentStiffness found;
  std::optional<Matrix6> compliance;   ///< where every strain costs energy
  std::vector<ClosestTensor> closest;  ///< of each of symmetries()
};

/// All that was found.
struct StiffnessResults {
  std::string title;
  std::array<double, 3> box;                           ///< edges [um]
  double solid_share;                                  ///< of the box
  std::vector<std::pair<std::string, double>> shares;  ///< of each material, of the box
  std::array<double, 6> face_shares;                   ///< solid, of x-, x+, y- ...
  /// Of the whole box, its empty space included; nothing where a material has fibres. With empty
  /// space the lower ones are 0.
  std::optional<material::MixtureBounds> bounds;
  Matrix6 voigt;  ///< voigt_stiffness()
  std::vector<BoundaryResults> all;

  /// The harmonic mean of the materials' stiffnesses: Reuss's bound [Pa]; nothing where it is 0, with
  /// empty space, or where a material has fibres.
  std::optional<Matrix6> reuss() const;
};

/// stiffness.csv, a line for each figure (docs/file_formats.md).
std::string stiffness_table(const StiffnessResults& results);
/// stiffness.json, the same as matrices.
std::string stiffness_json(const StiffnessResults& results);
/// The same for a reader, in few digits.
std::vector<std::string> stiffness_lines(const StiffnessResults& results);

}  // namespace stroma
