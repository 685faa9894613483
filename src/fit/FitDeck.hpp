// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The deck of a fit: a base deck, the numbers of it that are looked for, and what was measured.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/deck/Document.hpp"
#include "stroma/deck/Section.hpp"

namespace stroma {

/// A number of the base deck that is looked for.
struct FittedParameters {
  std::string path;  ///< Section|Parameter
  double start = 0.0;
  std::optional<double> lower, upper;
  bool logarithmic = false;
};

/// What stands beside a force in a table of measurements.
enum class Against { strain, time };

/// A table of measured forces.
struct MeasurementParameters {
  std::string file;
  Against against = Against::strain;
  std::string abscissa_column, force_column;
  double force_unit = 1.0;  ///< [pN]
  std::string condition;
  int component = 1;                        ///< 0, 1, 2 for x, y, z
  std::optional<std::string> error_column;  ///< in the column's unit of force
  std::optional<double> error;              ///< likewise
  std::optional<double> relative_error;
};

/// How derivatives of the forces are had.
enum class Gradient { automatic, adjoint, differences };

struct FittedList {
  std::vector<std::pair<std::string, FittedParameters>> all;  ///< by the user's names
};

struct MeasurementList {
  std::vector<std::pair<std::string, MeasurementParameters>> all;  ///< by the user's names
};

struct FitParameters {
  std::string title;
  std::string base_deck;
  FittedList parameters;
  MeasurementList measurements;
  Gradient gradient = Gradient::automatic;
  double tolerance = 1e-6;  ///< relative change of the parameters
  int most_steps = 30;
};

/// Everything the deck of a fit may say.
deck::Section<FitParameters> fit_section();

}  // namespace stroma
