// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Vectors of a size whose squares neither vanish nor overflow.

#include <algorithm>
#include <array>
#include <cmath>

namespace stroma::tensor {

/// The vector times the power of two that brings its largest component to between 1 and 2, so that
/// nothing is rounded; zero stays what it is.
inline std::array<double, 3> of_unit_size(const std::array<double, 3>& v) {
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (largest == 0.0) return v;
  const int power = -std::ilogb(largest);
  return {std::scalbn(v[0], power), std::scalbn(v[1], power), std::scalbn(v[2], power)};
}

}  // namespace stroma::tensor
