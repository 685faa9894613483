// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// From an image file or a phantom to a volume of intensities, and on to labels.

#include <functional>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/image/ImageParameters.hpp"
#include "stroma/image/formats/ImageSummary.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// What a caller wants to do once the size of an image is known, before its voxels take memory.
/// Called by all ranks alike.
using BeforeReading = std::function<void(const ImageSummary&)>;

/// Reads the region of an image file that the parameters name, each rank its slab of planes.
/// Collective.
///
/// TIFF (single, multi-page, ImageJ stacks and hyperstacks, OME-TIFF), Bio-Rad PIC, HDF5 and what
/// lies as plain numbers in MetaImage, NRRD and NIfTI: each rank reads its own planes. Packed
/// values, and values as text, cannot be read in parts: rank 0 reads them and hands them out plane
/// by plane.
///
/// The voxel size is the deck's, else the file's; an axis that neither states is left 0 (see
/// ImageSummary), and require_voxel_size() turns that into an error.
/// \param communicator    of the ranks that share the volume
/// \param parameters      the deck's section
/// \param folder          of the deck, to which the file's name is relative
/// \param summary         filled with what was found
/// \param before_reading  called with what the headers say, before values are read
/// \throws base::InputError on all ranks: no such file, not an image, broken, no such channel or
///   dataset, a type of value that is not admissible, a region outside the image
voxels::IntensityVolume read_volume(const base::Communicator& communicator,
                                    const ImageParameters& parameters, const std::string& folder,
                                    ImageSummary& summary,
                                    const BeforeReading& before_reading = {});

/// \throws base::InputError naming the deck's parameter when the size of a voxel is not known along
/// every axis
void require_voxel_size(const ImageSummary& summary);

/// The whole way to labels: read or make a phantom, cut the region, smooth, segment, remove small
/// objects. Collective.
/// \param communicator    of the ranks that share the volume
/// \param parameters      the deck's section
/// \param folder          of the deck, to which the file's name is relative
/// \param summary         if not null, filled with what was found
/// \param before_reading  called with what the headers say, before values are read
/// \param intensities     if not null, receives the file's values, before smoothing; of a phantom it
///                        stays empty
/// \throws base::InputError as read_volume, and when the voxel size is unknown, a label is not an
///   integer or below -1, an intensity is not finite, or Otsu's method meets a single value
voxels::LabelVolume read_labels(const base::Communicator& communicator,
                                const ImageParameters& parameters, const std::string& folder,
                                ImageSummary* summary = nullptr,
                                const BeforeReading& before_reading = {},
                                voxels::IntensityVolume* intensities = nullptr);

}  // namespace stroma::image
