// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/ZarrHeader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/HeaderText.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/VolumeHeader.hpp"
#include "stroma/image/formats/WholeNumber.hpp"

namespace stroma::image {
namespace {

using Json = nlohmann::json;

/// The JSON of a text, but for what lies too deep in it to mean anything, which nlohmann's printing
/// could not take; discarded if the text is none.
Json parsed(const std::string& text) {
  constexpr int deepest = 16;
  return Json::parse(
      text, [](int depth, Json::parse_event_t, const Json&) { return depth < deepest; }, false);
}

/// A JSON file, and the errors about it.
class Head {
 public:
  Head(std::string path, std::string file, const std::string& text)
      : path_(std::move(path)), file_(std::move(file)), json_(parsed(text)) {
    if (!json_.is_object()) refuse(path_, "is broken: its " + file_ + " is no JSON object");
  }

  /// \throws base::InputError  "its .zarray says shape = 3; admissible: ..."
  [[noreturn]] void refuse_entry(const std::string& name, const Json& found,
                                 const std::string& admissible) const {
    const std::string text = found.is_discarded()
                                 ? "nothing"
                                 : found.dump(-1, ' ', true, Json::error_handler_t::replace);
    refuse(path_, "its " + file_ + " says " + name + " = " + printable(text) +
                      "; admissible: " + admissible);
  }
  /// The entry, null where there is none.
  const Json& at(const Json& object, const char* name) const {
    static const Json none = nullptr;
    const auto found = object.find(name);
    return found == object.end() ? none : *found;
  }
  const Json& at(const char* name) const { return at(json_, name); }

  std::vector<std::int64_t> sizes(const char* name) const {
    const std::string admissible =
        base::format("a list of 1 to %d whole numbers, each 1 to 10^9", most_dimensions);
    const Json& list = at(name);
    if (!list.is_array() || list.empty() || list.size() > most_dimensions)
      refuse_entry(name, list, admissible);
    std::vector<std::int64_t> sizes;
    for (const Json& one : list) {
      const bool is_good = one.is_number_integer() &&
                           (!one.is_number_unsigned() ||
                            one.get<std::uint64_t>() <= static_cast<std::uint64_t>(largest_count));
      sizes.push_back(is_good ? one.get<std::int64_t>() : 0);
      if (sizes.back() < 1 || sizes.back() > largest_count) refuse_entry(name, list, admissible);
    }
    return sizes;
  }

