#include "image/OmeXml.hpp"

#include <expat.h>

#include <cstdlib>
#include <cstring>

namespace stroma::image {
namespace {

struct State {
  std::optional<OmePixels> pixels;
  bool finished = false;  ///< the first Pixels is over
  bool in_tiff_data = false;
};

/// "ome:Pixels" and "Pixels" alike.
const char* local_name(const char* name) {
  const char* colon = std::strrchr(name, ':');
  return colon ? colon + 1 : name;
}

void start(void* user, const char* name, const char** attributes) {
  State& state = *static_cast<State*>(user);
  if (state.finished) return;
  const std::string tag = local_name(name);
  const auto find = [&](const char* wanted) -> const char* {
    for (const char** a = attributes; *a; a += 2) {
      if (std::strcmp(local_name(a[0]), wanted) == 0) return a[1];
    }
    return nullptr;
  };
  const auto integer = [&](const char* wanted, std::int64_t otherwise) {
    const char* text = find(wanted);
    return text ? static_cast<std::int64_t>(std::strtoll(text, nullptr, 10)) : otherwise;
  };
  if (tag == "Pixels" && !state.pixels) {
    OmePixels& pixels = state.pixels.emplace();
    if (const char* order = find("DimensionOrder")) pixels.dimension_order = order;
    pixels.size_x = integer("SizeX", 0);
    pixels.size_y = integer("SizeY", 0);
    pixels.size_z = integer("SizeZ", 0);
    pixels.size_c = integer("SizeC", 0);
    pixels.size_t = integer("SizeT", 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string attribute = std::string("PhysicalSize") + "XYZ"[axis];
      if (const char* size = find(attribute.c_str()))
        pixels.physical_size[axis] = std::strtod(size, nullptr);
      if (const char* unit = find((attribute + "Unit").c_str())) pixels.physical_unit[axis] = unit;
    }
  } else if (tag == "TiffData" && state.pixels) {
    OmePlanes planes;
    planes.page = integer("IFD", 0);
    planes.first_z = integer("FirstZ", 0);
    planes.first_c = integer("FirstC", 0);
    planes.first_t = integer("FirstT", 0);
    // The standard: with an IFD but no PlaneCount, one plane; with neither, all.
    planes.count = integer("PlaneCount", find("IFD") ? 1 : -1);
    state.pixels->planes.push_back(planes);
    state.in_tiff_data = true;
  } else if (tag == "UUID" && state.in_tiff_data) {
    if (const char* file = find("FileName")) state.pixels->planes.back().file = file;
  }
}

void end(void* user, const char* name) {
  State& state = *static_cast<State*>(user);
  const std::string tag = local_name(name);
  if (tag == "Pixels") state.finished = state.pixels.has_value();
  if (tag == "TiffData") state.in_tiff_data = false;
}

}  // namespace

std::optional<OmePixels> read_ome_xml(const std::string& xml, std::string& problem) {
  State state;
  XML_Parser parser = XML_ParserCreate(nullptr);
  XML_SetUserData(parser, &state);
  XML_SetElementHandler(parser, start, end);
  if (XML_Parse(parser, xml.data(), static_cast<int>(xml.size()), 1) == XML_STATUS_ERROR) {
    problem = XML_ErrorString(XML_GetErrorCode(parser));
    state.pixels.reset();
  }
  XML_ParserFree(parser);
  return state.pixels;
}

}  // namespace stroma::image
