// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Lists whose numbers must ascend.

#include <algorithm>
#include <string>
#include <vector>

#include "stroma/base/Log.hpp"
#include "stroma/deck/Section.hpp"

namespace stroma::sections {

/// Adds a finding for the first number that does not exceed the one before it.
inline void refuse_descending(const std::string& name, const std::vector<double>& numbers,
                              deck::Findings& findings) {
  const auto fallen = std::adjacent_find(numbers.begin(), numbers.end(),
                                         [](double a, double b) { return !(a < b); });
  if (fallen != numbers.end())
    findings.add(
        name, base::format("%g follows %g; admissible: ascending numbers", *(fallen + 1), *fallen));
}

}  // namespace stroma::sections
