// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/OmeXml.hpp"

#include <expat.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <type_traits>

#include "stroma/image/formats/HeaderText.hpp"
#include "stroma/image/formats/WholeNumber.hpp"

namespace stroma::image {
namespace {

struct State {
  std::optional<OmePixels> pixels;
  std::string uuid;       ///< of the document
  std::string metadata;   ///< the file that describes the image instead
  int images = 0;         ///< Pixels met
  bool finished = false;  ///< the first Pixels is over
  bool in_tiff_data = false, in_uuid = false;
};

/// "ome:Pixels" and "Pixels" alike.
const char* local_name(const char* name) {
  const char* colon = std::strrchr(name, ':');
  return colon ? colon + 1 : name;
}

const char* find(const char** attributes, const std::string& wanted) {
  for (const char** a = attributes; *a; a += 2) {
    if (wanted == local_name(a[0])) return a[1];
  }
  return nullptr;
}

/// The attribute's whole number, if it is at least `least`; else it is noted as a contradiction.
std::int64_t integer(const char** attributes, const char* wanted, std::int64_t otherwise,
                     std::int64_t least, OmePixels& pixels) {
  const char* text = find(attributes, wanted);
  if (!text) return otherwise;
  const auto value = whole_number(text);
  if (value && *value >= least) return *value;
  if (pixels.contradiction.empty())
    pixels.contradiction = std::string(wanted) + "=\"" + text + "\"";
  return otherwise;
}

void start_pixels(const char** attributes, OmePixels& pixels) {
  if (const char* order = find(attributes, "DimensionOrder")) pixels.dimension_order = order;
  std::string axes = pixels.dimension_order;
  std::sort(axes.begin(), axes.end());
  if (axes != "CTXYZ") pixels.contradiction = "DimensionOrder=\"" + pixels.dimension_order + "\"";
  pixels.size_x = integer(attributes, "SizeX", 0, 1, pixels);
  pixels.size_y = integer(attributes, "SizeY", 0, 1, pixels);
  pixels.size_z = integer(attributes, "SizeZ", 1, 1, pixels);
  pixels.size_c = integer(attributes, "SizeC", 1, 1, pixels);
  pixels.size_t = integer(attributes, "SizeT", 1, 1, pixels);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string attribute = std::string("PhysicalSize") + "XYZ"[axis];
    if (const char* size = find(attributes, attribute)) {
      pixels.physical_size[axis] = to_real(trimmed(size));
      if (!pixels.physical_size[axis])
        pixels.notes.push_back("the OME attribute " + attribute + ", \"" + printable(size) +
                               "\", is no number; not used");
    }
    if (const char* unit = find(attributes, attribute + "Unit")) pixels.physical_unit[axis] = unit;
  }
}

OmePlanes tiff_data(const char** attributes, OmePixels& pixels) {
  OmePlanes planes;
  planes.page = integer(attributes, "IFD", 0, 0, pixels);
  planes.first_z = integer(attributes, "FirstZ", 0, 0, pixels);
  planes.first_c = integer(attributes, "FirstC", 0, 0, pixels);
  planes.first_t = integer(attributes, "FirstT", 0, 0, pixels);
  // The standard: with an IFD but no PlaneCount, one plane; with neither, all.
  planes.count = integer(attributes, "PlaneCount", find(attributes, "IFD") ? 1 : -1, 0, pixels);
  return planes;
}

void start(void* user, const char* name, const char** attributes) {
  State& state = *static_cast<State*>(user);
  const std::string tag = local_name(name);
  if (tag == "OME") {
    if (const char* uuid = find(attributes, "UUID")) state.uuid = uuid;
  }
  if (tag == "BinaryOnly") {
    const char* const file = find(attributes, "MetadataFile");
    state.metadata = file ? printable(file) : "another file";
  }
  if (tag == "Pixels") ++state.images;
  if (state.finished) return;
  if (tag == "Pixels" && !state.pixels) {
    start_pixels(attributes, state.pixels.emplace());
  } else if (tag == "TiffData" && state.pixels) {
    state.pixels->planes.push_back(tiff_data(attributes, *state.pixels));
    state.in_tiff_data = true;
  } else if (tag == "UUID" && state.in_tiff_data) {
    if (const char* file = find(attributes, "FileName")) state.pixels->planes.back().file = file;
    state.in_uuid = true;
  }
}

void text(void* user, const char* characters, int length) {
  State& state = *static_cast<State*>(user);
  if (!state.in_uuid || state.finished) return;
  for (const char c : std::string(characters, static_cast<std::size_t>(length))) {
    if (!std::strchr(" \t\r\n", c)) state.pixels->planes.back().uuid += c;
  }
}

void end(void* user, const char* name) {
  State& state = *static_cast<State*>(user);
  const std::string tag = local_name(name);
  if (tag == "Pixels") state.finished = state.pixels.has_value();
  if (tag == "TiffData") state.in_tiff_data = false;
  if (tag == "UUID") state.in_uuid = false;
}

/// \param encoding  that overrules the document's own; null: its own
std::optional<OmePixels> parse(const std::string& xml, const char* encoding, std::string& problem,
                               bool& wrong_bytes) {
  State state;
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(encoding), &XML_ParserFree);
  XML_SetUserData(parser.get(), &state);
  XML_SetElementHandler(parser.get(), start, end);
  XML_SetCharacterDataHandler(parser.get(), text);
  const bool parsed =
      xml.size() <= std::numeric_limits<int>::max() &&
      XML_Parse(parser.get(), xml.data(), static_cast<int>(xml.size()), 1) == XML_STATUS_OK;
  wrong_bytes = !parsed && XML_GetErrorCode(parser.get()) == XML_ERROR_INVALID_TOKEN;
  if (!parsed) {
    const char* const reason = XML_ErrorString(XML_GetErrorCode(parser.get()));
    problem = std::string("is broken (") + (reason ? reason : "too long") + ")";
    return std::nullopt;
  }
  if (!state.pixels) {
    problem = state.metadata.empty() ? "has no Pixels element"
                                     : "leaves the description to " + state.metadata;
    return std::nullopt;
  }
  state.pixels->uuid = state.uuid;
  state.pixels->images = state.images;
  return state.pixels;
}

