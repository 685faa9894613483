// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Declares what a deck may say, once: name, type, default, admissible values, meaning, and the
/// member of a plain struct that receives it. Reader, error messages and reference follow from the
/// declaration.

#include <Teuchos_RCP.hpp>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/deck/Declaration.hpp"

namespace stroma::deck {

/// A member of a base of T as a member of T: what a Section<T> binds.
template <class T, class Base, class V>
constexpr V T::*inherited(V Base::*member) {
  return member;
}

/// One section of the deck, bound to the members of a plain struct T. The default of an optional
/// parameter is the value of that member in T{}; a std::optional member is absent by default.
///
/// A member's type V may be bool, int, std::int64_t, double, std::string, std::vector or std::array
/// of int, std::int64_t, double or std::string, std::variant of such an array and a std::string (a
/// list, or a word in its place), or std::optional of one of these. Physical units stand in the
/// parameter's name.
///
///     struct Grid { std::array<double, 3> element_size; bool reset = false; };
///     Section<Grid> section("Grid", "The background grid.");
///     section.required("Element Size [um]", &Grid::element_size, positive(), "Sides: x, y, z.")
///         .optional("Reset", &Grid::reset, any(), "Return to the Cartesian grid after a step.");
///
/// Declaring a name twice throws std::logic_error.
template <class T>
class Section {
 public:
  Section(std::string name, std::string meaning) {
    declaration_.name = std::move(name);
    declaration_.meaning = std::move(meaning);
    declaration_.defaults = std::make_shared<const T>();
  }

  template <class V>
  Section& required(std::string name, V T::*member, Admissible admissible, std::string meaning) {
    return parameter(std::move(name), member, std::move(admissible), std::move(meaning), true);
  }
  template <class V>
  Section& optional(std::string name, V T::*member, Admissible admissible, std::string meaning) {
    return parameter(std::move(name), member, std::move(admissible), std::move(meaning), false);
  }

  /// A parameter that is kept under its name in a map, where the deck gives it.
  template <class V>
  Section& optional(const std::string& name, std::map<std::string, V> T::*member,
                    Admissible admissible, std::string meaning) {
    refuse_second(name);
    ParameterDeclaration entry;
    entry.name = name;
    entry.type = detail::value_type<V>();
    entry.admissible = std::move(admissible);
    entry.meaning = std::move(meaning);
    entry.store = [member, name](void* values, const Value& value) {
      (of(values).*member)[name] = detail::from_value<V>(value);
    };
    entry.fetch = [member, name](const void* values) -> std::optional<Value> {
      const std::map<std::string, V>& given = of(values).*member;
      const auto found = given.find(name);
      if (found == given.end()) return std::nullopt;
      return detail::to_value(found->second);
    };
    declaration_.parameters.push_back(std::move(entry));
    return *this;
  }

  /// A string in the deck, a value of an enum E in the struct.
  template <class M>
  Section& choice(std::string name, M T::*member,
                  std::vector<std::pair<std::string, detail::without_optional<M>>> choices,
                  std::string meaning) {
    return choose(std::move(name), member, std::move(choices), std::move(meaning), false);
  }
  template <class M>
  Section& required_choice(std::string name, M T::*member,
                           std::vector<std::pair<std::string, detail::without_optional<M>>> choices,
                           std::string meaning) {
    return choose(std::move(name), member, std::move(choices), std::move(meaning), true);
  }

  /// A sublist that may be left out: its defaults hold then, and what it requires is still
  /// required.
  template <class S>
  Section& section(const Section<S>& sub, S T::*member) {
    return subsection(sub, member, SubsectionDeclaration::Presence::defaulted);
  }
  /// A sublist whose absence means something.
  template <class S>
  Section& section(const Section<S>& sub, std::optional<S> T::*member) {
    refuse_second(sub.declaration().name);
    SubsectionDeclaration entry;
    entry.section = std::make_shared<const Declaration>(sub.declaration());
    entry.presence = SubsectionDeclaration::Presence::optional;
    entry.open = [member](void* values) -> void* { return &(of(values).*member).emplace(); };
    entry.look = [member](const void* values) -> const void* {
      const std::optional<S>& content = of(values).*member;
      return content ? &*content : nullptr;
    };
    declaration_.sections.push_back(std::move(entry));
    return *this;
  }
  /// A sublist that must be there.
  template <class S>
  Section& required_section(const Section<S>& sub, S T::*member) {
    return subsection(sub, member, SubsectionDeclaration::Presence::required);
  }

  /// The whole section consists of sublists that the user names, kept in the order of the deck.
  /// Names are unique, not empty, one line of at most 200 bytes, and hold no comma and no '|'.
  template <class S>
  Section& named_sections(const Section<S>& each_of_them,
                          std::vector<std::pair<std::string, S>> T::*member, int at_least = 1) {
    NamedDeclaration entry;
    entry.each = std::make_shared<const Declaration>(each_of_them.declaration());
    entry.at_least = at_least;
    entry.append = [member](void* values, const std::string& name) -> void* {
      return &(of(values).*member).emplace_back(name, S{}).second;
    };
    entry.all = [member](const void* values) {
      std::vector<std::pair<std::string, const void*>> all;
      for (const auto& [name, content] : of(values).*member) all.emplace_back(name, &content);
      return all;
    };
    declaration_.named = std::move(entry);
    return *this;
  }

