// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What results need to know of a deck's conditions and materials.

#include <array>
#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/output/pictures/Pictures.hpp"

namespace stroma {

/// The boundary conditions that move, in the order of the deck: those whose reaction is plotted.
/// \param length  edges of the body's box [um]
std::vector<output::MovingSupport> moving_supports(const DeckParameters& parameters,
                                                   const std::array<double, 3>& length);

/// Strain of the body at a load factor of 1 between the face of a condition with Strain and the opposite
/// one: the sum of both conditions' Strain, where the opposite face has one that grows likewise. 0 where
/// it is not known: without Strain, or when the opposite face moves along the axis by other values.
double strain_between_faces(const DeckParameters& parameters,
                            const mechanics::BoundaryCondition& condition);

/// What the columns of history.csv are named after.
output::HistoryNames history_names(const DeckParameters& parameters);

/// The pressure of each material that is one, at a load factor, by its load curve [Pa].
std::vector<double> pressures_at(const DeckParameters& parameters, double load);

/// The names of a list of named things.
template <class Named>
std::vector<std::string> names(const Named& list) {
  std::vector<std::string> result;
  for (const auto& entry : list) result.push_back(entry.first);
  return result;
}

}  // namespace stroma
