// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Parts of the body that float in empty space.

#include <array>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// (axis, lower or upper face) how many layers of voxels the conditions on a face reach; 0: there
/// is none.
using FaceReach = std::array<std::array<std::int64_t, 2>, 3>;

/// Makes fragments empty (-1). A fragment is a set of voxels that are not empty, joined by faces of
/// voxels, none of them within the reach of a face: nothing holds it, and nothing loads it. A grid
/// would tie it to the body where both lie in one element, or let it turn about the edge of an
/// element that they share. Nothing is done when all of the body is out of reach. Collective.
///
/// Memory: 9 bytes a voxel, for a while, where some are empty.
/// \returns what the user should know; "" when there is no fragment
std::string leave_out_fragments(const base::Communicator& communicator, voxels::LabelVolume& labels,
                                const FaceReach& reach);

}  // namespace stroma::image
