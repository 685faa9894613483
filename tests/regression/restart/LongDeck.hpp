// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A viscous gel with a vessel, pulled for four seconds in steps of one, which may be run in parts.

#include <cmath>
#include <string>

#include "support/Program.hpp"

namespace stroma::test {

/// The section Image of a cube with a vessel along y.
inline const std::string gel_with_a_vessel = R"(  Image:
    Phantom:
      Kind: Shapes
      Size: [12, 12, 12]
      Voxel Size [um]: [1, 1, 1]
      Shapes:
        vessel: {Kind: Cylinder, Label: 1, "Center [um]": [5, 6, 6], Axis: [0, 1, 0], "Length [um]": 12, "Radius [um]": 3}
)";

/// \param grid     what the section Grid holds beside the size of elements: ", Reset: true"
/// \param seconds  how long it is pulled: 4 is all of it
inline std::string long_deck(const std::string& grid, int seconds) {
  std::string times;
  for (int t = 1; t <= seconds; ++t) times += (t == 1 ? "" : ", ") + std::to_string(t) + ".0";
  return "Stroma:\n" + gel_with_a_vessel + R"(  Materials:
    gel:
      Label: 0
      Model: Mooney-Rivlin
      C1 [Pa]: 200
      C2 [Pa]: 60
      Poisson Ratio: 0.4
      Viscosity: {Moduli: [0.6], "Relaxation Times [s]": [1.5]}
    vessel: {Label: 1, Model: Neo-Hookean, "Shear Modulus [Pa]": 1000, Poisson Ratio: 0.4}
  Grid: {"Element Size [um]": [2, 2, 2])" +
         grid + R"(}
  Load Curves:
    pull: {"Times [s]": [0, 4], Values: [0, 1]}
  Boundary Conditions:
    bottom: {Face: y-, Components: xyz, "Displacement [um]": [0, 0, 0]}
    top: {Face: y+, Components: xyz, Strain: 0.08, Load Curve: pull}
  Loading: {"Times [s]": [)" +
         times + R"(]}
  Solver: {Newton Tolerance: 1.0e-12}
  Output: {Pictures: false, Checkpoint Every: 1}
)";
}

/// The largest difference of two histories, of the largest value of each column, or, for forces, of
/// the largest force, but for how the solver got there; infinite where they are tables of other shapes.
inline double difference(const History& one, const History& other) {
  if (one.names() != other.names() || one.rows() != other.rows()) return INFINITY;
  const auto largest = [&](const std::string& name) {
    double size = 0.0;
    for (const double value : one[name]) size = std::max(size, std::fabs(value));
    return size;
  };
  const auto is_force = [](const std::string& name) {
    return name.find(".reaction_") != std::string::npos;
  };
  double force = 0.0, worst = 0.0;
  for (const std::string& name : one.names())
    if (is_force(name)) force = std::max(force, largest(name));
  for (const std::string& name : one.names()) {
    if (name == "wall_seconds" || name == "residual" || name.find("iterations") < name.size())
      continue;
    const double scale = is_force(name) ? force : largest(name);
    for (std::size_t s = 0; s < one.rows(); ++s)
      if (scale > 0.0) worst = std::max(worst, std::fabs(one[name][s] - other[name][s]) / scale);
  }
  return worst;
}

}  // namespace stroma::test
