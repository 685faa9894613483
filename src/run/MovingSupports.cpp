// SPDX-License-Identifier: BSD-3-Clause

#include "run/MovingSupports.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stroma {
namespace {

/// Whether a condition moves points along an axis.
bool moves_along(const mechanics::BoundaryCondition& condition, int axis) {
  const auto a = static_cast<std::size_t>(axis);
  if (!condition.prescribes(axis)) return false;
  if (condition.images || condition.rotation) return true;
  if (condition.displacement) return (*condition.displacement)[a] != 0.0;
  if (condition.displacement_gradient)
    return std::any_of(&(*condition.displacement_gradient)[3 * a],
                       &(*condition.displacement_gradient)[3 * a] + 3,
                       [](double entry) { return entry != 0.0; });
  return condition.strain.value_or(0.0) != 0.0;
}

}  // namespace

double strain_between_faces(const DeckParameters& parameters,
                            const mechanics::BoundaryCondition& condition) {
  if (!condition.strain || *condition.strain == 0.0) return 0.0;
  const int axis = mechanics::axis_of(*condition.face);
  const auto opposite = mechanics::face_of(axis, !mechanics::is_upper(*condition.face));
  double strain = *condition.strain;
  for (const auto& [name, other] : parameters.boundary_conditions.conditions) {
    if (!other.applies_to(opposite) || !moves_along(other, axis)) continue;
    if (!other.strain || !(other.curve == condition.curve)) return 0.0;
    strain += *other.strain;
  }
  return strain;
}

std::vector<output::MovingSupport> moving_supports(const DeckParameters& parameters,
                                                   const std::array<double, 3>& length) {
  const auto& conditions = parameters.boundary_conditions.conditions;
  std::vector<output::MovingSupport> moving;
  for (std::size_t m = 0; m < conditions.size(); ++m) {
    const mechanics::BoundaryCondition& condition = conditions[m].second;
    if (condition.loaded_component(length) < 0) continue;
    output::MovingSupport support;
    support.name = conditions[m].first;
    support.index = m;
    for (int c = 0; c < 3; ++c)
      if (condition.prescribes(c))
        support.displacement[static_cast<std::size_t>(c)] =
            condition.full(c, length, {0.0, 0.0, 0.0}, length);
    const auto [x, y, z] = support.displacement;
    const double distance = std::hypot(x, y, z);
    support.along = {x / distance, y / distance, z / distance};
    support.strain = strain_between_faces(parameters, condition);
    support.follows_load = condition.curve.is_load();
    moving.push_back(support);
  }
  return moving;
}

output::HistoryNames history_names(const DeckParameters& parameters) {
  const auto& conditions = parameters.boundary_conditions.conditions;
  output::HistoryNames all{
      names(conditions), {}, names(parameters.materials.materials), parameters.loading.inertia};
  for (const auto& [name, condition] : conditions)
    if (condition.rotation) all.turning.push_back(name);
  for (const auto& [name, material] : parameters.materials.materials)
    if (material::is_pressure(material)) all.pressing.push_back(name);
  return all;
}

std::vector<double> pressures_at(const DeckParameters& parameters, double load) {
  std::vector<double> pressures;
  for (const auto& named : parameters.materials.materials) {
    const material::MaterialParameters& material = named.second;
    if (material::is_pressure(material))
      pressures.push_back(curve_named(parameters, material.load_curve).at(load) *
                          material.numbers.at("Pressure [Pa]"));
  }
  return pressures;
}

}  // namespace stroma