/// The next plane in an order such as "XYCZT"; beyond the last, the slowest index leaves its size.
void advance(const std::string& order, const std::array<std::int64_t, 3>& sizes,
             std::array<std::int64_t, 3>& at) {
  std::size_t slowest = 0;
  for (const char name : order) {
    const std::size_t axis = std::string("ZCT").find(name);
    if (axis == std::string::npos) continue;
    if (++at[axis] < sizes[axis]) return;
    at[axis] = 0;
    slowest = axis;
  }
  at[slowest] = sizes[slowest];
}

}  // namespace

std::optional<OmePixels> read_ome_xml(const std::string& xml, std::string& problem) {
  bool wrong_bytes = false;
  std::optional<OmePixels> pixels = parse(xml, nullptr, problem, wrong_bytes);
  if (!pixels && wrong_bytes) {
    std::string still;
    pixels = parse(xml, "ISO-8859-1", still, wrong_bytes);
    if (pixels) pixels->is_latin1 = true;
  }
  return pixels;
}

std::vector<OmePlanes> planes_of_file(const OmePixels& pixels, const std::string& name,
                                      std::string& note) {
  if (pixels.planes.empty()) return {OmePlanes{}};
  const auto those = [&](const auto& lie_here) {
    std::vector<OmePlanes> found;
    std::copy_if(pixels.planes.begin(), pixels.planes.end(), std::back_inserter(found), lie_here);
    return found;
  };
  // A file keeps its identifier when it is renamed; where there is none, its name must do.
  std::vector<OmePlanes> found = those([&](const OmePlanes& planes) {
    return planes.file.empty() || (!pixels.uuid.empty() && planes.uuid == pixels.uuid);
  });
  if (found.empty()) found = those([&](const OmePlanes& planes) { return planes.file == name; });
  const std::string& first = pixels.planes.front().file;
  if (found.empty()) {
    const auto others = those([&](const OmePlanes& planes) { return planes.file != first; });
    if (others.empty()) found = pixels.planes;
  }
  if (!found.empty() && !found.front().file.empty() && found.front().file != name)
    note = "its OME-XML calls it " + found.front().file + "; it was renamed";
  return found;
}

std::vector<std::int64_t> pages_of_frame(const OmePixels& pixels,
                                         const std::vector<OmePlanes>& planes,
                                         std::int64_t channels, std::int64_t samples,
                                         std::int64_t pages, std::int64_t channel,
                                         std::int64_t frame) {
  std::vector<std::int64_t> page_of(static_cast<std::size_t>(pixels.size_z), -1);
  const std::array<std::int64_t, 3> sizes{pixels.size_z, channels, pixels.size_t};
  for (const OmePlanes& entry : planes) {
    std::array<std::int64_t, 3> at{entry.first_z, entry.first_c / samples, entry.first_t};
    for (std::int64_t i = 0; i != entry.count; ++i) {
      const bool inside = at[0] < sizes[0] && at[1] < sizes[1] && at[2] < sizes[2];
      if (!inside || entry.page + i >= pages) break;
      if (at[1] == channel && at[2] == frame)
        page_of[static_cast<std::size_t>(at[0])] = entry.page + i;
      advance(pixels.dimension_order, sizes, at);
    }
  }
  return page_of;
}

}  // namespace stroma::image
