// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a law says of its parameters, once: L::declare(parameters) calls
///
///     parameters.number("C1 [Pa]", &L::c1, Range::any(), "Modulus of Ibar1.");
///     declare_bulk_modulus(parameters, &L::bulk_modulus);
///     parameters.volumetric_energy(&L::volumetric_energy);
///
/// and the deck's section, its reference and the reader follow. A header of a law needs no deck.

#include <limits>

#include "stroma/material/Law.hpp"

namespace stroma::material {

/// The admissible values of a number: strictly between two.
struct Range {
  double lower, upper;

  static constexpr Range positive() { return {0.0, std::numeric_limits<double>::infinity()}; }
  static constexpr Range any() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  constexpr bool operator==(const Range& other) const {
    return lower == other.lower && upper == other.upper;
  }
};

/// "Bulk Modulus [Pa]", in whose place Poisson's ratio may stand.
template <class Parameters, class Law>
void declare_bulk_modulus(Parameters& parameters, double Law::*member) {
  parameters.number_or_poisson_ratio(
      "Bulk Modulus [Pa]", member, Range::positive(), bulk_modulus,
      "Bulk modulus K = 2 mu (1 + nu) / (3 (1 - 2 nu)), mu of small strain.");
}

}  // namespace stroma::material
