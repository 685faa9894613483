// SPDX-License-Identifier: BSD-3-Clause

#include <Teuchos_ParameterList.hpp>

#include "stroma/deck/Declaration.hpp"
#include "stroma/deck/TeuchosValue.hpp"

namespace stroma::deck {
namespace {

void fill(Teuchos::ParameterList& list, const Declaration& section, const void* values) {
  for (const ParameterDeclaration& parameter : section.parameters) {
    const std::optional<Value> value = parameter.fetch(values);
    if (value) set_parameter(list, parameter.name, *value, parameter.type);
  }
  for (const SubsectionDeclaration& sub : section.sections) {
    const void* content = sub.look(values);
    if (content != nullptr) fill(list.sublist(sub.section->name), *sub.section, content);
  }
  if (section.named) {
    for (const auto& [name, content] : section.named->all(values)) {
      fill(list.sublist(name), *section.named->each, content);
    }
  }
  for (const FreeListDeclaration& free_list : section.free_lists) {
    const Teuchos::RCP<const Teuchos::ParameterList> content = free_list.fetch(values);
    if (Teuchos::nonnull(content)) list.sublist(free_list.name) = *content;
  }
}

}  // namespace

Teuchos::RCP<Teuchos::ParameterList> filled_from(const Declaration& root, const void* values) {
  const auto list = Teuchos::rcp(new Teuchos::ParameterList(root.name));
  fill(*list, root, values);
  return list;
}

}  // namespace stroma::deck
