// SPDX-License-Identifier: BSD-3-Clause

#include "run/WithoutEffect.hpp"

#include <algorithm>
#include <utility>

namespace stroma {

bool is_followed(const DeckParameters& p, const std::string& curve) {
  const auto asked_for = curves_asked_for(p);
  return std::any_of(asked_for.begin(), asked_for.end(),
                     [&](const auto& asked) { return asked.second == curve; });
}

std::vector<std::string> notes_without_effect(const DeckParameters& p) {
  std::vector<std::string> notes;
  const auto look_at = [&](bool has_none, const std::string& what, const std::string& read_with) {
    if (has_none) notes.push_back(what + " has no effect: it is read with " + read_with + " only");
  };
  using particles::Layout;
  const particles::ParticleParameters usual;
  look_at(p.particles.layout != Layout::voxel_centers && p.particles.per_voxel != usual.per_voxel,
          "Particles|Per Voxel", "Layout = Voxel Centers");
  look_at(p.particles.layout != Layout::per_element && p.particles.per_element != usual.per_element,
          "Particles|Per Element", "Layout = Per Element");
  const bool follows = p.grid.reset && p.grid.shape_functions != shape::ShapeFunctions::linear;
  look_at(!follows && p.grid.particle_domain != mechanics::GridParameters{}.particle_domain,
          "Grid|Particle Domain", "Reset = true and Shape Functions other than Linear");
  for (const auto& [name, condition] : p.boundary_conditions.conditions)
    for (int c = 0; c < 3; ++c) {
      const std::string component(1, "xyz"[c]);
      look_at(condition.displacement && !condition.prescribes(c) &&
                  (*condition.displacement)[static_cast<std::size_t>(c)] != 0.0,
              "Boundary Conditions|" + name + "|Displacement [um] along " + component,
              component + " among the Components");
    }
  for (const auto& [name, force] : p.external_forces.forces)
    for (const auto& [vector, unit] : {std::pair{force.body_force, "Body Force [pN/um^3]"},
                                       std::pair{force.acceleration, "Acceleration [m/s^2]"},
                                       std::pair{force.traction, "Traction [Pa]"}})
      look_at(p.grid.plane_strain && vector && (*vector)[2] != 0.0,
              "External Forces|" + name + "|" + unit + " along z", "Plane Strain = false");
  for (const auto& curve : p.load_curves.curves)
    look_at(!is_followed(p, curve.first), "Load Curves|" + curve.first,
            "a condition, a force or a material whose Load Curve it is");
  return notes;
}

}  // namespace stroma
