// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How wide the objects of a label are.

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// Mean width of the objects of one label [um], by stereology: the mean chord of a long tube of any
/// direction is its diameter,
///
///     width = 4 V / S,   S / V_total = 2 P_L,
///     in a single slice: width = 4 A / B,   B / A_total = pi/2 P_L,
///
/// with P_L the crossings of the objects' surface per length of grid lines along the axes. Faces of
/// the image are no surface. 0 when the label does not occur, infinity when it has no surface.
/// Collective. Source: Underwood (1970), Quantitative Stereology, chapters 2 and 4.
double mean_width(const base::Communicator& communicator, const voxels::LabelVolume& labels,
                  std::int32_t label);

}  // namespace stroma::image
