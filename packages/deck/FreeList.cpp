// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/deck/FreeList.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>

#include "stroma/deck/Nearest.hpp"
#include "stroma/deck/TeuchosValue.hpp"

namespace stroma::deck {
namespace {

void copy(const tree::List& section, Teuchos::ParameterList& list, Findings& findings) {
  for (const tree::Parameter& parameter : section.parameters) {
    if (parameter.broken || section.list(parameter.name) != nullptr) continue;
    ValueType type;
    const Interpretation read = interpret_freely(parameter, type);
    if (read.value) {
      set_parameter(list, parameter.name, *read.value, type);
    } else {
      findings.add(parameter.line, parameter.name, read.problem);
    }
  }
  for (const tree::List& sub : section.lists) {
    Findings inside = findings.inside(sub.name, &sub);
    copy(sub, list.sublist(sub.name), inside);
  }
}

std::string type_of(const Teuchos::ParameterEntry& entry) {
  if (entry.isList()) return "a section";
  const std::string name = entry.getAny(false).typeName();
  return name.find("basic_string") != std::string::npos ? "string" : name;
}

/// What the package's own validator says about a value of the right type; empty if it is content.
std::string refusal(const Teuchos::ParameterEntry& entry, const Teuchos::ParameterEntry& valid,
                    const std::string& name) {
  const Teuchos::RCP<const Teuchos::ParameterEntryValidator> validator = valid.validator();
  if (Teuchos::is_null(validator)) return "";
  try {
    validator->validate(entry, name, "");
    return "";
  } catch (const std::exception&) {  // its message is written for programmers
  }
  const auto choices = validator->validStringValues();
  const bool is_text = entry.isType<std::string>();
  const std::string found = is_text ? "\"" + Teuchos::getValue<std::string>(entry) + "\""
                                    : Teuchos::toString(entry.getAny(false));
  if (Teuchos::is_null(choices) || !is_text)
    return "found " + found + "; this value is not admissible";
  const std::vector<std::string> known(choices->begin(), choices->end());
  return "found " + found + "; " + suggestion(Teuchos::getValue<std::string>(entry), known);
}

}  // namespace

Teuchos::RCP<Teuchos::ParameterList> to_teuchos(const tree::List& section, Findings& findings) {
  const auto list = Teuchos::rcp(new Teuchos::ParameterList(section.name));
  copy(section, *list, findings);
  return list;
}

void refuse_unknown(const Teuchos::ParameterList& list, const Teuchos::ParameterList& valid,
                    Findings& findings) {
  std::vector<std::string> known;
  for (auto entry = valid.begin(); entry != valid.end(); ++entry)
    known.push_back(valid.name(entry));

  for (auto entry = list.begin(); entry != list.end(); ++entry) {
    const std::string& name = list.name(entry);
    const Teuchos::ParameterEntry& given = list.entry(entry);
    const Teuchos::ParameterEntry* allowed = valid.getEntryPtr(name);
    if (allowed == nullptr) {
      findings.add(name, std::string("no such ") + (given.isList() ? "section" : "parameter") +
                             "; " + suggestion(name, known));
    } else if (given.isList() && allowed->isList()) {
      if (valid.sublist(name).numParams() == 0) continue;
      Findings inside = findings.below(name);
      refuse_unknown(list.sublist(name), valid.sublist(name), inside);
    } else if (type_of(given) != type_of(*allowed) && Teuchos::is_null(allowed->validator())) {
      findings.add(name, "is of type " + type_of(given) + "; admissible: " + type_of(*allowed));
    } else {
      const std::string problem = refusal(given, *allowed, name);
      if (!problem.empty()) findings.add(name, problem);
    }
  }
}

}  // namespace stroma::deck
