// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/material/MaterialFields.hpp"

#include <algorithm>

namespace stroma::material {

double FieldParameters::at(double intensity) const {
  const auto above = std::upper_bound(intensities.begin(), intensities.end(), intensity);
  if (above == intensities.begin()) return values.front();
  if (above == intensities.end()) return values.back();
  const auto n = static_cast<std::size_t>(above - intensities.begin());
  const double share = (intensity - intensities[n - 1]) / (intensities[n] - intensities[n - 1]);
  return values[n - 1] + share * (values[n] - values[n - 1]);
}

}  // namespace stroma::material
