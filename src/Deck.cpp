#include "Deck.hpp"

#include <fstream>
#include <iterator>

#include "deck/Document.hpp"
#include "image/ImageSection.hpp"

namespace stroma {

deck::Section<DeckParameters> deck_section() {
  deck::Section<DeckParameters> section(
      "Stroma", "A specimen from an image, its materials, supports and load, and how it is solved.");
  section.optional("Title", &DeckParameters::title, deck::any(),
                   "One line about the run; it stands in the results and on the pictures.");
  section.required_section(image::image_section(), &DeckParameters::image);
  section.required_section(material::materials_section(), &DeckParameters::materials);
  section.section(particles::particles_section(), &DeckParameters::particles);
  section.required_section(grid::grid_section(), &DeckParameters::grid);
  section.required_section(mechanics::boundary_conditions_section(),
                           &DeckParameters::boundary_conditions);
  section.section(solver::loading_section(), &DeckParameters::loading);
  section.section(solver::solver_section(), &DeckParameters::solver);
  section.section(output::output_section(), &DeckParameters::output);
  return section;
}

Deck read_deck(const std::string& path, const std::vector<std::string>& overrides) {
  const deck::Document document = deck::load(path, overrides);
  Deck deck;
  deck.path = path;
  deck.folder = document.folder();
  deck.parameters = deck::read(document, deck_section());
  std::ifstream file(path);
  deck.text.assign(std::istreambuf_iterator<char>(file), {});
  return deck;
}

}  // namespace stroma
