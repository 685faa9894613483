// SPDX-License-Identifier: BSD-3-Clause

#include <sstream>

#include "stroma/base/Error.hpp"
#include "stroma/deck/Declaration.hpp"
#include "stroma/deck/Nearest.hpp"

namespace stroma::deck {
namespace {

using Presence = SubsectionDeclaration::Presence;

/// One section of the reference: a declared one, or a list that is passed on (no declaration).
struct Place {
  std::string path;
  std::string note;
  std::string meaning;
  const Declaration* section = nullptr;
  const void* defaults = nullptr;
};

std::string note_on(Presence presence) {
  switch (presence) {
    case Presence::optional:
      return "may be absent";
    case Presence::required:
      return "required";
    case Presence::defaulted:
      break;
  }
  return "";
}

/// A section and all below it, in the order of declaration.
void collect(const Declaration& section, const void* defaults, const std::string& path,
             const std::string& note, std::vector<Place>& places) {
  places.push_back({path, note, section.meaning, &section, defaults});
  const auto below = [&path](const std::string& name) {
    return path.empty() ? name : path + "|" + name;
  };
  for (const SubsectionDeclaration& sub : section.sections) {
    const void* inner = sub.look(defaults);
    collect(*sub.section, inner != nullptr ? inner : sub.section->defaults.get(),
            below(sub.section->name), note_on(sub.presence), places);
  }
  if (section.named) {
    const std::string count =
        section.named->at_least > 0 ? ", at least " + std::to_string(section.named->at_least) : "";
    collect(*section.named->each, section.named->each->defaults.get(), below("NAME"),
            "named by you" + count, places);
  }
  for (const FreeListDeclaration& list : section.free_lists) {
    places.push_back(
        {below(list.name), "may be absent; passed on as it is", list.meaning, nullptr, nullptr});
  }
}

void print_parameter(std::ostringstream& out, const ParameterDeclaration& parameter,
                     const void* defaults) {
  out << "- `" << parameter.name << "`: " << type_name(parameter.type)
      << (parameter.type.or_word ? " or string; " : "; ")
      << parameter.admissible.describe(parameter.type) << "; ";
  const std::optional<Value> value = parameter.fetch(defaults);
  if (parameter.required) {
    out << "required";
  } else if (value) {
    out << "default " << print(*value);
  } else {
    out << "absent by default";
  }
  out << "\n  " << parameter.meaning << "\n";
}

void print_place(std::ostringstream& out, const Place& place, const std::string& root_name) {
  out << "## " << (place.path.empty() ? root_name : place.path);
  if (!place.note.empty()) out << " (" << place.note << ")";
  out << "\n\n" << place.meaning << "\n\n";
  if (place.section == nullptr || place.section->parameters.empty()) return;
  for (const ParameterDeclaration& parameter : place.section->parameters) {
    print_parameter(out, parameter, place.defaults);
  }
  out << "\n";
}

}  // namespace

std::string reference_of(const Declaration& root, const std::string& section_path) {
  std::vector<Place> places;
  collect(root, root.defaults.get(), "", "", places);

  const bool whole = section_path.empty() || section_path == root.name;
  std::ostringstream out;
  std::vector<std::string> known;
  for (const Place& place : places) {
    const bool is_inside =
        place.path == section_path || place.path.rfind(section_path + "|", 0) == 0;
    if (whole || is_inside) print_place(out, place, root.name);
    if (!place.path.empty()) known.push_back(place.path);
  }
  if (out.str().empty()) {
    throw base::InputError("no such section of the deck: \"" + section_path + "\"; " +
                           suggestion(section_path, known));
  }
  return out.str();
}

}  // namespace stroma::deck
