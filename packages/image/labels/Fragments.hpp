// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Parts of the body that float in empty space.

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// (axis, lower or upper face) how many layers of voxels the conditions on a face reach; 0: there
/// is none.
using FaceReach = std::array<std::array<std::int64_t, 2>, 3>;

/// What a body consists of.
struct Bodies {
  std::int64_t count = 1;  ///< sets of filled voxels, joined by faces of voxels
  std::string note;        ///< what the user should know of those left out; "" when none is
};

/// Makes fragments empty (-1). A fragment is a set of voxels that are not empty, joined by faces of
/// voxels, none of them within the reach of a face: nothing holds it, and nothing loads it. A grid
/// would tie it to the body where both lie in one element, or let it turn about the edge of an
/// element that they share. Nothing is done when all of the body is out of reach. Collective.
///
/// Memory: 9 bytes a voxel, for a while, where some are empty.
/// \param communicator  of the ranks that share the volume
/// \param labels        of the voxels
/// \param reach         none: nothing is left out
/// \returns what is left
Bodies leave_out_fragments(const base::Communicator& communicator, voxels::LabelVolume& labels,
                           const std::optional<FaceReach>& reach);

}  // namespace stroma::image
