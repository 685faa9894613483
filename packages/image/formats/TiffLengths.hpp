// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The size of a voxel, by each of the customs that TIFF files follow. What is found but cannot be
/// used becomes a note.

#include "stroma/image/formats/ImageJDescription.hpp"
#include "stroma/image/formats/ImageSummary.hpp"
#include "stroma/image/formats/MicroscopeTags.hpp"
#include "stroma/image/formats/OmeXml.hpp"
#include "stroma/image/formats/TiffPages.hpp"

namespace stroma::image {

/// By the resolution tags in inches or centimetres; those of printers and screens are no
/// calibration.
void take_resolution_lengths(ImageSummary& summary, const TiffTags& tags);
/// By the resolution tags in ImageJ's unit, and its spacing of the slices; as above if it has none.
void take_imagej_lengths(ImageSummary& summary, const TiffTags& tags,
                         const ImageJDescription& imagej);
void take_ome_lengths(ImageSummary& summary, const OmePixels& ome);
void take_stk_lengths(ImageSummary& summary, const StkTags& stk);
void take_lsm_lengths(ImageSummary& summary, const LsmTags& lsm);

}  // namespace stroma::image
