// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The numbers of the laws that a deck may name: each declared once, whichever laws have it, and
/// held against the law that the deck names.

#include <map>
#include <string>
#include <vector>

#include "stroma/deck/Section.hpp"
#include "stroma/material/Models.hpp"

namespace stroma::sections {

/// One declaration of a number, or of a list of numbers.
struct SharedNumber {
  std::string name, models, meaning;
  material::Range admissible;
  bool is_list;
};

/// Of these models, in their order.
std::vector<SharedNumber> shared_numbers(const std::vector<const material::NamedNumbers*>& models);

template <class SomeModel>
std::vector<const material::NamedNumbers*> all_of(const std::vector<SomeModel>& models) {
  std::vector<const material::NamedNumbers*> all;
  for (const SomeModel& model : models) all.push_back(&model);
  return all;
}

/// Names and places, for a choice among the models.
std::vector<std::pair<std::string, int>> choices_among(
    const std::vector<const material::NamedNumbers*>& models);
/// "Name: meaning. Name: meaning".
std::string meanings_of(const std::vector<const material::NamedNumbers*>& models);

deck::Admissible admissible(const material::Range& range);

/// Looks for mistakes in the numbers given for a model.
/// \param model     the model
/// \param kind      what the deck calls it: "Model" or "Law"
/// \param numbers   given by the deck
/// \param lists     likewise
/// \param findings  mistakes are added to
/// \return whether all that the model asks for is there
bool check_numbers(const material::NamedNumbers& model, const std::string& kind,
                   const std::map<std::string, double>& numbers,
                   const std::map<std::string, std::vector<double>>& lists,
                   deck::Findings& findings);

}  // namespace stroma::sections
