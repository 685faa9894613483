// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Vectors of which a deck means the direction only.

#include <array>
#include <optional>
#include <string>

#include "stroma/deck/Section.hpp"

namespace stroma::sections {

/// Adds a finding for a vector that has no direction.
inline void refuse_no_length(const std::string& name,
                             const std::optional<std::array<double, 3>>& direction,
                             deck::Findings& findings) {
  if (direction && *direction == std::array<double, 3>{})
    findings.add(name, "has no length; admissible: three numbers, not all 0");
}

}  // namespace stroma::sections
