// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck of a study: a base deck, and what its members change in it.

#include <Teuchos_RCP.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stroma/deck/Document.hpp"
#include "stroma/deck/Section.hpp"
#include "study/Draws.hpp"

namespace stroma {

struct StudyPlotParameters {
  bool force_against_strain = true;
  bool force_against_element_size = true;
  std::string support;  ///< empty: the first that moves
  std::vector<std::string> von_mises_members;
};

/// What members are held against: those with one alternative of one of the things that vary.
struct PairingParameters {
  std::string thing;
  std::string reference;
};

struct StudyParameters {
  std::string title;
  std::string base_deck;
  Teuchos::RCP<Teuchos::ParameterList> cases, vary;
  std::vector<std::string> also_tabulate;
  std::optional<PairingParameters> compare, gain;
  std::optional<UncertaintyParameters> uncertainty;
  StudyPlotParameters plot;
};

/// Everything a study deck may say.
deck::Section<StudyParameters> study_section();

/// A parameter of the base deck and the text that a member gives it.
struct Setting {
  std::string parameter;  ///< Section|Parameter
  std::string value;
};

/// One of the alternatives of a variation.
struct Choice {
  std::string value;  ///< as in the table: a case's name, or a parameter's value
  std::string label;  ///< as in a legend: a case's name, or "Shear Modulus 520.8 Pa"
  std::vector<Setting> settings;
};

/// What is varied: the cases of one name, or the values of one parameter.
struct Variation {
  std::string name;  ///< heads its column: the name of the cases, or Section|Parameter
  std::vector<Choice> choices;
};

/// PairingParameters, found among the variations.
struct Pairing {
  std::size_t variation = 0;
  std::string label;  ///< of the reference's Choice
};

struct Study {
  deck::Document document;
  StudyParameters parameters;
  std::vector<Variation> variations;  ///< Cases in the order of the deck, then Vary; or draws alone
  std::optional<Pairing> compare, gain;
  std::vector<std::size_t> von_mises_members;  ///< indices into members_of(variations)
};

/// Reads and checks a study deck, but for what only the base deck can tell.
/// \throws base::InputError with every mistake
Study read_study(const std::string& path);

}  // namespace stroma
