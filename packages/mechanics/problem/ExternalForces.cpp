// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/problem/ExternalForces.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace stroma::mechanics {

std::vector<transfer::VolumeForce> volume_forces(const NamedForces& forces, const grid::Grid& body,
                                                 const std::array<double, 3>& outer_thickness) {
  std::vector<transfer::VolumeForce> all;
  for (const auto& named : forces) {
    const ExternalForce& force = named.second;
    transfer::VolumeForce one{{0.0, 0.0, 0.0}, force.acceleration.has_value(), -1, 0.0, 0.0};
    double scale = 1.0;
    if (force.acceleration) scale = 1e-6;  // kg/m^3 um^3 m/s^2 = 1e-18 N = 1e-6 pN
    if (force.traction) {
      const int axis = axis_of(*force.face);
      if (axis < 0) throw std::logic_error("a traction acts on a single face");
      const auto d = static_cast<std::size_t>(axis);
      one.axis = axis;
      one.face = body.origin[d] + (is_upper(*force.face) ? body.length(axis) : 0.0);
      one.thickness = outer_thickness[d];
      scale = 1.0 / outer_thickness[d];
    }
    const auto& vector = force.body_force     ? *force.body_force
                         : force.acceleration ? *force.acceleration
                                              : *force.traction;
    for (std::size_t c = 0; c < 3; ++c) one.per_volume[c] = scale * vector[c];
    all.push_back(one);
  }
  return all;
}

}  // namespace stroma::mechanics
