// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// From intensities to labels, and the volume fractions of labels.

#include <cstdint>
#include <map>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/image/formats/ImageSummary.hpp"
#include "stroma/image/labels/SegmentationParameters.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// Label 1 where intensity > threshold, else 0. No communication.
voxels::LabelVolume threshold_labels(const voxels::IntensityVolume& volume, double threshold);

/// The values themselves as labels. Collective.
/// \throws base::InputError when a value is not an integer, is below -1 or above 2^31 - 1 (naming
/// the first such voxel)
voxels::LabelVolume value_labels(const base::Communicator& communicator,
                                 const voxels::IntensityVolume& volume);

/// Smooths, segments, makes empty space and removes small objects, as the parameters say.
/// Collective.
/// \param communicator  of the ranks that share the volume
/// \param volume        the intensities; taken over
/// \param parameters    the deck's section
/// \param summary       its type decides the bins of Otsu's method; its notes gain Otsu's threshold
///                      and what was removed
/// \throws base::InputError when an intensity is not finite
voxels::LabelVolume segment(const base::Communicator& communicator, voxels::IntensityVolume volume,
                            const SegmentationParameters& parameters, ImageSummary& summary);

/// Fraction of the voxels that carry each label of the volume. Collective.
std::map<std::int32_t, double> volume_fractions(const base::Communicator& communicator,
                                                const voxels::LabelVolume& labels);

/// Fraction of the voxels of each plane that carry a label: one value per plane of the whole
/// volume, on every rank. Collective.
std::vector<double> plane_fractions(const base::Communicator& communicator,
                                    const voxels::LabelVolume& labels, std::int32_t label);

}  // namespace stroma::image
