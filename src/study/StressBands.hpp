// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Bands of each voxel's von Mises stress.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace stroma {

/// The voxels of a specimen's image, or of the region of it that is read.
struct VoxelLattice {
  std::array<std::int64_t, 3> size{};
  std::array<double, 3> voxel_size{};  ///< [um]
  std::array<double, 3> origin{};      ///< lower corner of the first voxel [um]
};

/// Writes von_mises_05.tif, von_mises_50.tif and von_mises_95.tif: of each voxel of the undeformed
/// body the von Mises stress [Pa] at full load that 5, 50 and 95 % of the runs stay below, as 32-bit
/// floats. A run's stress in a voxel is the mean, by volume, of its particles there; runs without
/// any do not count, and where no run has one the value is NaN. Each rank makes its slab of planes,
/// some at a time, and reads every run's particles.e once for each of these batches: it holds its
/// part of the result, and 128 MiB of the runs' values. Collective.
/// \param communicator  of all ranks
/// \param runs          folders of finished runs of this lattice
/// \param lattice       the voxels
/// \param folder        for the files
/// \throws base::RunError on all ranks when a file cannot be read or written
void write_stress_bands(const base::Communicator& communicator,
                        const std::vector<std::string>& runs, const VoxelLattice& lattice,
                        const std::string& folder);

}  // namespace stroma
