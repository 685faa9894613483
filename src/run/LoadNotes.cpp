// SPDX-License-Identifier: BSD-3-Clause

#include "run/LoadNotes.hpp"

#include <algorithm>
#include <cmath>

#include "run/MovingSupports.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {
namespace {

using base::format;

/// Of motions by the body's whole length and more: per cent for shares, or another unit than um.
std::string far_note(const std::string& name, const mechanics::BoundaryCondition& condition,
                     const std::array<double, 3>& length) {
  const char* const of = name.c_str();
  constexpr const char* not_in_per_cent = "it is a share, not in per cent";
  if (condition.strain && *condition.strain >= 1.0)
    return format("Boundary Conditions|%s: Strain = %g is %g %% of the body's length; %s", of,
                  *condition.strain, 100.0 * *condition.strain, not_in_per_cent);
  if (condition.displacement_gradient) {
    const auto& G = *condition.displacement_gradient;
    const double largest = *std::max_element(
        G.begin(), G.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    if (std::abs(largest) >= 1.0)
      return format(
          "Boundary Conditions|%s: %g in its Displacement Gradient (the Strain of Simple Shear) is "
          "%g %%; %s",
          of, largest, 100.0 * largest, not_in_per_cent);
  }
  const int loaded = condition.displacement ? condition.loaded_component(length) : -1;
  if (loaded < 0) return "";
  const int normal =
      condition.face == mechanics::Face::all ? loaded : mechanics::axis_of(*condition.face);
  const double moved = (*condition.displacement)[static_cast<std::size_t>(loaded)],
               across = length[static_cast<std::size_t>(normal)];
  if (std::abs(moved) < across) return "";
  return format(
      "Boundary Conditions|%s: its displacement, %g um, is %g %% of the body's length, %g um along "
      "%c",
      of, moved, 100.0 * std::abs(moved) / across, across, "xyz"[normal]);
}

}  // namespace

std::vector<std::string> load_notes(const DeckParameters& p, const std::array<double, 3>& length,
                                    std::int64_t slices) {
  std::vector<std::string> notes;
  const auto& conditions = p.boundary_conditions.conditions;
  bool has_told_gradient = false;  // sides that are sheared have the one of the face
  for (const auto& [name, condition] : conditions) {
    const char* const of = name.c_str();
    std::string far = far_note(name, condition, length);
    if (!far.empty() && !(has_told_gradient && condition.displacement_gradient)) {
      has_told_gradient = has_told_gradient || condition.displacement_gradient;
      notes.push_back(std::move(far));
    }
    if (!condition.strain || *condition.strain == 0.0) continue;
    const double between = strain_between_faces(p, condition);
    if (between != 0.0 && between != *condition.strain && mechanics::is_upper(*condition.face))
      notes.push_back(format(
          "Boundary Conditions|%s: the opposite face has Strain, too: %g in all between them, "
          "which is what forces are drawn against",
          of, between));
    if (condition.imposed_by == mechanics::ImposedBy::grip)
      notes.push_back(format(
          "Boundary Conditions|%s: a Grip holds a layer of one to two elements, and Strain is "
          "of the whole length: what is free is strained more, and forces are larger",
          of));
  }
  for (const auto& [name, force] : p.external_forces.forces) {
    if (!force.traction || !force.face) continue;
    for (const auto& [support, condition] : conditions)
      for (std::size_t c = 0; c < 3; ++c)
        if ((*force.traction)[c] != 0.0 && condition.prescribes(static_cast<int>(c)) &&
            (condition.face == force.face || condition.face == mechanics::Face::all))
          notes.push_back(
              format("External Forces|%s: Boundary Conditions|%s holds its face along %c: the "
                     "traction goes into that support, not into the body",
                     name.c_str(), support.c_str(), "xyz"[c]));
  }
  if (slices == 1 && !p.grid.plane_strain)
    notes.emplace_back(
        "the image is a single slice, and Grid|Plane Strain is false: a thin sheet, which may bend "
        "and whose steps may fail; Plane Strain = true keeps its thickness");
  if (slices > 1 && p.grid.plane_strain)
    notes.push_back(format("Grid|Plane Strain: the image's %lld slices move as one",
                           static_cast<long long>(slices)));
  return notes;
}

}  // namespace stroma