  /// A sublist that is passed on to a Trilinos package, with any nesting; null when it is absent.
  /// \param name      of the sublist
  /// \param member    where the list goes
  /// \param meaning   for the reference
  /// \param validate  looks for mistakes; refuse_unknown() of FreeList.hpp does it by a list of
  /// what is valid
  Section& free_list(std::string name, Teuchos::RCP<Teuchos::ParameterList> T::*member,
                     std::string meaning,
                     std::function<void(const Teuchos::ParameterList&, Findings&)> validate = {}) {
    refuse_second(name);
    FreeListDeclaration entry;
    entry.name = std::move(name);
    entry.meaning = std::move(meaning);
    entry.validate = std::move(validate);
    entry.store = [member](void* values, const Teuchos::RCP<Teuchos::ParameterList>& list) {
      of(values).*member = list;
    };
    entry.fetch = [member](const void* values) -> Teuchos::RCP<const Teuchos::ParameterList> {
      return of(values).*member;
    };
    declaration_.free_lists.push_back(std::move(entry));
    return *this;
  }

  /// A parameter of other programs that does not exist here.
  /// \param begins   how its name begins
  /// \param instead  what stands for it
  Section& substitute(std::string begins, std::string instead) {
    declaration_.substitutes.emplace_back(std::move(begins), std::move(instead));
    return *this;
  }

  /// A rule between several parameters. It runs only if everything inside the section was read.
  Section& check(std::function<void(const T&, Findings&)> rule) {
    declaration_.rules.push_back([rule = std::move(rule)](const void* values, Findings& findings) {
      rule(of(values), findings);
    });
    return *this;
  }

  const Declaration& declaration() const { return declaration_; }

 private:
  static T& of(void* values) { return *static_cast<T*>(values); }
  static const T& of(const void* values) { return *static_cast<const T*>(values); }

  void refuse_second(const std::string& name) const { declaration_.refuse_second(name); }

  /// Binds a member, or the content of a member that is a std::optional, through a pair of
  /// conversions.
  template <class M, class ToValue, class FromValue>
  void bind(ParameterDeclaration& entry, M T::*member, ToValue to_value, FromValue from_value) {
    entry.store = [member, from_value = std::move(from_value)](void* values, const Value& value) {
      of(values).*member = from_value(value);
    };
    entry.fetch = [member,
                   to_value = std::move(to_value)](const void* values) -> std::optional<Value> {
      const M& content = of(values).*member;
      if constexpr (detail::is_optional<M>::value) {
        if (!content) return std::nullopt;
        return to_value(*content);
      } else {
        return to_value(content);
      }
    };
  }

  template <class M>
  Section& parameter(std::string name, M T::*member, Admissible admissible, std::string meaning,
                     bool required) {
    refuse_second(name);
    using V = detail::without_optional<M>;
    ParameterDeclaration entry;
    entry.name = std::move(name);
    entry.type = detail::value_type<V>();
    entry.required = required;
    entry.admissible = std::move(admissible);
    entry.meaning = std::move(meaning);
    bind(entry, member, detail::to_value<V>, detail::from_value<V>);
    declaration_.parameters.push_back(std::move(entry));
    return *this;
  }

  template <class M>
  Section& choose(std::string name, M T::*member,
                  std::vector<std::pair<std::string, detail::without_optional<M>>> choices,
                  std::string meaning, bool required) {
    refuse_second(name);
    using E = detail::without_optional<M>;
    ParameterDeclaration entry;
    entry.name = std::move(name);
    entry.required = required;
    std::vector<std::string> words;
    for (const auto& [word, value] : choices) words.push_back(word);
    entry.admissible = one_of(std::move(words));
    entry.meaning = std::move(meaning);
    const auto to_value = [choices](const E& chosen) -> Value {
      for (const auto& [word, value] : choices) {
        if (value == chosen) return word;
      }
      return std::string();
    };
    const auto from_value = [choices = std::move(choices)](const Value& chosen) -> E {
      for (const auto& [word, value] : choices) {
        if (word == std::get<std::string>(chosen)) return value;
      }
      return E{};
    };
    bind(entry, member, to_value, from_value);
    declaration_.parameters.push_back(std::move(entry));
    return *this;
  }

  template <class S>
  Section& subsection(const Section<S>& sub, S T::*member,
                      SubsectionDeclaration::Presence presence) {
    refuse_second(sub.declaration().name);
    SubsectionDeclaration entry;
    entry.section = std::make_shared<const Declaration>(sub.declaration());
    entry.presence = presence;
    entry.open = [member](void* values) -> void* { return &(of(values).*member); };
    entry.look = [member](const void* values) -> const void* { return &(of(values).*member); };
    declaration_.sections.push_back(std::move(entry));
    return *this;
  }

  Declaration declaration_;
};

/// Fills the struct of the root section from a deck.
/// \throws base::InputError  with every mistake of the deck, ordered by line, as in
///
///     2 mistakes in gel.xml
///     line 14, Materials|collagen|Shear Modulus [Pa]: "soft" is not a number; admissible: a number > 0
///     line 21, Grid|Element Sise [um]: no such parameter; did you mean "Element Size [um]"?
template <class T>
T read(const Document& document, const Section<T>& root) {
  T values{};
  read_into(document, root.declaration(), &values);
  return values;
}

/// The deck that gives these values, with every default written out.
/// Teuchos::writeParameterListToXmlFile makes a deck of it that load() and read() turn into the
/// same values, to the last digit.
template <class T>
Teuchos::RCP<Teuchos::ParameterList> filled(const Section<T>& root, const T& values) {
  return filled_from(root.declaration(), &values);
}

/// The deck reference, in Markdown: every section, parameter, type, default, admissible values,
/// meaning.
/// \param root          the section of the whole deck
/// \param section_path  'Image|Segmentation'; empty for the whole deck
/// \throws base::InputError  no such section; the message names the nearest
template <class T>
std::string reference(const Section<T>& root, const std::string& section_path = "") {
  return reference_of(root.declaration(), section_path);
}

}  // namespace stroma::deck
