// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What an OME-TIFF and a hyperstack of ImageJ say of themselves.

#include <cstdint>
#include <string>
#include <vector>

#include "stroma/image/stacks/StackWriter.hpp"

namespace stroma::image {

/// The OME-XML (schema 2016-06) of a stack whose pages are channels, then z.
std::string ome_xml(const StackHeader& header);

/// ImageJ's description of the same pages.
std::string imagej_description(const StackHeader& header);

/// ImageJ's tags 50838 and 50839 with a label for each page, the name of its channel. Words are in
/// the byte order of this machine, as the file's must be.
struct ImageJLabels {
  std::vector<std::uint32_t> byte_counts;
  std::vector<unsigned char> bytes;
};
ImageJLabels imagej_labels(const StackHeader& header);

}  // namespace stroma::image
