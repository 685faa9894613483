// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What is said of a body that is refused.

#include <string>

#include "stroma/base/Error.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma::mechanics {

/// Empty for a body that is taken.
inline std::string refusal(const test::Specimen& specimen) {
  try {
    specimen.balance(world());
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace stroma::mechanics
