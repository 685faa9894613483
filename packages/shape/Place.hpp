// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Where a point lies, as shape functions want to know it.

namespace stroma::shape {

/// A point in its element, and the domain that it stands for.
struct Place {
  double xi[3];         ///< natural coordinates in the element, 0 to 1 per direction [-]
  int element[3];       ///< number of the element along each direction, in the whole grid
  int elements[3];      ///< elements along each direction, in the whole grid
  double inverse_h[3];  ///< 1 / element size per direction [1/um]
  double domain[3][3];  ///< (i, k) half edge k of the point's domain, a vector [um]
};

/// Half a domain's extent that shape functions accept [elements]: a larger domain is cut down to
/// it, so that a point touches the node next to it and the neighbours of that one alone.
constexpr double largest_half_domain = 0.5;

}  // namespace stroma::shape
