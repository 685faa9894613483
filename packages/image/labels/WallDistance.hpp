// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How far voxels are from the wall of a label.

#include <cstdint>

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// The distance [um] from the middle of each voxel to the nearest wall of a label: the faces between
/// voxels of that label and all others, empty space among them; faces of the image are no walls.
/// Exact, up to a limit; beyond it, and where there is no wall, the limit.
///
/// The nearest point of the wall belongs to a voxel on the other side, and the squared distance to
/// that box is the sum over the axes of (max(n - 1/2, 0) h)^2, n voxels of size h away. So one axis
/// after the other is searched, z across strips of rows that the ranks exchange for their slabs: no
/// rank has more than its share of the volume. Collective.
/// Source: Saito and Toriwaki (1994), Pattern Recognition 27, 1551-1565, for distances of middles.
///
/// \param communicator  of the ranks that share the volume
/// \param labels        of the voxels
/// \param label         the one whose wall it is
/// \param limit         [um]; the planes within it are no more than 255
voxels::Volume<float> wall_distance(const base::Communicator& communicator,
                                    const voxels::LabelVolume& labels, std::int32_t label,
                                    double limit);

}  // namespace stroma::image
