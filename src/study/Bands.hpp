// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Bands that hold most of the draws, and where their width comes from.

#include <optional>
#include <string>
#include <vector>

#include "study/ForceDeparture.hpp"

namespace stroma {

/// What 5, 50 and 95 % of the draws stay below.
struct Band {
  double low = 0.0, median = 0.0, high = 0.0;
};

/// Quantiles of some values, linear between neighbours (R's type 7). \param values  at least one;
/// they are sorted
Band band_of(std::vector<double>& values);

/// Spearman's correlation of ranks; equal values share the mean of theirs. Nothing where all values
/// of one are equal, or there are fewer than three.
std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

/// The force of the draws at each load factor.
std::vector<Band> force_bands(const std::vector<ForceRecord>& draws,
                              const std::vector<double>& loads);

}  // namespace stroma
