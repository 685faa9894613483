// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// `stroma phantom`: writes a synthetic microvessel volume.

#include <array>
#include <cstdint>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma {

/// The options of `stroma phantom`.
struct PhantomOptions {
  std::string output;                                 ///< -o FILE
  std::array<std::int64_t, 3> size{512, 512, 52};     ///< --size, voxels
  std::array<double, 3> voxel_size{1.05, 1.05, 1.0};  ///< --voxel [um]
  double fraction = 0.194;                            ///< --fraction
  std::int64_t seed = 1;                              ///< --seed
};

/// Writes the grey image of a vessel network as a TIFF stack, and prints the volume fraction it
/// reached. Collective.
/// \returns the exit status 0
/// \throws base::InputError when an option is not admissible or the file cannot be written
int phantom_command(const base::Communicator& communicator, const PhantomOptions& options,
                    base::Log& log);

}  // namespace stroma
