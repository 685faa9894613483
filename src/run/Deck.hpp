// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The whole deck: one plain struct, filled once.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/base/Error.hpp"
#include "stroma/deck/Document.hpp"
#include "stroma/deck/Section.hpp"
#include "stroma/image/ImageParameters.hpp"
#include "stroma/material/Material.hpp"
#include "stroma/mechanics/problem/BoundaryConditions.hpp"
#include "stroma/mechanics/problem/ExternalForces.hpp"
#include "stroma/mechanics/problem/GridParameters.hpp"
#include "stroma/mechanics/problem/InitialConditions.hpp"
#include "stroma/mechanics/problem/LoadCurve.hpp"
#include "stroma/mechanics/problem/Rigs.hpp"
#include "stroma/output/OutputParameters.hpp"
#include "stroma/particles/Seeding.hpp"
#include "stroma/solver/SolverParameters.hpp"

namespace stroma {

struct DeckParameters {
  std::string title;
  image::ImageParameters image;
  material::MaterialsParameters materials;
  particles::ParticleParameters particles;
  mechanics::GridParameters grid;
  mechanics::BoundaryConditionsParameters
      boundary_conditions;                      ///< of a deck that was read: the rig's, too
  std::optional<mechanics::RigParameters> rig;  ///< in their place
  mechanics::ExternalForcesParameters external_forces;
  mechanics::InitialConditionsParameters initial_conditions;
  mechanics::LoadCurvesParameters load_curves;
  solver::LoadingParameters loading;
  solver::SolverParameters solver;
  output::OutputParameters output;
};

/// The load curve of a name; without a name the load itself.
mechanics::LoadCurve curve_named(const DeckParameters& parameters,
                                 const std::optional<std::string>& name);

/// What of a deck's materials follows the load, active stress, growth and pressures: the section and
/// the name of its load curve, if it has one.
std::vector<std::pair<std::string, std::optional<std::string>>> curves_of_materials(
    const DeckParameters& parameters);

/// What of a deck may follow a load curve, materials, conditions and forces alike: the section and the
/// name of its curve, if it has one.
std::vector<std::pair<std::string, std::optional<std::string>>> curves_asked_for(
    const DeckParameters& parameters);

/// Whether the deck asks for a stiffness (Rig|Kind = Stiffness) instead of load steps.
bool asks_for_stiffness(const DeckParameters& parameters);

/// Everything a deck may say; the reader, the deck reference and deck.xml follow from it.
deck::Section<DeckParameters> deck_section();

/// A deck that was read without a mistake.
struct Deck {
  deck::Document document;
  DeckParameters parameters;
  std::string text;                    ///< as the user wrote it
  std::vector<std::string> overrides;  ///< from --set
};

/// Reads and checks a deck.
/// \param overrides  "Section|Parameter=value", from --set
/// \throws base::InputError with every mistake of the deck
Deck read_deck(const std::string& path, const std::vector<std::string>& overrides);

/// Calls visit(where, file) for each image file that a deck names.
void for_each_image_file(DeckParameters& parameters,
                         const std::function<void(const std::string&, std::string&)>& visit);

/// The files that a deck is read from: itself and its image.
std::vector<std::string> input_files(const Deck& deck);

/// The files that its run writes.
std::vector<std::string> run_files(const Deck& deck);

/// The conditions that the deck's rig stands for, or the load cases of a stiffness, a line each after
/// one that names it; none without a rig.
std::vector<std::string> describe_rig(const DeckParameters& parameters);

/// The deck as run, every default filled in, its rig as the conditions that it stands for (but for a
/// stiffness), and the image's file name absolute, so that it can be run again from any folder.
Teuchos::RCP<Teuchos::ParameterList> as_run(const Deck& deck);

/// Mistakes that show only once the image is read, as mistakes of the deck: a line that starts with
/// the name of a section or parameter ("Grid|Element Size [um]: ...") gets its line number.
base::InputError located(const Deck& deck, const base::InputError& error);

}  // namespace stroma
