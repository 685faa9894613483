// SPDX-License-Identifier: BSD-3-Clause

#include "run/ResolutionNotes.hpp"

#include <algorithm>

#include "stroma/base/Log.hpp"
#include "stroma/shape/ShapeFunctions.hpp"

namespace stroma {
namespace {

using base::format;

/// Splines have more functions across a body than elements: with fewer particles there is a motion
/// that strains none of them.
void tell_few_particles(const shape::ShapeKind& kind, const Specimen& specimen,
                        std::vector<std::string>& notes) {
  if (kind.width < 4) return;  // no spline
  const grid::Grid& body = specimen.body;
  for (std::size_t d = 0; d < (body.flat ? 2 : 3); ++d) {
    const std::int64_t functions = body.elements[d] + kind.width - 2;
    const auto particles = static_cast<std::int64_t>(specimen.layout.half_edge[d].size());
    if (particles < functions)
      notes.push_back(format(
          "Shape Functions = %s has %lld functions across the body along %c, but %lld particles: "
          "the tangent may be singular, steps rejected and linear iterations many; more elements, "
          "more particles an element or other Shape Functions help",
          kind.name, static_cast<long long>(functions), "xyz"[d],
          static_cast<long long>(particles)));
  }
}

void tell_few_elements(const std::string& material, const image::Widths& widths,
                       const grid::Grid& body, std::vector<std::string>& notes) {
  std::string across;
  bool are_few = false;
  for (std::size_t d = 0; d < (body.flat ? 2 : 3); ++d) {
    if (!widths.has_surface[d]) continue;
    const double elements = widths.chords[d] / body.spacing[d];
    are_few = are_few || elements < 2.0;
    across += format("%s%.2g along %c", across.empty() ? "" : ", ", elements, "xyz"[d]);
  }
  if (are_few)
    notes.push_back("few elements across " + material + ": from wall to wall on the average " +
                    across + "; 2 or more resolve bending: a smaller Grid|Element Size [um]");
}

}  // namespace

std::vector<std::string> resolution_notes(const DeckParameters& p, const Specimen& specimen) {
  std::vector<std::string> notes;
  tell_few_particles(shape::kind_of(p.grid.shape_functions), specimen, notes);
  std::size_t m = 0;
  for (const auto& [name, material] : p.materials.materials) {
    if (!material::is_pressure(material))
      tell_few_elements(name, specimen.widths[m], specimen.body, notes);
    ++m;
  }
  return notes;
}

}  // namespace stroma
