// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Connected objects of a distributed label volume.

#include <cstdint>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// Which voxels touch: those that share a face, or those that share at least a corner.
enum class Connectivity { faces = 6, corners = 26 };

/// The connected objects of a volume: sets of touching voxels of one and the same label, which is
/// not negative and not that of the ground between them.
/// Objects that reach over several ranks' slabs are merged by exchanging boundary planes until
/// nothing changes; no rank sees more than its slab and two planes.
class Objects {
 public:
  /// Collective.
  /// \param communicator  of the ranks that share the volume
  /// \param labels        of the voxels
  /// \param connectivity  which voxels touch
  /// \param ground        label of what makes no objects; -1: all other labels do
  Objects(const base::Communicator& communicator, const voxels::LabelVolume& labels,
          Connectivity connectivity, std::int32_t ground = 0);

  /// Number of objects of at least so many voxels. Collective.
  std::int64_t count(std::int64_t smallest = 1) const;
  /// Voxels of the largest object; 0 when there is none. Collective.
  std::int64_t largest() const;
  /// Voxels, on all ranks, of the object that a voxel of this slab belongs to; 0 for a voxel of no
  /// object.
  /// \param voxel  index into the slab's values
  std::int64_t size_at(std::size_t voxel) const {
    return piece_[voxel] < 0 ? 0 : size_[static_cast<std::size_t>(piece_[voxel])];
  }
  /// Number of pieces: what of each object lies in this slab is one or several.
  std::size_t pieces() const { return id_.size(); }
  /// The piece that a voxel of this slab belongs to. \pre size_at(voxel) > 0
  std::size_t piece_at(std::size_t voxel) const { return static_cast<std::size_t>(piece_[voxel]); }
  /// Whether a piece is the one, of all ranks, that its object is counted by: that with the object's
  /// first voxel.
  bool is_first(std::size_t piece) const {
    return id_[piece] == first_id_ + static_cast<std::int64_t>(piece);
  }
  /// A number of each piece of this slab, summed over all pieces of its object: (piece).
  /// Collective.
  std::vector<std::int64_t> sum_over_pieces(std::vector<std::int64_t> of_pieces) const;

 private:
  base::Communicator communicator_;
  std::vector<std::int32_t>
      piece_;  ///< (voxel of the slab) piece of an object within this slab, or -1
  std::vector<std::int64_t> id_;    ///< (piece) the object's number in the whole volume
  std::vector<std::int64_t> size_;  ///< (piece) voxels of the whole object
  std::int64_t first_id_ = 0;       ///< pieces of the ranks before this one

  void find_pieces(const voxels::LabelVolume& labels, Connectivity connectivity,
                   std::int32_t ground);
  void merge_over_slabs(const voxels::LabelVolume& labels, Connectivity connectivity);
};

/// Objects (26-connected) of fewer voxels than `smallest` become background: empty space (-1) where
/// more of the neighbours of their voxels are empty than are of label 0, else label 0. Collective.
/// \returns how many objects were removed
std::int64_t remove_small_objects(const base::Communicator& communicator,
                                  voxels::LabelVolume& labels, std::int64_t smallest);

}  // namespace stroma::image
