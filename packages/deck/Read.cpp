// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <stdexcept>

#include "stroma/deck/Declaration.hpp"
#include "stroma/deck/FreeList.hpp"
#include "stroma/deck/Nearest.hpp"
#include "stroma/deck/PlainText.hpp"

namespace stroma::deck {
namespace {

using Presence = SubsectionDeclaration::Presence;

std::vector<std::string> parameter_names(const Declaration& section) {
  std::vector<std::string> names;
  for (const ParameterDeclaration& parameter : section.parameters) names.push_back(parameter.name);
  return names;
}

std::vector<std::string> section_names(const Declaration& section) {
  std::vector<std::string> names;
  for (const SubsectionDeclaration& sub : section.sections) names.push_back(sub.section->name);
  for (const FreeListDeclaration& list : section.free_lists) names.push_back(list.name);
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Path of the first section that declares a parameter of this name; empty if none does.
std::string home_of(const std::string& parameter, const Declaration& section,
                    const std::string& path) {
  if (!path.empty() && contains(parameter_names(section), parameter)) return path;
  const auto below = [&](const Declaration& sub, const std::string& name) {
    return home_of(parameter, sub, path.empty() ? name : path + "|" + name);
  };
  for (const SubsectionDeclaration& sub : section.sections) {
    const std::string home = below(*sub.section, sub.section->name);
    if (!home.empty()) return home;
  }
  return section.named ? below(*section.named->each, "NAME") : "";
}

/// Walks declaration and deck together.
class Reader {
 public:
  explicit Reader(const Declaration& root) : root_(root) {}

  /// Fills `values` from a section of the deck (null: left out, its defaults hold).
  /// \return  nothing was wrong with it
  bool read(const tree::List* list, const Declaration& section, void* values,
            Findings& findings) const {
    const std::size_t before = findings.size();
    bool is_clean = true;
    for (const ParameterDeclaration& parameter : section.parameters) {
      is_clean = read_parameter(list, parameter, values, findings) && is_clean;
    }
    for (const SubsectionDeclaration& sub : section.sections) {
      is_clean = read_subsection(list, sub, values, findings) && is_clean;
    }
    for (const FreeListDeclaration& free_list : section.free_lists) {
      read_free_list(list, free_list, values, findings);
    }
    if (section.named) is_clean = read_named(list, section, values, findings) && is_clean;
    if (list != nullptr) refuse_unknown_names(*list, section, findings);

    is_clean = is_clean && findings.size() == before;
    if (!is_clean) return false;
    for (const auto& rule : section.rules) rule(values, findings);
    return findings.size() == before;
  }

 private:
  bool read_parameter(const tree::List* list, const ParameterDeclaration& parameter, void* values,
                      Findings& findings) const {
    const std::string admissible = "; admissible: " + parameter.admissible.describe(parameter.type);
    const tree::Parameter* given = list != nullptr ? list->parameter(parameter.name) : nullptr;
    if (given == nullptr) {
      if (list != nullptr && list->list(parameter.name) != nullptr) {
        const std::string advice =
            parameter.type.is_array ? " (in YAML a list is written [a, b])" : "";
        findings.add(parameter.name, "is a parameter, not a section" + advice + admissible);
      } else if (parameter.required) {
        findings.add(findings.line(), parameter.name, "required, but missing" + admissible);
      }
      return true;  // what is wrong has been counted
    }
    if (given->broken) return false;
    const Interpretation read = interpret(*given, parameter.type);
    if (!read.value) {
      findings.add(given->line, parameter.name, read.problem + admissible);
    } else if (!parameter.admissible.allows(*read.value)) {
      findings.add(
          given->line, parameter.name,
          "found " + print(*read.value) + admissible + guess(*read.value, parameter.admissible));
    } else {
      parameter.store(values, *read.value);
    }
    return true;
  }

  static std::string guess(const Value& value, const Admissible& admissible) {
    const std::string* word = std::get_if<std::string>(&value);
    const std::string meant = word != nullptr ? nearest(*word, admissible.choices()) : "";
    return meant.empty() ? "" : "; did you mean \"" + meant + "\"?";
  }

  bool read_subsection(const tree::List* list, const SubsectionDeclaration& sub, void* values,
                       Findings& findings) const {
    const std::string& name = sub.section->name;
    const tree::List* given = list != nullptr ? list->list(name) : nullptr;
    if (given == nullptr && list != nullptr && list->parameter(name) != nullptr) {
      return true;  // refuse_unknown_names() speaks of it
    }
    if (given == nullptr && sub.presence == Presence::optional) return true;
    if (given == nullptr && sub.presence == Presence::required) {
      findings.add(findings.line(), name, "this section is required, but missing");
      return true;
    }
    Findings inside = findings.inside(name, given);
    return read(given, *sub.section, sub.open(values), inside);
  }

  static void read_free_list(const tree::List* list, const FreeListDeclaration& free_list,
                             void* values, Findings& findings) {
    const tree::List* given = list != nullptr ? list->list(free_list.name) : nullptr;
    if (given == nullptr) return;
    Findings inside = findings.inside(free_list.name, given);
    const std::size_t before = findings.size();
    const auto content = to_teuchos(*given, inside);
    if (findings.size() == before && free_list.validate) free_list.validate(*content, inside);
    free_list.store(values, content);
  }

  bool read_named(const tree::List* list, const Declaration& section, void* values,
                  Findings& findings) const {
    const NamedDeclaration& named = *section.named;
    const std::vector<std::string> declared = section_names(section);
    std::vector<std::string> in_file;
    std::vector<std::string> seen;
    bool is_clean = true;
    if (list != nullptr) {
      for (const tree::List& given : list->lists) {
        if (given.line != not_in_file) in_file.push_back(given.name);
      }
      for (const tree::List& given : list->lists) {
        if (contains(declared, given.name) || contains(seen, given.name)) continue;
        seen.push_back(given.name);
        if (given.line == not_in_file) {
          findings.add(given.line, given.name,
                       "no such section in the deck; " + suggestion(given.name, in_file));
          continue;
        }
        refuse_bad_name(given, findings);
        Findings inside = findings.inside(given.name, &given);
        is_clean = read(&given, *named.each, named.append(values, given.name), inside) && is_clean;
      }
    }
    if (static_cast<int>(seen.size()) < named.at_least) {
      findings.add(
          findings.line(), "",
          "needs at least " + std::to_string(named.at_least) +
              (named.at_least == 1 ? " sublist, named by you" : " sublists, named by you"));
    }
    return is_clean;
  }

  static void refuse_bad_name(const tree::List& given, Findings& findings) {
    if (!unwritable(given.name).empty()) return;  // that has been told
    const auto is_bad = [](char letter) { return letter == ',' || letter == '|'; };
    if (std::any_of(given.name.begin(), given.name.end(), is_bad)) {
      findings.add(given.line, "",
                   "the name \"" + given.name + "\" holds a comma or a '|'; it appears in tables");
    } else if (given.name.size() > longest_name) {
      findings.add(given.line, "",
                   "the name \"" + given.name.substr(0, 20) + "...\" has " +
                       std::to_string(given.name.size()) + " bytes; admissible: at most " +
                       std::to_string(longest_name) +
                       ", for it appears in tables and result files");
    }
  }

  void refuse_unknown_names(const tree::List& list, const Declaration& section,
                            Findings& findings) const {
    const std::vector<std::string> parameters = parameter_names(section);
    const std::vector<std::string> sections = section_names(section);
    for (const tree::Parameter& given : list.parameters) {
      if (contains(parameters, given.name)) continue;
      if (contains(sections, given.name)) {
        const bool is_empty = given.form == tree::Form::nothing;
        findings.add(given.line, given.name,
                     std::string("is a section, not a parameter") +
                         (is_empty ? "; an empty one is written {}" : ""));
      } else if (section.named && parameters.empty()) {
        findings.add(given.line, given.name,
                     "no such parameter; this section holds sublists only, named by you");
      } else {
        findings.add(given.line, given.name, "no such parameter; " + advice(given.name, section));
      }
    }
    for (const tree::List& given : list.lists) {
      if (section.named || contains(sections, given.name) || contains(parameters, given.name))
        continue;
      findings.add(given.line, given.name, "no such section; " + suggestion(given.name, sections));
    }
  }

  /// What stands for it, the nearest name of this section, or the section that the name belongs to.
  std::string advice(const std::string& name, const Declaration& section) const {
    for (const auto& [begins, instead] : section.substitutes)
      if (name.compare(0, begins.size(), begins) == 0) return instead;
    const std::vector<std::string> known = parameter_names(section);
    if (!nearest(name, known).empty()) return suggestion(name, known);
    const std::string home = home_of(name, root_, "");
    return home.empty() ? suggestion(name, known) : "it belongs in " + home;
  }

  const Declaration& root_;
};

}  // namespace

void Declaration::refuse_second(const std::string& new_name) const {
  if (contains(parameter_names(*this), new_name) || contains(section_names(*this), new_name)) {
    throw std::logic_error("section '" + name + "' declares '" + new_name + "' twice");
  }
}

void read_into(const Document& document, const Declaration& root, void* values) {
  Findings findings(document);
  findings.add(document.mistakes());
  if (document.root().name != root.name) {
    findings.add(document.root().line, "",
                 "the outer list is named \"" + document.root().name + "\"; its name must be \"" +
                     root.name + "\"");
  }
  Reader(root).read(&document.root(), root, values, findings);
  findings.throw_if_any();
}

}  // namespace stroma::deck
