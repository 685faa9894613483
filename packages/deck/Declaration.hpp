// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What Section<T> declares, with the type T forgotten: the reader, the reference and filled() walk
/// this. Pointers named `values` point to the struct T of the declaration they are handed to.

#include <Teuchos_RCP.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/deck/Admissible.hpp"
#include "stroma/deck/Findings.hpp"
#include "stroma/deck/Value.hpp"

namespace Teuchos {
class ParameterList;
}

namespace stroma::deck {

struct Declaration;

/// One parameter, bound to a member of the section's struct.
struct ParameterDeclaration {
  std::string name;
  ValueType type;
  bool required = false;
  Admissible admissible;
  std::string meaning;
  std::function<void(void* values, const Value& value)> store;
  std::function<std::optional<Value>(const void* values)> fetch;  ///< nothing: absent
};

/// A sublist with a fixed name, bound to a member that is a struct of its own.
struct SubsectionDeclaration {
  enum class Presence { defaulted, optional, required };

  std::shared_ptr<const Declaration> section;
  Presence presence = Presence::defaulted;
  std::function<void*(void* values)> open;              ///< the member, made if it was absent
  std::function<const void*(const void* values)> look;  ///< the member, or null if absent
};

/// Sublists whose names the user chooses.
struct NamedDeclaration {
  std::shared_ptr<const Declaration> each;
  int at_least = 1;
  std::function<void*(void* values, const std::string& name)> append;
  std::function<std::vector<std::pair<std::string, const void*>>(const void* values)> all;
};

/// A sublist that is passed on to a Trilinos package.
struct FreeListDeclaration {
  std::string name;
  std::string meaning;
  std::function<void(const Teuchos::ParameterList&, Findings&)> validate;
  std::function<void(void* values, const Teuchos::RCP<Teuchos::ParameterList>& list)> store;
  std::function<Teuchos::RCP<const Teuchos::ParameterList>(const void* values)> fetch;
};

/// One section. Either its sublists are named by the user, or everything in it is declared.
struct Declaration {
  std::string name;
  std::string meaning;
  std::vector<ParameterDeclaration> parameters;
  std::vector<SubsectionDeclaration> sections;
  std::vector<FreeListDeclaration> free_lists;
  std::optional<NamedDeclaration> named;
  std::vector<std::function<void(const void* values, Findings&)>> rules;
  /// What to tell of parameters that do not exist: how their names begin, and what stands for them.
  std::vector<std::pair<std::string, std::string>> substitutes;
  std::shared_ptr<const void> defaults;  ///< T{}

  /// \throws std::logic_error  the name is declared already: a mistake of the programmer
  void refuse_second(const std::string& new_name) const;
};

/// Reads the deck into the struct of its root.
/// \throws base::InputError with every mistake of the deck
void read_into(const Document& document, const Declaration& root, void* values);
Teuchos::RCP<Teuchos::ParameterList> filled_from(const Declaration& root, const void* values);
std::string reference_of(const Declaration& root, const std::string& section_path);

}  // namespace stroma::deck
