// SPDX-License-Identifier: BSD-3-Clause

#include "study/StudyDeck.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "stroma/deck/Findings.hpp"
#include "stroma/deck/Nearest.hpp"
#include "study/StudyMembers.hpp"
#include "study/Uncertainty.hpp"

namespace stroma {
namespace {

using deck::tree::Form;
using deck::tree::List;
using deck::tree::Parameter;

constexpr std::size_t most_members = 1000;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

bool is_list(const Parameter& parameter) {
  const std::string text = trimmed(parameter.text);
  return parameter.form == Form::sequence ||
         (parameter.form == Form::typed_text && parameter.type.rfind("Array", 0) == 0 &&
          text.size() >= 2 && text.front() == '{' && text.back() == '}');
}

/// The entries of a list, as the user wrote them.
std::vector<std::string> entries(const Parameter& parameter) {
  if (parameter.form == Form::sequence) return parameter.items;
  const std::string text = trimmed(parameter.text);
  std::istringstream inside(text.substr(1, text.size() - 2));
  std::vector<std::string> result;
  for (std::string entry; std::getline(inside, entry, ',');) result.push_back(trimmed(entry));
  return result;
}

/// A value as --set would be given it.
std::string text_of(const Parameter& parameter) {
  if (parameter.form != Form::sequence) return parameter.text;
  std::string text;
  for (const std::string& item : parameter.items) text += (text.empty() ? "{" : ", ") + item;
  return text.empty() ? "{}" : text + "}";
}

std::vector<std::string> parts_of(const std::string& path) {
  std::istringstream stream(path);
  std::vector<std::string> parts;
  for (std::string part; std::getline(stream, part, '|');) parts.push_back(part);
  return parts;
}

/// The last parts of a path, joined by blanks.
std::string ending_of(const std::string& path, std::size_t count) {
  const std::vector<std::string> parts = parts_of(path);
  std::string text;
  for (std::size_t i = parts.size() - std::min(count, parts.size()); i < parts.size(); ++i)
    text += (text.empty() ? "" : " ") + parts[i];
  return text;
}

/// The shortest ending that no other varied parameter shares: "Shear Modulus [Pa]", or "vessel
/// Shear Modulus [Pa]".
std::string short_name(const std::string& path, const std::vector<Parameter>& varied) {
  for (std::size_t count = 1; count <= parts_of(path).size(); ++count) {
    const std::string ending = ending_of(path, count);
    const auto shares = [&](const Parameter& other) {
      return other.name != path && ending_of(other.name, count) == ending;
    };
    if (std::none_of(varied.begin(), varied.end(), shares)) return ending;
  }
  return path;
}

/// "Shear Modulus [Pa]" and "520.8" to "Shear Modulus 520.8 Pa".
std::string label_of(const std::string& name, const std::string& value) {
  const std::size_t bracket = name.rfind(" [");
  if (bracket == std::string::npos || name.back() != ']') return name + " " + value;
  return name.substr(0, bracket) + " " + value + " " +
         name.substr(bracket + 2, name.size() - bracket - 3);
}

void read_cases(const List& cases, std::vector<Variation>& variations, deck::Findings& findings) {
  static const std::string layout =
      "; a case stands two sublists deep: Cases, a name of yours for "
      "what differs, a name of yours for the case";
  const auto refuse_parameters = [&](const List& list, deck::Findings& inside) {
    for (const Parameter& parameter : list.parameters)
      inside.add(parameter.line, parameter.name,
                 parameter.form == Form::nothing ? "an empty case is written {}"
                                                 : "is a parameter, not a sublist" + layout);
  };
  refuse_parameters(cases, findings);
  for (const List& list : cases.lists) {
    deck::Findings inside = findings.inside(list.name, &list);
    refuse_parameters(list, inside);
    if (list.lists.empty() && list.parameters.empty()) inside.add("", "has no case" + layout);
    static const std::set<std::string> columns{"member",
                                               "status",
                                               "load",
                                               "strain_energy",
                                               "newton_iterations",
                                               "linear_iterations",
                                               "wall_seconds",
                                               "gain",
                                               "force_departure_rms",
                                               "force_departure_end",
                                               "secant_departure"};
    if (columns.count(list.name) > 0)
      inside.add("", "the table has a column of this name; choose another");
    Variation variation{list.name, {}};
    for (const List& one : list.lists) {
      deck::Findings in_case = inside.inside(one.name, &one);
      Choice choice{one.name, one.name, {}};
      for (const Parameter& parameter : one.parameters)
        choice.settings.push_back({parameter.name, text_of(parameter)});
      for (const List& sub : one.lists)
        in_case.add(sub.line, sub.name,
                    "is a sublist; a case holds parameters of the base deck, "
                    "each named by its whole path: Section|Parameter");
      variation.choices.push_back(std::move(choice));
    }
    variations.push_back(std::move(variation));
  }
}

void read_lists(const List& vary, std::vector<Variation>& variations, deck::Findings& findings) {
  for (const List& sub : vary.lists)
    findings.add(sub.line, sub.name,
                 "is a sublist; Vary holds a list of values for each parameter, "
                 "named by its whole path: Section|Parameter");
  for (const Parameter& parameter : vary.parameters) {
    if (parameter.form == Form::nothing) continue;  // has been reported
    if (!is_list(parameter)) {
      findings.add(parameter.line, parameter.name,
                   "\"" + parameter.text +
                       "\" is one value; admissible: a list of values, [a, b] in "
                       "YAML, {a, b} of an Array type in XML");
      continue;
    }
    Variation variation{parameter.name, {}};
    const std::string name = short_name(parameter.name, vary.parameters);
    for (const std::string& value : entries(parameter))
      variation.choices.push_back({value, label_of(name, value), {{parameter.name, value}}});
    if (variation.choices.empty())
      findings.add(parameter.line, parameter.name, "an empty list; admissible: at least one value");
    variations.push_back(std::move(variation));
  }
}

/// A parameter belongs to one variation, and names of folders are unique and free.
void check_variations(const std::vector<Variation>& variations, std::size_t cases,
                      deck::Findings& findings) {
  std::map<std::string, std::string> owner;
  std::size_t members = 1;
  for (std::size_t v = 0; v < variations.size(); ++v) {
    const Variation& variation = variations[v];
    const std::string section = v < cases ? "Cases" : "Vary";
    const std::string where = section + "|" + variation.name;
    std::set<std::string> own, folders;
    for (const Choice& choice : variation.choices) {
      for (const Setting& setting : choice.settings) own.insert(setting.parameter);
      const std::string folder = folder_name({choice.label});
      if (!folders.insert(folder).second)
        findings.add(where, "two of its members would have the same folder, " + folder);
      if (variations.size() == 1 && is_reserved(folder))
        findings.add(where, "\"" + choice.label +
                                "\" is the name of something that the study itself "
                                "writes; choose another");
    }
    for (const std::string& parameter : own) {
      const auto [other, is_new] = owner.emplace(parameter, where);
      if (!is_new)
        findings.add(where, "sets " + parameter + ", which " + other->second + " sets too");
    }
    members *= std::max<std::size_t>(1, variation.choices.size());
    if (members > most_members) {
      findings.add("", "more than " + std::to_string(most_members) + " members");
      return;
    }
  }
}

/// Finds the thing and the alternative that members are compared with.
std::optional<Pairing> find_pairing(const std::optional<PairingParameters>& wanted,
                                    const std::string& section,
                                    const std::vector<Variation>& variations,
                                    deck::Findings& findings) {
  if (!wanted) return std::nullopt;
  std::vector<std::string> things, references;
  for (const Variation& variation : variations) things.push_back(variation.name);
  const auto thing = std::find(things.begin(), things.end(), wanted->thing);
  if (thing == things.end()) {
    findings.add(section + "|Thing", "\"" + wanted->thing + "\" does not vary; " +
                                         deck::suggestion(wanted->thing, things));
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(thing - things.begin());
  for (const Choice& choice : variations[index].choices) {
    if (choice.value == wanted->reference || choice.label == wanted->reference)
      return Pairing{index, choice.label};
    references.push_back(choice.value);
  }
  findings.add(section + "|Reference", "\"" + wanted->reference + "\" is none of what " + *thing +
                                           " may be; " +
                                           deck::suggestion(wanted->reference, references));
  return std::nullopt;
}

/// What to tell about a name that is no member's. There may be hundreds: not all are listed.
std::string member_suggestion(const std::string& name, const std::vector<std::string>& folders) {
  const bool is_near = !deck::nearest(name, folders).empty();
  if (is_near || folders.size() <= 6) return deck::suggestion(name, folders);
  return "there are " + std::to_string(folders.size()) + ", such as \"" + folders.front() +
         "\" and \"" + folders.back() + "\"";
}

/// The members of a picture, by their names or the names of their folders.
std::vector<std::size_t> find_members(const std::vector<std::string>& wanted,
                                      const std::vector<Variation>& variations,
                                      deck::Findings& findings) {
  if (wanted.empty()) return {};
  std::vector<std::size_t> found;
  std::vector<std::string> folders;
  const std::vector<Member> members = members_of(variations);
  for (const Member& member : members) folders.push_back(member.folder);
  for (const std::string& name : wanted) {
    const auto member = std::find_if(members.begin(), members.end(), [&](const Member& one) {
      return one.folder == name || one.name == name;
    });
    const auto index = static_cast<std::size_t>(member - members.begin());
    if (member == members.end())
      findings.add("Plot|Von Mises Members",
                   "\"" + name + "\" is no member; " + member_suggestion(name, folders));
    else if (std::find(found.begin(), found.end(), index) != found.end())
      findings.add("Plot|Von Mises Members", "\"" + name + "\" is there twice");
    else
      found.push_back(index);
  }
  return found;
}

deck::Section<PairingParameters> pairing_section(const std::string& name,
                                                 const std::string& meaning) {
  deck::Section<PairingParameters> section(name, meaning);
  section.required("Thing", &PairingParameters::thing, deck::not_empty(),
                   "The name of a sublist of Cases, or the path of a parameter of Vary.");
  section.required("Reference", &PairingParameters::reference, deck::not_empty(),
                   "One of its cases, or one of its values: members with it are the references; "
                   "each other member is held against the one that is the same but for this.");
  return section;
}

}  // namespace

deck::Section<StudyParameters> study_section() {
  deck::Section<StudyPlotParameters> plot("Plot", "The pictures of a study.");
  plot.optional("Force Against Strain", &StudyPlotParameters::force_against_strain, deck::any(),
                "Draw force_strain.png: the force of one support against strain, a curve for each "
                "member.");
  plot.optional("Force Against Element Size", &StudyPlotParameters::force_against_element_size,
                deck::any(),
                "Where members differ in nothing but the size of the elements: draw "
                "force_element_size.png and write convergence.csv, with the force extrapolated to "
                "size 0 and the observed order.");
  plot.optional("Support", &StudyPlotParameters::support, deck::any(),
                "The boundary condition whose force is drawn; else the first one that moves.");
  plot.optional("Von Mises Members", &StudyPlotParameters::von_mises_members,
                deck::text_that("the name of a member's folder, such as 8_px__with_vessels",
                                [](const std::string&) { return true; }),
                "Draw von_mises.png: the von Mises stress of these members side by side, on one "
                "scale of colours and one of lengths. Named by their folders.");

  deck::Section<StudyParameters> section(
      "Study",
      "A family of runs that differ in named parameters: every combination of a case of each "
      "sublist of Cases and of a value of each list of Vary.");
  section.optional("Title", &StudyParameters::title, deck::any(),
                   "One line about the study; it stands on its pictures. Else the base deck's.");
  section.required("Base Deck", &StudyParameters::base_deck, deck::not_empty(),
                   "The deck that all members start from; relative to this file.");
  section.free_list(
      "Cases", &StudyParameters::cases,
      "Parameters that change together. It holds a sublist for each thing that differs "
      "(such as: grid), that one a sublist for each case (8 px), and that one the "
      "parameters of the case, each named by its path (Grid|Element Size [um]). You "
      "choose the names of things and cases; they name the members. A case may be "
      "empty: the base deck as it is.");
  section.free_list(
      "Vary", &StudyParameters::vary,
      "Parameters that change alone: the path of each (Materials|vessel|Shear Modulus "
      "[Pa]) with a list of its values. For values that are arrays themselves, use "
      "Cases.");
  section.optional(
      "Also Tabulate", &StudyParameters::also_tabulate, deck::any(),
      "Columns of history.csv whose value at full load is a column of study.csv too, such as "
      "bottom.reaction_x.");
  section.section(
      pairing_section("Compare",
                      "Adds the columns force_departure_rms and force_departure_end: how far a "
                      "member's force departs from that of its reference."),
      &StudyParameters::compare);
  section.section(pairing_section("Gain",
                                  "Adds the column gain: a member's force at full load, divided by "
                                  "that of its reference, less 1."),
                  &StudyParameters::gain);
  section.section(uncertainty_section(), &StudyParameters::uncertainty);
  section.section(plot, &StudyParameters::plot);
  return section;
}

Study read_study(const std::string& path) {
  deck::Document document = deck::load(path);
  StudyParameters parameters = deck::read(document, study_section());

  deck::Findings findings(document);
  std::vector<Variation> variations;
  const List* cases = document.root().list("Cases");
  const List* vary = document.root().list("Vary");
  if (cases != nullptr) {
    deck::Findings inside = findings.inside("Cases", cases);
    read_cases(*cases, variations, inside);
  }
  const std::size_t case_count = variations.size();
  if (vary != nullptr) {
    deck::Findings inside = findings.inside("Vary", vary);
    read_lists(*vary, variations, inside);
  }
  if (parameters.uncertainty) {
    if (cases != nullptr || vary != nullptr)
      findings.add("Uncertainty", "draws stand alone; admissible: neither Cases nor Vary");
    variations.push_back(draws_of(*parameters.uncertainty));
    parameters.plot.force_against_strain = false;  // bands tell more than a hundred curves
  }
  if (variations.empty() && findings.empty())
    findings.add("", "nothing is varied; give Cases, or Vary, or both; or Uncertainty");
  check_variations(variations, case_count, findings);
  findings.throw_if_any();  // what refers to the variations makes sense only now

  const auto compare = find_pairing(parameters.compare, "Compare", variations, findings);
  const auto gain = find_pairing(parameters.gain, "Gain", variations, findings);
  const auto pictured = find_members(parameters.plot.von_mises_members, variations, findings);
  findings.throw_if_any();
  return {
      std::move(document), std::move(parameters), std::move(variations), compare, gain, pictured};
}

}  // namespace stroma
