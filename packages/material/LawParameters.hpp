// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a law says of its parameters, once: L::declare(parameters) calls
///
///     parameters.number("C1 [Pa]", &L::c1, Range::any(), "Modulus of Ibar1.");
///     parameters.bulk_modulus(&L::bulk_modulus);
///     parameters.volumetric_energy(&L::volumetric_energy);
///
/// and the deck's section, its reference and the reader follow. A header of a law needs no deck.

#include <limits>

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

}  // namespace stroma::material
