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
  std::string file;         ///< of another file, when the set is spread over several
};

/// The first image of an OME-XML document.
struct OmePixels {
  std::string dimension_order = "XYCZT";
  std::int64_t size_x = 0, size_y = 0, size_z = 0, size_c = 0, size_t = 0;
  std::array<std::optional<double>, 3> physical_size;          ///< x, y, z in the units below
  std::array<std::string, 3> physical_unit{"um", "um", "um"};  ///< the standard's default
  std::vector<OmePlanes> planes;
};

/// Reads the first Image's Pixels. Nothing when there is none; `problem` then says why, if it is
/// not well-formed.
std::optional<OmePixels> read_ome_xml(const std::string& xml, std::string& problem);

}  // namespace stroma::image
