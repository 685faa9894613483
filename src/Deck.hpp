#pragma once

/// \file
/// The whole deck: one plain struct, filled once.

#include <string>
#include <vector>

#include "base/Communicator.hpp"
#include "deck/Section.hpp"
#include "grid/GridSection.hpp"
#include "image/ImageParameters.hpp"
#include "material/Material.hpp"
#include "mechanics/BoundaryConditions.hpp"
#include "output/OutputSection.hpp"
#include "particles/Seeding.hpp"
#include "solver/SolverSection.hpp"

namespace stroma {

struct DeckParameters {
  std::string title;
  image::ImageParameters image;
  material::MaterialsParameters materials;
  particles::ParticleParameters particles;
  grid::GridParameters grid;
  mechanics::BoundaryConditionsParameters boundary_conditions;
  solver::LoadingParameters loading;
  solver::SolverParameters solver;
  output::OutputParameters output;
};

/// Everything a deck may say; the reader, the deck reference and deck.xml follow from it.
deck::Section<DeckParameters> deck_section();

/// A deck that was read without a mistake.
struct Deck {
  std::string path;
  std::string folder;  ///< file names in the deck are relative to it
  std::string text;    ///< as the user wrote it
  DeckParameters parameters;
};

/// Reads and checks a deck.
/// \param overrides  "Section|Parameter=value", from --set
/// \throws base::InputError with every mistake of the deck
Deck read_deck(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace stroma
