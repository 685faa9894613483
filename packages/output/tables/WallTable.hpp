// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// wall_distance.csv: stress and strain against the distance to the walls of a label.

#include <cstdint>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/tables/GroupedParticles.hpp"

namespace stroma::output {

/// Bins of distances, each as wide as the smallest edge of a voxel.
constexpr std::size_t wall_bins = 64;

/// Particles by their distance to one label's wall: those of a material m in the bin b are the group
/// b materials + m.
struct WallParticles {
  std::size_t material;        ///< of the label
  GroupedParticles particles;  ///< of von_mises, principal_stress_1 and principal_strain_1
};

/// The group of a particle, or none beyond the last bin.
/// \param distance   to the wall [um]
/// \param bin_width  [um]
/// \param material   of the particle
/// \param materials  in all
std::uint16_t wall_group(double distance, double bin_width, std::size_t material,
                         std::size_t materials);

/// No walls: a head without rows. Collective.
/// \param communicator  of the run
/// \param files         of the run
/// \param materials     their names
/// \param bin_width     [um]
/// \param walls         with what was found
/// \throws base::RunError on all ranks when the file cannot be written
void write_wall_table(const base::Communicator& communicator, const RunFiles& files,
                      const std::vector<std::string>& materials, double bin_width,
                      const std::vector<WallParticles>& walls);

}  // namespace stroma::output
