// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Where particles lie: every layout is a tensor product of layouts along the axes.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "stroma/grid/Grid.hpp"

namespace stroma::particles {

/// A point that rounding puts by less than this below a face of an element lies on the face, and so
/// in the upper element [elements].
constexpr double face_tolerance = 1e-9;

enum class Layout { voxel_centers, gauss, per_element };

struct ParticleParameters {
  Layout layout = Layout::voxel_centers;
  int per_voxel = 1;    ///< Voxel Centers: particles per voxel and direction
  int per_element = 2;  ///< Per Element: particles per element and direction
};

/// Calls visit(part, begin, end) for each piece of an element along an axis that is divided into
/// equal elements and, from end to end too, into equal parts (voxels, or parts of them). Places are
/// integers, in units of which a part has 2 elements and an element 2 parts: nothing is rounded.
template <class Visit>
void for_each_piece(std::int64_t element, std::int64_t elements, std::int64_t parts,
                    const Visit& visit) {
  const std::int64_t end = 2 * parts * (element + 1);
  for (std::int64_t begin = 2 * parts * element, next; begin < end; begin = next) {
    const std::int64_t part = begin / (2 * elements);
    next = std::min(end, 2 * elements * (part + 1));
    visit(part, begin, next);
  }
}

/// Where particles lie along one axis, for a range of elements.
struct AxisLayout {
  std::int64_t first = 0;           ///< number, along the whole axis, of the first point kept
  std::int64_t total = 0;           ///< points along the whole axis
  std::vector<double> position;     ///< of each point kept [um]
  std::vector<double> length;       ///< its share of the axis [um]
  std::vector<double> half_edge;    ///< half the edge of its domain, centred at it [um]
  std::vector<std::int64_t> voxel;  ///< the voxel it lies in
  std::vector<int> element_begin;   ///< first point of each element kept, and the number of points
};

/// Layout along axis d for the elements [begin, end). Grid and image span the same length. A point
/// on the face between two elements belongs to the upper one.
///
/// Voxel Centers: the equal parts of the voxels, Per Voxel each, are cut at the faces of elements;
/// each piece has a point in its middle. A piece longer than three quarters of its element is
/// halved, so that there are two points or more in an element, and two of unequal share integrate
/// what varies linearly along it nearly as well as two equal ones. Cuts are found in integers:
/// there are no slivers by rounding. In plane strain nothing varies along z, and nothing is halved.
///
/// Domains are the shares and fill the axis; but those of Gauss points, which do not lie in the
/// middle of their shares, reach to the element's face only.
///
/// \param parameters  the deck's section
/// \param grid        the grid of the undeformed body
/// \param d           the axis
/// \param begin       first element
/// \param end         one past the last element
/// \param voxels      voxels of the image along the axis
/// \param voxel_size  [um]
AxisLayout axis_layout(const ParticleParameters& parameters, const grid::Grid& grid, int d,
                       std::int64_t begin, std::int64_t end, std::int64_t voxels,
                       double voxel_size);

/// What of a layout is the same for the whole body, along each axis.
struct LayoutSizes {
  std::array<double, 3> spacing;          ///< largest share of a point [um]
  std::array<double, 3> outer_thickness;  ///< of the layer of particles at a face, either one [um]
  std::array<std::vector<double>, 3> half_edge;  ///< of the domain of each point of the axis [um]
};

LayoutSizes layout_sizes(const ParticleParameters& parameters, const grid::Grid& grid,
                         const std::array<std::int64_t, 3>& voxels,
                         const std::array<double, 3>& voxel_size);

/// What a layout lacks on this grid and image, a sentence each: voxels whose boundaries it does not
/// resolve, elements that it under-integrates, elements finer than voxels.
std::vector<std::string> layout_notes(const ParticleParameters& parameters, const grid::Grid& grid,
                                      const std::array<std::int64_t, 3>& voxels);

}  // namespace stroma::particles
