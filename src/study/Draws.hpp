// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Inputs of a study that are known by a distribution, and draws of them.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/deck/Section.hpp"

namespace stroma {

enum class Distribution { uniform, normal, log_normal };

/// A parameter of the base deck that is not known for certain.
struct InputParameters {
  std::string path;  ///< Section|Parameter
  Distribution distribution = Distribution::uniform;
  std::optional<std::array<double, 2>> range;        ///< of uniform
  std::optional<double> mean, standard_deviation;    ///< of normal
  std::optional<double> median, relative_deviation;  ///< of log-normal
};

struct InputList {
  std::vector<std::pair<std::string, InputParameters>> all;  ///< by the user's names
};

struct UncertaintyParameters {
  int draws = 100;
  int seed = 1;
  InputList inputs;
  std::optional<std::array<double, 3>> finer;  ///< elements of a second grid [um]
  bool stress_bands = true;
};

/// What a study deck may say of uncertainty.
deck::Section<UncertaintyParameters> uncertainty_section();

/// The value below which an input lies with a probability u, 0 < u < 1: of uniform a + u (b - a); of
/// normal mean + z(u) standard deviation; of log-normal median exp(z(u) relative deviation), with z
/// the standard normal's.
double quantile(const InputParameters& input, double u);

/// A Latin hypercube: (draw)(input). Of n draws, each input has one in each n-th of its probability,
/// at a place drawn within it; which goes with which is drawn. The same numbers for the same seed
/// on any machine. (McKay, Beckman and Conover, Technometrics 21, 1979.)
std::vector<std::vector<double>> latin_hypercube(const UncertaintyParameters& uncertainty);

/// What a user should know of the draws before they run: inputs that happen to follow each other
/// (rank correlation above 0.3), for then the effect of one cannot be told from the other's.
std::vector<std::string> draw_notes(const UncertaintyParameters& uncertainty);

}  // namespace stroma
