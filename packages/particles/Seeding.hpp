#pragma once

/// \file
/// Particles from a segmented image: the layouts, and the deck section "Particles".

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "base/Communicator.hpp"
#include "deck/Section.hpp"
#include "grid/Partition.hpp"
#include "grid/Types.hpp"
#include "image/Volume.hpp"
#include "particles/Particles.hpp"

namespace stroma::particles {

/// A point that rounding puts by less than this below a face of an element lies on the face, and so
/// in the upper element [elements].
constexpr double face_tolerance = 1e-9;

enum class Layout { voxel_centers, gauss, per_element };

struct ParticleParameters {
  Layout layout = Layout::voxel_centers;
  int per_voxel = 1;    ///< Voxel Centers: particles per voxel and direction
  int per_element = 2;  ///< Per Element: particles per element and direction
};

deck::Section<ParticleParameters> particles_section();

/// Distance of neighbouring particles along axis d [um]; the mean one, for Gauss points.
double particle_spacing(const ParticleParameters& parameters, const grid::Grid& grid, int d,
                        double voxel_size);

/// Half the edge along axis d of the domain that a particle stands for [um], centred at it: half
/// the distance of neighbours; for Gauss points, which do not lie in the middle of their shares,
/// the distance to the element's face. Domains neither overlap nor reach out of the body.
double domain_half_edge(const ParticleParameters& parameters, const grid::Grid& grid, int d,
                        double voxel_size);

/// Where particles lie along one axis. Every layout is a tensor product of three of these, kept for
/// a range of elements only.
struct AxisLayout {
  std::int64_t first = 0;           ///< number, along the whole axis, of the first point kept
  std::int64_t total = 0;           ///< points along the whole axis
  std::vector<double> position;     ///< of each point kept [um]
  std::vector<double> length;       ///< its share of the axis [um]
  std::vector<std::int64_t> voxel;  ///< the voxel it lies in
  std::vector<int> element_begin;   ///< first point of each element kept, and the number of points
};

/// Layout along axis d for the elements [begin, end). The image's first voxel starts at the grid's
/// origin. A point on the face between two elements belongs to the upper one.
///
/// \param voxels      voxels of the image along the axis
/// \param voxel_size  [um]
AxisLayout axis_layout(const ParticleParameters& parameters, const grid::Grid& grid, int d,
                       std::int64_t begin, std::int64_t end, std::int64_t voxels,
                       double voxel_size);

/// Weight of each layer of elements for grid::Partition::balanced: the image's non-empty voxels
/// there (label other than -1), per direction. Collective.
std::array<std::vector<double>, 3> layer_weights(const base::Communicator& communicator,
                                                 const grid::Grid& grid,
                                                 const image::LabelVolume& labels);

/// Particles in this rank's elements: position, reference volume, material index and id of each
/// particle whose voxel is not empty (label -1). Ids number the full tensor product, x fastest, so
/// that they do not depend on the ranks. Collective.
///
/// \param material_of_label  index of the material of each label
/// \throws base::InputError when a label has no material
Particles<grid::Device> seed(const base::Communicator& communicator,
                             const ParticleParameters& parameters, const grid::Partition& partition,
                             const image::LabelVolume& labels,
                             const std::map<std::int32_t, int>& material_of_label);

}  // namespace stroma::particles
