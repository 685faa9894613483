// SPDX-License-Identifier: BSD-3-Clause

#include "run/BodyNotes.hpp"

#include "stroma/base/Log.hpp"
#include "stroma/mechanics/BarelyFilled.hpp"

namespace stroma {
namespace {

/// A node that two bodies share moves both, as if they were glued.
std::string joined_note(std::int64_t bodies, std::int64_t pieces) {
  if (bodies <= pieces) return "";
  return base::format(
      "the image's filled voxels make %lld bodies that share no face of a voxel, and the grid joins "
      "them to %lld: forces pass across gaps and corners where bodies share a node; smaller elements "
      "part them",
      static_cast<long long>(bodies), static_cast<long long>(pieces));
}

/// The energy of a pressure depends on its wall alone only where particles integrate the volume of a
/// displaced element exactly: at Gauss points.
std::string pressure_note(const DeckParameters& p) {
  if (p.particles.layout == particles::Layout::gauss) return "";
  for (const auto& [name, material] : p.materials.materials)
    if (material::is_pressure(material))
      return "material \"" + name +
             "\" is a pressure, and particles are not at Gauss points: nodes within it feel a force "
             "of the quadrature, against which its solid may be too soft; Particles|Layout = Gauss "
             "has none";
  return "";
}

}  // namespace

std::vector<std::string> body_notes(const Deck& deck, const Specimen& specimen,
                                    const mechanics::MomentumBalance& balance) {
  std::vector<std::string> notes = balance.supports().notes();
  for (const std::string& note :
       {joined_note(specimen.bodies, balance.supports().pieces().count),
        pressure_note(deck.parameters), mechanics::barely_filled_note(balance),
        solver::contrast_note(circumstances(deck, balance))})
    if (!note.empty()) notes.push_back(note);
  return notes;
}

}  // namespace stroma
