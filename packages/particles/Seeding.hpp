// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles from a segmented image.

#include <array>
#include <cstdint>
#include <functional>
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

/// A field whose values follow from the voxels that the particles lie in.
struct SeededField {
  using Member = Kokkos::View<double*, grid::Device>(Particles<grid::Device>::*);

  Member field;  ///< such as &Particles<grid::Device>::shear_modulus
  const voxels::IntensityVolume* intensities;
  std::function<double(int material, double intensity)> value;
};

/// Particles in this rank's elements: position, reference volume, material index and id of each
/// particle whose voxel is not empty (label -1), and the fields asked for. Ids number the full
/// tensor product, x fastest, so that they do not depend on the ranks. Collective.
///
/// \param communicator       of the ranks that share the grid
/// \param parameters         the deck's section
/// \param partition          which elements are whose
/// \param labels             of the voxels; -1: empty space
/// \param material_of_label  index of the material of each label
/// \param fields             besides what every particle has
/// \throws base::InputError when a label has no material
Particles<grid::Device> seed(const base::Communicator& communicator,
                             const ParticleParameters& parameters, const grid::Partition& partition,
                             const voxels::LabelVolume& labels,
                             const std::map<std::int32_t, int>& material_of_label,
                             const std::vector<SeededField>& fields = {});

}  // namespace stroma::particles
