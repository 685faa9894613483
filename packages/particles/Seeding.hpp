// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles from a segmented image.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Partition.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/particles/AxisLayout.hpp"
#include "stroma/particles/Particles.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::particles {

/// Weight of each layer of elements for grid::Partition::balanced: the image's non-empty voxels
/// there (label other than -1), per direction; a voxel that several layers cut counts in each by
/// its share. Collective.
std::array<std::vector<double>, 3> layer_weights(const base::Communicator& communicator,
                                                 const grid::Grid& grid,
                                                 const voxels::LabelVolume& labels);

/// The voxels that a rank's particles lie in.
struct ParticleVoxels {
  voxels::Box box;                  ///< of the image
  std::vector<std::size_t> number;  ///< (particle) of its voxel in the box, x fastest
};

/// The values of a volume at the voxels of particles. Collective.
template <class T>
std::vector<T> at_particles(const base::Communicator& communicator, const ParticleVoxels& particles,
                            const voxels::Volume<T>& volume) {
  const std::vector<T> in_box = voxels::extract(communicator, volume, particles.box);
  std::vector<T> values;
  values.reserve(particles.number.size());
  for (const std::size_t voxel : particles.number) values.push_back(in_box[voxel]);
  return values;
}

/// Particles in this rank's elements: position, reference volume, material index and id of each
/// particle whose voxel is not empty (label -1). Ids number the full tensor product, x fastest, so
/// that they do not depend on the ranks. Collective.
///
/// \param communicator       of the ranks that share the grid
/// \param parameters         the deck's section
/// \param partition          which elements are whose
/// \param labels             of the voxels; -1: empty space
/// \param material_of_label  index of the material of each label
/// \param where              if not null, gets the particles' voxels
/// \throws base::InputError when a label has no material
Particles<grid::Device> seed(const base::Communicator& communicator,
                             const ParticleParameters& parameters, const grid::Partition& partition,
                             const voxels::LabelVolume& labels,
                             const std::map<std::int32_t, int>& material_of_label,
                             ParticleVoxels* where = nullptr);

}  // namespace stroma::particles
