// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The parts of OME-XML, the description in an OME-TIFF, that Stroma needs.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace stroma::image {

/// A TiffData entry: `count` planes, the first of which has the given z, c, t, lie in the pages
/// from `page` on.
struct OmePlanes {
  std::int64_t page = 0, first_z = 0, first_c = 0, first_t = 0;
  std::int64_t count = -1;  ///< -1: not said
  std::string file, uuid;   ///< of the file they lie in, when the set is spread over several
};

/// The first image of an OME-XML document.
struct OmePixels {
  std::string dimension_order = "XYCZT";
  std::int64_t size_x = 0, size_y = 0, size_z = 1, size_c = 1, size_t = 1;
  std::array<std::optional<double>, 3> physical_size;          ///< x, y, z in the units below
  std::array<std::string, 3> physical_unit{"um", "um", "um"};  ///< the standard's default
  std::vector<OmePlanes> planes;
  std::string uuid;                ///< of the file itself
  int images = 0;                  ///< of the document
  bool is_latin1 = false;          ///< says UTF-8, but is not
  std::vector<std::string> notes;  ///< what of it cannot be used
  std::string contradiction;  ///< the first attribute that cannot be: 'SizeZ="-8"'; empty: none
};

/// Reads the first Image's Pixels. Nothing when there is none or the document is not well-formed;
/// `problem` then says why: "is broken (...)". Bytes that are no UTF-8 are taken as Latin-1.
std::optional<OmePixels> read_ome_xml(const std::string& xml, std::string& problem);

/// The entries of the planes that lie in the file itself.
/// \param pixels  the planes that the XML states, with their files
/// \param name    of the file, without its folder
/// \param note    says so when the file was renamed since it was described
std::vector<OmePlanes> planes_of_file(const OmePixels& pixels, const std::string& name,
                                      std::string& note);

/// The page that holds each plane of a channel in a frame, [z]; -1 where no page does.
/// \param pixels    the sizes that the XML states
/// \param planes    of the file
/// \param channels  SizeC over the samples of a pixel
/// \param samples   of a pixel
/// \param pages     of the file
/// \param channel   counted from 0, of the stacked ones
/// \param frame     counted from 0
std::vector<std::int64_t> pages_of_frame(const OmePixels& pixels,
                                         const std::vector<OmePlanes>& planes,
                                         std::int64_t channels, std::int64_t samples,
                                         std::int64_t pages, std::int64_t channel,
                                         std::int64_t frame);

}  // namespace stroma::image
