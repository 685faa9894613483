// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A fit, read and checked before anything is run.

#include <string>
#include <vector>

#include "fit/FitDeck.hpp"
#include "fit/Measurement.hpp"
#include "fit/Sensitivity.hpp"
#include "run/Deck.hpp"
#include "stroma/base/Communicator.hpp"

namespace stroma {

/// A measured force, and where a run has it.
struct FitPoint {
  std::size_t measurement = 0;  ///< among those of the deck
  std::size_t reaction = 0;     ///< among FitPlan::reactions
  double load = 0.0;            ///< load factor
  MeasuredForce measured;
};

struct FitPlan {
  deck::Document document;
  FitParameters parameters;
  std::string base_deck;            ///< as it can be opened
  std::string title;                ///< of the fit
  std::string base_title;           ///< of its runs
  std::vector<Reaction> reactions;  ///< each once
  std::vector<FitPoint> points;     ///< by measurements, in the order of their rows
  std::vector<std::string> files;   ///< that it was read from
  std::string no_adjoint_because;   ///< empty: derivatives are the adjoint's

  bool has_adjoint() const { return no_adjoint_because.empty(); }
};

/// The numbers at the start.
std::vector<double> starts(const FitPlan& plan);

/// A run's deck: the base deck with numbers in place of those that are looked for.
/// \throws base::InputError when the deck cannot have them
Deck deck_with(const FitPlan& plan, const std::vector<double>& values);

/// The numbers as a run's name tells them: "vessel 1041.6, gel 520.8".
std::string name_of(const FitPlan& plan, const std::vector<double>& values);
/// The same as the name of its folder.
std::string folder_of(const FitPlan& plan, const std::vector<double>& values);

/// Reads the deck of a fit, its base deck and its measurements, and checks the run at the start as
/// `stroma check` does. Collective. \throws base::InputError with all mistakes
FitPlan plan_fit(const base::Communicator& communicator, const std::string& fit_deck);

}  // namespace stroma
