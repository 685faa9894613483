// SPDX-License-Identifier: BSD-3-Clause

#include "study/Richardson.hpp"

#include <algorithm>
#include <cmath>

namespace stroma {
namespace {

/// The finest three with a constant ratio, coarsest first. The list is ordered, finest first.
std::optional<std::array<SizedFigure, 3>> finest_triple(const std::vector<SizedFigure>& figures) {
  for (std::size_t fine = 0; fine < figures.size(); ++fine) {
    for (std::size_t middle = fine + 1; middle < figures.size(); ++middle) {
      const double wanted = figures[middle].size * figures[middle].size / figures[fine].size;
      for (std::size_t coarse = middle + 1; coarse < figures.size(); ++coarse) {
        if (std::abs(figures[coarse].size - wanted) <= 1e-6 * wanted)
          return {{figures[coarse], figures[middle], figures[fine]}};
      }
    }
  }
  return std::nullopt;
}

}  // namespace

RichardsonResult richardson(std::vector<SizedFigure> figures, double noise) {
  std::sort(figures.begin(), figures.end(),
            [](const SizedFigure& a, const SizedFigure& b) { return a.size < b.size; });
  if (figures.size() < 3) return {std::nullopt, "it takes three sizes"};
  const auto triple = finest_triple(figures);
  if (!triple) return {std::nullopt, "no three sizes have a constant ratio"};

  const auto& [coarse, middle, fine] = *triple;
  const double first = coarse.figure - middle.figure, second = middle.figure - fine.figure;
  const double within = noise * std::abs(fine.figure);
  if (std::abs(first) <= within && std::abs(second) <= within)
    return {std::nullopt, "the figure does not depend on the size"};
  if (!(first * second > 0.0 && std::abs(second) < std::abs(first)))
    return {std::nullopt, "the differences do not shrink monotonically"};

  const double ratio = std::sqrt(coarse.size / fine.size);
  Extrapolation result;
  result.order = std::log(first / second) / std::log(ratio);
  result.value = fine.figure - second / (first / second - 1.0);  // r^p is the differences' ratio
  result.sizes = {coarse.size, middle.size, fine.size};
  return {result, ""};
}

}  // namespace stroma
