// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A vector at each point of the body that images of its components give.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "stroma/voxels/Volume.hpp"

namespace stroma::mechanics {

/// The images of a vector's components, such as a displacement's [um] or a velocity's [um/s], as the
/// deck names them.
struct VectorImages {
  std::vector<std::string> images;  ///< three files, of x, y, z; or one that holds all three
  std::optional<std::array<int, 3>> channels;       ///< else 0 of three files; 0, 1, 2 of one
  std::optional<std::string> dataset;               ///< HDF5 only
  int frame = 0;                                    ///< of a time series
  std::optional<std::array<double, 3>> voxel_size;  ///< [um]; else the files'
  std::array<double, 3> corner{};                   ///< lower corner of their first voxel [um]

  std::size_t file_of(int component) const {
    return images.size() == 1 ? 0 : static_cast<std::size_t>(component);
  }
  int channel_of(int component) const {
    if (channels) return (*channels)[static_cast<std::size_t>(component)];
    return images.size() == 1 ? component : 0;
  }
};

/// Where the voxels of an image lie.
struct VoxelLattice {
  std::array<std::int64_t, 3> size{};
  std::array<double, 3> voxel_size{};  ///< [um]
  std::array<double, 3> corner{};      ///< lower corner of voxel (0, 0, 0) [um]

  /// The voxel with whose successor a coordinate along an axis is interpolated; the last but one, or
  /// the first, beyond the outermost centres.
  std::int64_t voxel_below(std::size_t axis, double coordinate) const;
  /// The voxels between whose centres the points of a box are interpolated [um].
  voxels::Box around(const std::array<double, 3>& lower, const std::array<double, 3>& upper) const;
};

/// A vector field by voxels, in the unit of its images: trilinear between their centres, continued in the same straight
/// lines over the half voxel beyond the outermost; constant along an axis with a single voxel. So a
/// field that is linear in X is met exactly. Of the image it holds a few boxes of voxels.
class VectorField {
 public:
  struct Block {
    voxels::Box box;
    std::array<std::vector<double>, 3> values;  ///< (component) empty: not asked for
  };

  /// \param name     of the deck's section, for errors
  /// \param lattice  of the whole image
  /// \param blocks   what of it is held
  /// \param largest  size of the largest component in the blocks of all ranks
  VectorField(std::string name, const VoxelLattice& lattice, std::vector<Block> blocks,
              double largest);

  /// A component at a point X of the undeformed body [um] around which the blocks hold the voxels.
  /// \throws base::InputError when a voxel that counts there is no finite number
  double at(int component, const std::array<double, 3>& X) const;

  double largest() const { return largest_; }

 private:
  double value(int component, const std::array<std::int64_t, 3>& voxel,
               const std::array<double, 3>& X) const;

  std::string name_;
  VoxelLattice lattice_;
  std::vector<Block> blocks_;
  double largest_;
};

}  // namespace stroma::mechanics
