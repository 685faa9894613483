// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The specimen as the deck describes it, ready to be computed with.

#include <memory>
#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Partition.hpp"
#include "stroma/image/formats/ImageSummary.hpp"
#include "stroma/image/labels/Widths.hpp"
#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/solver/Advice.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma {

/// The deck's image, this rank's part.
struct SpecimenImage {
  image::ImageSummary summary;
  voxels::LabelVolume labels;
  voxels::IntensityVolume intensities;  ///< where a material's field asks for them; else empty
  std::int64_t bodies = 1;              ///< that its filled voxels make, by faces of voxels
};

/// Grid and particles of one deck, this rank's part.
struct Specimen {
  image::ImageSummary image;
  grid::Grid body;            ///< the lattice of elements that fills the body's box
  grid::Partition partition;  ///< of the grid that the shape functions need over it
  particles::Particles<grid::Device> particles;  ///< of the undeformed body
  particles::LayoutSizes layout;
  std::vector<std::string> notes;     ///< what a user should know of grid and particles
  std::vector<image::Widths> widths;  ///< (material) of its voxels
  std::int64_t bodies;                ///< that the image's filled voxels make, by faces of voxels
  std::int64_t particle_count;        ///< over all ranks
  std::string dilatation;             ///< which one, and why
  /// The softest and stiffest of the particles of each material, where they differ; else empty.
  std::vector<material::SmallStrainModuli> extremes;
  std::vector<std::vector<int>> own_numbers;  ///< (material) that particles give (OwnNumbers)
  std::vector<std::string> fields;            ///< a line on each
  /// (condition) of its images, or null
  std::vector<std::shared_ptr<const mechanics::VectorField>> displacements;
  /// (initial condition) of its images, or null
  std::vector<std::shared_ptr<const mechanics::VectorField>> velocities;
  std::vector<std::string>
      files;  ///< that it was read from: of its image, its fields, displacements, velocities
};

/// What is solved on the specimen.
mechanics::Problem problem_of(const Deck& deck, const Specimen& specimen);

/// What may make its solution hard. Collective.
solver::Circumstances circumstances(const Deck& deck, const mechanics::MomentumBalance& balance);

/// Reads and segments the deck's image, and leaves out what floats in empty space. It is kept only
/// as long as it is needed: it and the particles are the larger part of what a rank holds before it
/// solves. Collective. \throws base::InputError when image and deck do not go together
SpecimenImage read_image(const base::Communicator& communicator, const Deck& deck);

/// Grid and particles for a segmented image. Collective.
/// \throws base::InputError when the deck's grid does not fit the image
Specimen make_specimen(const base::Communicator& communicator, const Deck& deck,
                       const SpecimenImage& image);

}  // namespace stroma
