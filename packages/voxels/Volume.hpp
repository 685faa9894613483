// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A three-dimensional image spread over the ranks in slabs of planes, and how a rank gets at any
/// box of it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace stroma::voxels {

/// A box of voxels: first voxel and number of voxels along x, y, z.
struct Box {
  std::array<std::int64_t, 3> first{0, 0, 0};
  std::array<std::int64_t, 3> count{0, 0, 0};

  std::int64_t voxels() const { return count[0] * count[1] * count[2]; }
};

/// How planes are dealt to ranks: rank r holds the planes [planes r / ranks, planes (r+1) / ranks).
/// With fewer planes than ranks, some ranks hold none.
class Slabs {
 public:
  Slabs(std::int64_t planes, int ranks) : planes_(planes), ranks_(ranks) {}

  std::int64_t first(int rank) const { return planes_ * rank / ranks_; }
  std::int64_t count(int rank) const { return first(rank + 1) - first(rank); }
  /// The rank that holds a plane in [0, planes).
  int owner(std::int64_t plane) const {
    return static_cast<int>(((plane + 1) * ranks_ - 1) / planes_);
  }

 private:
  std::int64_t planes_;
  int ranks_;
};

/// A volume distributed over the ranks in slabs of planes along z (see Slabs); x runs fastest,
/// plane 0 and row 0 touch the origin: the centre of voxel (i, j, k) lies at ((i + 1/2) hx, (j +
/// 1/2) hy, (k + 1/2) hz).
template <class T>
struct Volume {
  std::array<std::int64_t, 3> size{0, 0, 0};        ///< voxels of the whole volume: x, y, z
  std::array<double, 3> voxel_size{0.0, 0.0, 0.0};  ///< [um]; 0: not known
  std::int64_t first_plane = 0;  ///< this rank's slab is [first_plane, first_plane + planes)
  std::int64_t planes = 0;       ///< may be 0
  std::array<std::int64_t, 3> first_in_file{0, 0, 0};  ///< where in its file the volume begins
  std::vector<T> values;                               ///< planes * size[1] * size[0]

  Volume() = default;
  /// A volume of zeros, with this rank's share of the planes allocated.
  Volume(const base::Communicator& communicator, const std::array<std::int64_t, 3>& whole,
         const std::array<double, 3>& voxel)
      : size(whole), voxel_size(voxel) {
    const Slabs slabs(size[2], communicator.size());
    first_plane = slabs.first(communicator.rank());
    planes = slabs.count(communicator.rank());
    values.resize(static_cast<std::size_t>(planes * plane_voxels()));
  }

  std::int64_t plane_voxels() const { return size[0] * size[1]; }
  std::int64_t voxels() const { return plane_voxels() * size[2]; }
  T* plane(std::int64_t local) { return values.data() + local * plane_voxels(); }
  const T* plane(std::int64_t local) const { return values.data() + local * plane_voxels(); }
};

/// Intensities: double, so that every integer and float type of 8 to 32 bits is held exactly.
using IntensityVolume = Volume<double>;
/// Labels: -1 empty space, 0 and up materials.
using LabelVolume = Volume<std::int32_t>;

/// "voxel (x, y, z)", counted from 0 in the file.
std::string name_of_voxel(const std::array<std::int64_t, 3>& in_file);
/// The same of the voxel with this number in the whole volume.
std::string name_of_voxel(const IntensityVolume& volume, std::int64_t voxel);

/// The values of one box of voxels of this rank's choosing, x fastest. Collective; each rank asks
/// for its own box, which may be empty and may overlap others', and receives it from the ranks that
/// hold it, plane by plane. \pre the box lies within the volume (a box with a count of 0 is empty
/// wherever it lies) T: std::uint8_t, std::int32_t, std::int64_t, float or double.
template <class T>
std::vector<T> extract(const base::Communicator& communicator, const Volume<T>& volume,
                       const Box& wanted);

}  // namespace stroma::voxels