 private:
  std::string path_, file_;
  Json json_;
};

void read_type(const Head& head, ZarrArray& array) {
  const Json& dtype = head.at("dtype");
  const std::string text = dtype.is_string() ? dtype.get<std::string>() : "";
  const std::string admissible =
      "integers (i1, i2, i4, i8, u1, u2, u4, u8), floats (f2, f4, f8) and b1, behind <, > or |";
  if (text.size() != 3 || std::string("<>|").find(text[0]) == std::string::npos)
    head.refuse_entry("dtype", dtype, admissible);
  using Kind = ValueType::Kind;
  const int bytes = text[2] - '0';
  array.type.bytes = bytes;
  array.type.kind = text[1] == 'f'   ? Kind::floating
                    : text[1] == 'i' ? Kind::signed_integer
                                     : Kind::unsigned_integer;
  const bool is_size = bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8;
  const bool is_good = (text[1] == 'f' && is_size && bytes > 1) ||
                       ((text[1] == 'i' || text[1] == 'u') && is_size) ||
                       (text[1] == 'b' && bytes == 1);
  if (!is_good || (text[0] == '|' && bytes > 1)) head.refuse_entry("dtype", dtype, admissible);
  array.is_swapped = text[0] == '>' && bytes > 1;
}

void read_compressor(const Head& head, ZarrArray& array) {
  const Json& filters = head.at("filters");
  if (!filters.is_null() && !(filters.is_array() && filters.empty()))
    head.refuse_entry("filters", filters, "null: values that are packed but not altered");
  const Json& compressor = head.at("compressor");
  if (compressor.is_null()) return;
  const Json& id = compressor.is_object() ? head.at(compressor, "id") : compressor;
  if (id == "zlib" || id == "gzip")
    array.compression = Compression::zlib;
  else if (id == "zstd")
    array.compression = Compression::zstd;
  else if (id == "blosc")
    array.compression = Compression::blosc;
  else
    head.refuse_entry("compressor", compressor, "null, zlib, gzip, zstd and blosc");
}

void read_fill(const Head& head, ZarrArray& array) {
  const Json& fill = head.at("fill_value");
  if (fill.is_number()) {
    array.fill = fill.get<double>();
  } else if (fill.is_boolean()) {
    array.fill = fill.get<bool>() ? 1.0 : 0.0;
  } else if (fill == "NaN") {
    array.fill = std::numeric_limits<double>::quiet_NaN();
  } else if (fill == "Infinity" || fill == "-Infinity") {
    array.fill = fill == "Infinity" ? HUGE_VAL : -HUGE_VAL;
  } else if (!fill.is_null()) {
    head.refuse_entry("fill_value", fill, "a number, \"NaN\", \"Infinity\", \"-Infinity\", null");
  }
}

/// Multiplies the axes' scales by those of a list of coordinateTransformations.
void scale_axes(const Head& head, const Json& transformations, std::vector<ZarrAxis>& axes) {
  if (!transformations.is_array()) return;
  for (const Json& one : transformations) {
    if (!one.is_object() || head.at(one, "type") != "scale") continue;
    const Json& scale = head.at(one, "scale");
    const bool is_good =
        scale.is_array() && scale.size() == axes.size() &&
        std::all_of(scale.begin(), scale.end(), [](const Json& s) { return s.is_number(); });
    if (!is_good) head.refuse_entry("scale", scale, "a number for each of the axes");
    for (std::size_t d = 0; d < axes.size(); ++d) {
      double& so_far = axes[d].scale;
      so_far = (so_far == 0.0 ? 1.0 : so_far) * scale[d].get<double>();
    }
  }
}

/// The folder of a level, within that of the image.
std::string array_folder(const Head& head, const Json& datasets, const Json& dataset) {
  const Json& path = dataset.is_object() ? head.at(dataset, "path") : dataset;
  if (!dataset.is_object() || !path.is_string())
    head.refuse_entry("multiscales[0].datasets", datasets, "a list of levels, each with a path");
  const auto folder = path.get<std::string>();
  const bool leads_away = folder.empty() || folder.front() == '/' ||
                          folder.find("..") != std::string::npos ||
                          folder.find('\0') != std::string::npos;
  if (leads_away) head.refuse_entry("path", path, "a folder within that of the image");
  return folder;
}

std::vector<ZarrAxis> read_axes(const Head& head, const Json& image) {
  const Json& list = head.at(image, "axes");
  if (list.is_null()) return {};
  const std::string admissible = "a list of names or of objects with a name";
  if (!list.is_array() || list.empty() || list.size() > most_dimensions)
    head.refuse_entry("axes", list, admissible);
  std::vector<ZarrAxis> axes;
  for (const Json& one : list) {
    const Json& name = one.is_object() ? head.at(one, "name") : one;
    if (!name.is_string()) head.refuse_entry("axes", list, admissible);
    const std::string key = lower_case(name.get<std::string>());
    ZarrAxis axis;
    if (key.size() == 1 && std::string("xyzct").find(key) != std::string::npos) axis.key = key[0];
    if (one.is_object() && head.at(one, "unit").is_string())
      axis.unit = head.at(one, "unit").get<std::string>();
    axes.push_back(axis);
  }
  return axes;
}

}  // namespace

double ZarrArray::values() const {
  double values = 1.0;
  for (const std::int64_t size : shape) values *= static_cast<double>(size);
  return values;
}

double ZarrArray::chunk_bytes() const {
  double bytes = type.bytes;
  for (const std::int64_t size : chunk) bytes *= static_cast<double>(size);
  return bytes;
}

ZarrArray zarr_array(const std::string& path, const std::string& text) {
  const Head head(path, ".zarray", text);
  if (head.at("zarr_format") != 2) head.refuse_entry("zarr_format", head.at("zarr_format"), "2");
  ZarrArray array;
  array.shape = head.sizes("shape");
  array.chunk = head.sizes("chunks");
  if (array.chunk.size() != array.shape.size())
    head.refuse_entry("chunks", head.at("chunks"), "as many numbers as shape has");
  read_type(head, array);
  read_compressor(head, array);
  read_fill(head, array);
  const Json& order = head.at("order");
  if (order != "C" && order != "F") head.refuse_entry("order", order, "\"C\" and \"F\"");
  array.is_columnar = order == "F";
  const Json& separator = head.at("dimension_separator");
  if (!separator.is_null() && separator != "." && separator != "/")
    head.refuse_entry("dimension_separator", separator, "\".\" and \"/\"");
  array.separator = separator == "/" ? '/' : '.';
  return array;
}

std::optional<ZarrImage> zarr_image(const std::string& path, const std::string& text) {
  const Head head(path, ".zattrs", text);
  const Json& list = head.at("multiscales");
  if (list.is_null()) return std::nullopt;
  if (!list.is_array() || list.empty() || !list.front().is_object())
    head.refuse_entry("multiscales", list, "a list of images");
  const Json& image = list.front();
  const Json& datasets = head.at(image, "datasets");
  if (!datasets.is_array() || datasets.empty())
    head.refuse_entry("multiscales[0].datasets", datasets, "a list of levels, each with a path");
  ZarrImage found;
  found.images = list.size();
  const Json& version = head.at(image, "version");
  if (version.is_string()) found.version = printable(version.get<std::string>());
  const std::vector<ZarrAxis> axes = read_axes(head, image);
  for (const Json& dataset : datasets) {
    ZarrLevel level{array_folder(head, datasets, dataset), axes};
    scale_axes(head, head.at(dataset, "coordinateTransformations"), level.axes);
    scale_axes(head, head.at(image, "coordinateTransformations"), level.axes);
    found.levels.push_back(std::move(level));
  }
  return found;
}

std::vector<ZarrAxis> array_axes(const std::string& path, const std::string& text,
                                 std::vector<std::string>& notes) {
  const Head head(path, ".zattrs", text);
  for (const char* const name : linear_map_attributes)
    if (head.at(name).is_number()) notes.push_back(not_applied(name));
  const Json& names = head.at("_ARRAY_DIMENSIONS");
  std::vector<ZarrAxis> axes;
  if (!names.is_array() || names.size() > most_dimensions) return axes;
  for (const Json& name : names) {
    const std::string label = name.is_string() ? lower_case(name.get<std::string>()) : "";
    ZarrAxis axis;
    axis.key = label == "channel"  ? 'c'
               : label == "time"   ? 't'
               : label.size() == 1 ? label[0]
                                   : '?';
    if (std::string("xyzct").find(axis.key) == std::string::npos) {
      notes.push_back("_ARRAY_DIMENSIONS are none of x, y, z, c, t everywhere; not used");
      return {};
    }
    axes.push_back(axis);
  }
  return axes;
}

bool is_zarr_series(const std::string& text) {
  const Json json = parsed(text);
  return json.is_object() && json.contains("bioformats2raw.layout");
}

}  // namespace stroma::image
