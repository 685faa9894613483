// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a law says of its parameters, once: L::declare(parameters) calls
///
///     parameters.number("C1 [Pa]", &L::c1, Range::any(), "Modulus of Ibar1.");
///     declare_bulk_modulus(parameters, &L::bulk_modulus);
///     parameters.volumetric_energy(&L::volumetric_energy);
///
/// or, of a list, parameters.numbers("C [Pa]", &L::c, &L::terms, Range::any(), "Moduli."), with
/// double c[n] and int terms; lists of a law have the same length; or, of directions of fibres,
/// parameters.directions(&L::direction, &L::families), double direction[n][3]. The deck's section, its reference and the reader follow. A header of a law needs no deck.

#include <limits>

#include "stroma/material/Law.hpp"

namespace stroma::material {

/// The admissible values of a number: between two, themselves included if it is closed.
struct Range {
  double lower, upper;
  bool is_closed = false;
  bool has_zero = true;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr Range any() { return {-infinity, infinity}; }
  static constexpr Range not_zero() { return {-infinity, infinity, false, false}; }
  static constexpr Range above(double bound) { return {bound, infinity}; }
  static constexpr Range positive() { return above(0.0); }
  static constexpr Range at_least(double bound) { return {bound, infinity, true}; }
  static constexpr Range between(double low, double high) { return {low, high, true}; }
  constexpr bool operator==(const Range& other) const {
    return lower == other.lower && upper == other.upper && is_closed == other.is_closed &&
           has_zero == other.has_zero;
  }
};

/// "Bulk Modulus [Pa]", in whose place Poisson's ratio may stand.
template <class Parameters, class Law>
void declare_bulk_modulus(Parameters& parameters, double Law::*member) {
  parameters.number_or_poisson_ratio(
      "Bulk Modulus [Pa]", member, Range::positive(), bulk_modulus,
      "Bulk modulus K = 2 mu (1 + nu) / (3 (1 - 2 nu)), mu of small strain.");
}

/// "Lame Modulus [Pa]", in whose place Poisson's ratio may stand.
template <class Parameters, class Law>
void declare_lame_modulus(Parameters& parameters, double Law::*member) {
  parameters.number_or_poisson_ratio(
      "Lame Modulus [Pa]", member, Range::any(),
      [](double mu, double nu) { return 2.0 * mu * nu / (1.0 - 2.0 * nu); },
      "Lame's modulus lambda = 2 mu nu / (1 - 2 nu).");
}

}  // namespace stroma::material
