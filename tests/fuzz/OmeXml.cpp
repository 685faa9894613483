// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Fuzz target: any text, read as OME-XML, and its planes dealt to the pages of a file of twelve.

#include "stroma/image/formats/OmeXml.hpp"

#include <algorithm>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace stroma;
  constexpr std::int64_t pages = 12;
  std::string problem, note;
  const auto ome =
      image::read_ome_xml(std::string(reinterpret_cast<const char*>(bytes), size), problem);
  if (!ome && problem.empty()) std::abort();
  if (!ome || !ome->contradiction.empty() || ome->size_z * ome->size_c > pages) return 0;
  const auto planes = image::planes_of_file(*ome, "stack.ome.tif", note);
  for (const std::int64_t page :
       image::pages_of_frame(*ome, planes, ome->size_c, 1, pages, ome->size_c - 1, 0)) {
    if (page < -1 || page >= pages) std::abort();
  }
  return 0;
}
