// SPDX-License-Identifier: BSD-3-Clause

#include "run/DeckComparison.hpp"

#include <Teuchos_XMLParameterListCoreHelpers.hpp>
#include <sstream>

namespace stroma {
namespace {

std::string text_of(const Teuchos::ParameterEntry& entry) {
  std::ostringstream text;
  text.precision(17);
  entry.leftshift(text, false);
  return text.str();
}

void compare(const Teuchos::ParameterList& there, const Teuchos::ParameterList& here,
             const std::string& where, std::vector<std::string>& lines) {
  for (auto one = there.begin(); one != there.end(); ++one) {
    const std::string& name = there.name(one);
    const Teuchos::ParameterEntry* other = here.getEntryPtr(name);
    if (other == nullptr) {
      lines.push_back(where + name + ": there, and not here");
    } else if (there.entry(one).isList() && other->isList()) {
      compare(there.sublist(name), here.sublist(name), where + name + "|", lines);
    } else if (text_of(there.entry(one)) != text_of(*other)) {
      lines.push_back(where + name + ": " + text_of(there.entry(one)) + " there, " +
                      text_of(*other) + " here");
    }
  }
  for (auto one = here.begin(); one != here.end(); ++one)
    if (there.getEntryPtr(here.name(one)) == nullptr)
      lines.push_back(where + here.name(one) + ": not there, and here");
}

}  // namespace

std::string body_of_deck(const Deck& deck) {
  DeckParameters parameters = deck.parameters;
  parameters.rig.reset();  // its conditions are there
  for_each_image_file(parameters,
                      [](const std::string&, std::string& file) { file = "as its checksum says"; });
  const auto list = deck::filled(deck_section(), parameters);
  for (const char* free : {"Title", "Loading", "Load Curves", "Solver", "Output"})
    list->remove(free, false);
  if (deck.parameters.loading.inertia) {  // a body's motion is kept as its masses have it
    Teuchos::ParameterList& loading = list->sublist("Loading");
    loading.set("Inertia", true);
    loading.set("Mass", deck.parameters.loading.mass == solver::MassMatrix::lumped
                            ? std::string("Lumped")
                            : std::string("Consistent"));
  }
  std::ostringstream text;
  Teuchos::writeParameterListToXmlOStream(*list, text);
  return text.str();
}

std::vector<std::string> differences(const std::string& there, const std::string& here) {
  std::vector<std::string> lines;
  try {
    compare(*Teuchos::getParametersFromXmlString(there), *Teuchos::getParametersFromXmlString(here),
            "", lines);
  } catch (const std::exception&) {
    throw base::InputError("its deck cannot be read");
  }
  return lines;
}

}  // namespace stroma
