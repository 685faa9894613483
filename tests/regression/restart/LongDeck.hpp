// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A viscous gel with a vessel, pulled for four seconds in steps of one, which may be run in parts.

#include <cmath>
#include <string>

#include "support/Program.hpp"

namespace stroma::test {

/// \param grid     what the section Grid holds beside the size of elements: ", Reset: true"
/// \param seconds  how long it is pulled: 4 is all of it
inline std::string long_deck(const std::string& grid, int seconds) {
  std::string times;
  for (int t = 1; t <= seconds; ++t) times += (t == 1 ? "" : ", ") + std::to_string(t) + ".0";
  return R"(Stroma:
  Image:
    Phantom:
      Kind: Shapes
      Size: [12, 12, 12]
      Voxel Size [um]: [1, 1, 1]
      Shapes:
        vessel: {Shape: Cylinder, Label: 1, "Start [um]": [2, 0, 6], "End [um]": [9, 12, 6], "Radius [um]": 3}
  Materials:
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
  Output: {Pictures: false}
)";
}

/// The largest difference of two histories, of the largest value of each column, but for how the
/// solver got there; infinite where they are tables of other shapes.
inline double difference(const History& one, const History& other) {
  if (one.names() != other.names() || one.rows() != other.rows()) return INFINITY;
  double worst = 0.0;
  for (const std::string& name : one.names()) {
    if (name == "wall_seconds" || name == "residual" || name.find("iterations") < name.size())
      continue;
    double scale = 0.0, apart = 0.0;
    for (std::size_t s = 0; s < one.rows(); ++s) {
      scale = std::max(scale, std::fabs(one[name][s]));
      apart = std::max(apart, std::fabs(one[name][s] - other[name][s]));
    }
    if (scale > 0.0) worst = std::max(worst, apart / scale);
  }
  return worst;
}

}  // namespace stroma::test
