// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The numbers of a law one by one, as far as it declares them.

#include "stroma/material/LawParameters.hpp"

namespace stroma::material {

/// Which number of a material's law.
struct NumberName {
  static constexpr int none = -1;

  const char* name;   ///< as the law declares it, "C1 [Pa]"
  int family = none;  ///< of fibres, whose it is
  int entry = none;   ///< of a list, or an axis of a direction, from 0
};

namespace detail {

/// L::declare() with the numbers of a law.
template <class Law, class Visit>
class VisitNumbers {
 public:
  VisitNumbers(Law& law, const Visit& visit) : law_(law), visit_(visit) {}

  void number(const char* name, double Law::*member, Range, const char*) {
    visit_(NumberName{name}, law_.*member);
  }
  template <int n>
  void numbers(const char* name, double (Law::*member)[n], int Law::*, Range, const char*) {
    for (int k = 0; k < n; ++k) visit_(NumberName{name, NumberName::none, k}, (law_.*member)[k]);
  }
  template <class Convert>
  void number_or_poisson_ratio(const char* name, double Law::*member, Range, const Convert&,
                               const char*) {
    visit_(NumberName{name}, law_.*member);
  }
  template <int n>
  void directions(double (Law::*member)[n][3], int Law::*count) {
    for (int family = 0; family < law_.*count; ++family)
      for (int d = 0; d < 3; ++d)
        visit_(NumberName{"Direction", family, d}, (law_.*member)[family][d]);
  }
  void volumetric_energy(VolumetricEnergy Law::*) {}

 private:
  Law& law_;
  const Visit& visit_;
};

}  // namespace detail

/// visit(NumberName, double&) for each number of a law that L::declare() names, in its order; of
/// lists all that there is room for.
template <class Law, class Visit>
void for_each_number(Law& law, const Visit& visit) {
  detail::VisitNumbers<Law, Visit> numbers(law, visit);
  Law::declare(numbers);
}

}  // namespace stroma::material
