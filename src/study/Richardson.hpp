// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a figure tends to as the elements shrink, from its values at three sizes.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace stroma {

/// A figure f of a run with elements of size h.
struct SizedFigure {
  double size = 0;    ///< h [um], > 0
  double figure = 0;  ///< f, in any unit
};

struct Extrapolation {
  double value = 0;               ///< f0, the figure at h = 0
  double order = 0;               ///< p, observed
  std::array<double, 3> sizes{};  ///< the h it comes from, coarsest first [um]
};

/// Either the extrapolation, or in a few words why there is none.
struct RichardsonResult {
  std::optional<Extrapolation> extrapolation;
  std::string undefined_because;
};

/// Fits f = f0 + c h^p to the figures at three sizes with a constant ratio r = h1/h2 = h2/h3 > 1:
///
///     p = log((f1 - f2) / (f2 - f3)) / log r,     f0 = f3 + (f3 - f2) / (r^p - 1)
///
/// Of more than three sizes, the finest three with a constant ratio count. Undefined when there are
/// no such three, when the differences do not shrink monotonically (f1 - f2 and f2 - f3 of opposite
/// sign, or the second not smaller), and when both are within the noise of the figures.
///
/// \param figures  in any order; sizes differ
/// \param noise    by how much a figure may be off, relative to its size [-]
/// Source: L. F. Richardson and J. A. Gaunt, Phil. Trans. R. Soc. A 226 (1927) 299.
RichardsonResult richardson(std::vector<SizedFigure> figures, double noise = 0.0);

}  // namespace stroma
