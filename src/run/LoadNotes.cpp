// SPDX-License-Identifier: BSD-3-Clause

#include "run/LoadNotes.hpp"

#include "run/MovingSupports.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

std::vector<std::string> load_notes(const DeckParameters& p, std::int64_t slices) {
  using base::format;
  std::vector<std::string> notes;
  const auto& conditions = p.boundary_conditions.conditions;
  for (const auto& [name, condition] : conditions) {
    const char* const of = name.c_str();
    if (!condition.strain || *condition.strain == 0.0) continue;
    if (*condition.strain >= 1.0)
      notes.push_back(format(
          "Boundary Conditions|%s: Strain = %g is %g %% of the body's length; it is a share, not in "
          "per cent",
          of, *condition.strain, 100.0 * *condition.strain));
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
