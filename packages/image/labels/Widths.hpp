// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How wide the objects of a label are.

#include <array>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// Widths of the objects of one label. All are 0 when it does not occur.
struct Widths {
  /// By stereology [um]: the mean chord of a long tube of any direction is its diameter,
  ///
  ///     tubes = 4 V / S,   S / V_total = 2 P_L,
  ///     in a single slice: tubes = 4 A / B,   B / A_total = pi/2 P_L,
  ///
  /// with P_L the crossings of the objects' surface per length of grid lines along the axes. Faces of
  /// the image are no surface; infinity when there is none.
  /// Source: Underwood (1970), Quantitative Stereology, chapters 2 and 4.
  double tubes = 0.0;
  /// Mean length of the straight ways through the objects along x, y, z, which end at their surface or
  /// at a face of the image [um].
  std::array<double, 3> chords{0.0, 0.0, 0.0};
  /// Whether any of those ways ends at a surface.
  std::array<bool, 3> has_surface{false, false, false};
};

/// (label asked for) Collective.
/// \param communicator  of the ranks that share the volume
/// \param labels        of the voxels
/// \param wanted        no label twice
std::vector<Widths> widths(const base::Communicator& communicator,
                           const voxels::LabelVolume& labels,
                           const std::vector<std::int32_t>& wanted);

}  // namespace stroma::image
