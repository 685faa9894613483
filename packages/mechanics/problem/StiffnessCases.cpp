// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/problem/StiffnessCases.hpp"

#include <algorithm>
#include <cstddef>

namespace stroma::mechanics {
namespace {

/// The same components on both faces across an axis.
void hold_across(NamedConditions& conditions, int axis, const std::string& components) {
  for (const bool upper : {false, true})
    conditions.emplace_back(std::string(1, "xyz"[axis]) + (upper ? "+" : "-"),
                            hold(static_cast<Face>(2 * axis + (upper ? 1 : 0)), components));
}

LoadCases mixed_normal() {
  LoadCases cases{{}, {0, 1, 2}};
  for (int axis = 0; axis < 3; ++axis)
    hold_across(cases.conditions, axis, std::string(1, "xyz"[axis]));
  return cases;
}

LoadCases mixed_shear(int unit) {
  const auto [i, j] = axes_of_unit(unit);
  const int k = 3 - i - j;
  LoadCases cases{{}, {unit}};
  for (const int across : {i, j}) {
    std::string tangential = "xyz";
    tangential.erase(static_cast<std::size_t>(across), 1);
    hold_across(cases.conditions, across, tangential);
  }
  hold_across(cases.conditions, k, {"xyz"[k]});
  return cases;
}

}  // namespace

const NamedBoundaries& uniform_boundaries() {
  static const NamedBoundaries table{{"Uniform Displacement", UniformBoundary::displacement},
                                     {"Mixed", UniformBoundary::mixed},
                                     {"Uniform Traction", UniformBoundary::traction}};
  return table;
}

NamedBoundaries wanted_boundaries(const RigParameters& rig) {
  NamedBoundaries wanted;
  for (const auto& named : uniform_boundaries())
    if (!rig.boundary || std::count(rig.boundary->begin(), rig.boundary->end(), named.first) > 0)
      wanted.push_back(named);
  return wanted;
}

std::array<int, 2> axes_of_unit(int unit) {
  constexpr std::array<std::array<int, 2>, 6> axes{
      {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{1, 2}}, {{0, 2}}, {{0, 1}}}};
  return axes[static_cast<std::size_t>(unit)];
}

std::string name_of_unit(int unit) {
  const auto [i, j] = axes_of_unit(unit);
  return {"xyz"[i], "xyz"[j]};
}

std::vector<LoadCases> load_cases(UniformBoundary boundary) {
  const std::vector<int> all{0, 1, 2, 3, 4, 5};
  switch (boundary) {
    case UniformBoundary::displacement:
      return {{{{"faces", hold(Face::all, "xyz")}}, all}};
    case UniformBoundary::traction:
      return {{{}, all}};
    default:
      return {mixed_normal(), mixed_shear(3), mixed_shear(4), mixed_shear(5)};
  }
}

}  // namespace stroma::mechanics
