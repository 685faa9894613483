// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The connected objects of a label volume, one by one.

#include <array>
#include <cstdint>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// What the voxels (i, j, k) of an object tell of its size, place and shape, exactly.
struct ObjectMoments {
  std::int64_t label, voxels;
  std::array<std::int64_t, 3> sum;       ///< of i, j, k
  std::array<std::int64_t, 6> products;  ///< sums of ii, jj, kk, ij, jk, ki
};

/// Objects with numbers 1, 2, ... in the order of their first voxels, x fastest: the same on any
/// number of ranks.
struct NumberedObjects {
  voxels::LabelVolume number;          ///< (voxel) of its object, or 0
  std::int64_t first = 1;              ///< number of the first object that this rank keeps
  std::vector<ObjectMoments> moments;  ///< of the objects that this rank keeps, by number
  std::int64_t count = 0;              ///< objects on all ranks
};

/// The 26-connected objects of all labels but one, up to 2^31 of them; the voxels of an object have
/// one label. Each is kept by the rank that has its first voxel. Collective.
/// \param communicator  of the ranks that share the volume
/// \param labels        of the voxels; -1: empty space
/// \param ground        the label of what lies between the objects; -1: there is none
NumberedObjects number_objects(const base::Communicator& communicator,
                               const voxels::LabelVolume& labels, std::int32_t ground);

}  // namespace stroma::image
