/// \file
/// How the pages of a TIFF file stack up to a volume: plain stacks, ImageJ's (hyper)stacks,
/// OME-TIFF.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>

#include "base/Log.hpp"
#include "image/ImageSource.hpp"
#include "image/LengthUnit.hpp"
#include "image/OmeXml.hpp"
#include "image/TiffPages.hpp"

namespace stroma::image {
namespace {

/// "key=value" lines of ImageJ's description.
std::map<std::string, std::string> imagej_settings(const std::string& description) {
  std::map<std::string, std::string> settings;
  std::istringstream lines(description);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos)
      settings.emplace(line.substr(0, equals), line.substr(equals + 1));
  }
  return settings;
}

/// 1 / resolution. Where a decimal of at most 6 digits gives the same tag, up to the rounding of
/// its writer, it is that decimal: 952381 / 1000000 pixels per micron is 1.05 um, not 1.0499999475.
double length_of_pixel(double resolution, double rounding) {
  const double length = 1.0 / resolution;
  for (int digits = 1; digits <= 6; ++digits) {
    const double candidate = std::strtod(base::format("%.*g", digits, length).c_str(), nullptr);
    if (std::abs(1.0 / candidate - resolution) <= rounding) return candidate;
  }
  return length;
}

class TiffSource : public ImageSource {
 public:
  explicit TiffSource(const ImageRequest& request) : pages_(request.path) {
    summary_.path = request.path;
    summary_.channel = request.channel;
    summary_.frame = request.frame;
    check_pages();
    const std::string& description = pages_.tags().description;
    if (description.compare(0, 7, "ImageJ=") == 0) {
      stack_imagej(imagej_settings(description));
    } else if (description.find("<OME") != std::string::npos ||
               description.find(":OME ") != std::string::npos) {
      stack_ome(description);
    } else {
      stack_plain();
    }
    check_channel(request.path, request.channel, summary_.channels);
    for (std::int64_t z = 0; z < summary_.file_size[2] && !in_one_piece_; ++z)
      pages_.check_extent(page_of(z));
  }

  void read(const Box& box, double* values) override {
    if (in_one_piece_) return read_one_piece(box, values);
    const std::int64_t sample = summary_.channel % first_page().samples;
    for (std::int64_t k = 0; k < box.count[2]; ++k) {
      pages_.read(page_of(box.first[2] + k), sample, box.first[0], box.count[0], box.first[1],
                  box.count[1], values + k * box.count[0] * box.count[1]);
    }
  }

 private:
  const TiffPage& first_page() const { return pages_.pages().front(); }
  std::int64_t page_count() const { return static_cast<std::int64_t>(pages_.pages().size()); }
  std::int64_t page_channels() const { return summary_.channels / first_page().samples; }

  /// The page that holds plane z of the channel read.
  std::size_t page_of(std::int64_t z) const {
    const std::int64_t c = summary_.channel / first_page().samples;
    return page_of_plane_[static_cast<std::size_t>(z * page_channels() + c)];
  }

  void check_pages() {
    const TiffPage& first = first_page();
    if (!first.trouble.empty()) {
      refuse(
          summary_.path,
          first.trouble +
              "; admissible: real values, integers of 8, 16 or 32 bits or floats of 32 or 64 bits");
    }
    const double expansion = first.compression == COMPRESSION_NONE ? 1.0 : largest_expansion;
    check_size(summary_.path, {first.width, first.height, page_count()}, first.samples,
               first.type.bytes, pages_.file_length(), expansion);
    for (std::size_t i = 1; i < pages_.pages().size(); ++i) {
      const TiffPage& page = pages_.pages()[i];
      const bool same = page.width == first.width && page.height == first.height &&
                        page.samples == first.samples && page.type.kind == first.type.kind &&
                        page.type.bytes == first.type.bytes;
      if (same && page.trouble.empty()) continue;
      refuse(
          summary_.path,
          base::format("page %zu is %lld x %lld pixels of %lld %s; page 0 is %lld x %lld of %lld "
                       "%s; admissible: pages "
                       "of one kind",
                       i, static_cast<long long>(page.width), static_cast<long long>(page.height),
                       static_cast<long long>(page.samples), page.type.name().c_str(),
                       static_cast<long long>(first.width), static_cast<long long>(first.height),
                       static_cast<long long>(first.samples), first.type.name().c_str()));
    }
    summary_.type = first.type;
  }

  void set_size(std::int64_t planes, std::int64_t stacked_channels) {
    summary_.file_size = {first_page().width, first_page().height, planes};
    summary_.channels = stacked_channels * first_page().samples;
  }

  void set_frames(std::int64_t frames) {
    summary_.frames = frames;
    check_frame(summary_.path, summary_.frame, frames);
  }

  void stack_plain() {
    summary_.format = page_count() == 1 ? "TIFF" : "TIFF, multi-page";
    set_size(page_count(), 1);
    for (std::int64_t i = 0; i < page_count(); ++i)
      page_of_plane_.push_back(static_cast<std::size_t>(i));
    take_resolution_by_tag_unit();
  }

  void stack_imagej(const std::map<std::string, std::string>& settings) {
    const auto integer = [&](const char* key, std::int64_t otherwise) -> std::int64_t {
      const auto found = settings.find(key);
      return found == settings.end() ? otherwise : std::strtoll(found->second.c_str(), nullptr, 10);
    };
    const std::int64_t images = integer("images", page_count());
    const std::int64_t channels = integer("channels", 1), frames = integer("frames", 1);
    if (channels < 1 || frames < 1 || images < 1)
      refuse(summary_.path, "has senseless ImageJ tags (no images)");
    const std::int64_t slices = integer("slices", images / (channels * frames));
    if (slices * channels * frames != images) {
      refuse(
          summary_.path,
          base::format("its ImageJ tags speak of %lld images, but of %lld channels x %lld slices",
                       static_cast<long long>(images), static_cast<long long>(channels),
                       static_cast<long long>(slices)));
    }
    summary_.format = channels > 1 ? "TIFF, ImageJ hyperstack"
                      : images > 1 ? "TIFF, ImageJ stack"
                                   : "TIFF, ImageJ";
    set_frames(frames);
    set_size(slices, channels);
    if (page_count() == 1 && images > 1) {
      use_one_piece(images);
    } else if (page_count() != images) {
      refuse(
          summary_.path,
          base::format("its ImageJ tags speak of %lld images, but it holds %lld pages (truncated?)",
                       static_cast<long long>(images), static_cast<long long>(page_count())));
    }
    for (std::int64_t i = 0; i < slices * channels && !in_one_piece_; ++i)
      page_of_plane_.push_back(static_cast<std::size_t>(first_plane() + i));
    take_imagej_calibration(settings);
  }

  /// Pages of an ImageJ hyperstack before those of the frame read: the order is channel, slice,
  /// frame.
  std::int64_t first_plane() const {
    return summary_.frame * summary_.file_size[2] * page_channels();
  }

  /// ImageJ writes stacks of more than 4 GB with the directory of the first page alone; the planes
  /// follow it.
  void use_one_piece(std::int64_t images) {
    const TiffPage& page = first_page();
    const auto start = pages_.start_of_values(0);
    if (!start || page.samples != 1) {
      refuse(summary_.path,
             base::format("its ImageJ tags speak of %lld images, but it holds 1 page (truncated?)",
                          static_cast<long long>(images)));
    }
    check_size(summary_.path, {page.width, page.height, images}, 1, page.type.bytes,
               pages_.file_length() - std::min(*start, pages_.file_length()), 1.0);
    in_one_piece_ = true;
    start_ = *start;
  }

  void read_one_piece(const Box& box, double* values) const {
    const std::array<std::int64_t, 3> all{
        summary_.file_size[0], summary_.file_size[1],

        summary_.frames * summary_.file_size[2] * summary_.channels};
    for (std::int64_t k = 0; k < box.count[2]; ++k) {
      Box plane = box;
      plane.first[2] = first_plane() + (box.first[2] + k) * summary_.channels + summary_.channel;
      plane.count[2] = 1;
      read_raw(summary_.path, start_, summary_.type, pages_.is_swapped(), all, plane,
               values + k * box.count[0] * box.count[1]);
    }
  }

  void stack_ome(const std::string& description) {
    summary_.format = "OME-TIFF";
    std::string problem;
    const std::optional<OmePixels> ome = read_ome_xml(description, problem);
    if (!ome)
      refuse(summary_.path,
             "has a broken OME-XML description" + (problem.empty() ? "" : " (" + problem + ")"));
    set_frames(std::max<std::int64_t>(ome->size_t, 1));
    const std::int64_t samples = first_page().samples;
    const std::int64_t z_size = std::max<std::int64_t>(ome->size_z, 1);
    const std::int64_t c_size = std::max<std::int64_t>(ome->size_c / samples, 1);
    if (ome->size_x != first_page().width || ome->size_y != first_page().height) {
      refuse(summary_.path,
             base::format("its OME-XML says %lld x %lld pixels, its pages have %lld x %lld",
                          static_cast<long long>(ome->size_x), static_cast<long long>(ome->size_y),
                          static_cast<long long>(first_page().width),
                          static_cast<long long>(first_page().height)));
    }
    if (z_size > page_count() || c_size > page_count() || z_size * c_size > page_count()) {
      refuse(summary_.path,
             base::format("its OME-XML says %lld planes in %lld channels, but it holds %lld pages "
                          "(truncated, or part of "
                          "a set of files)",
                          static_cast<long long>(z_size), static_cast<long long>(c_size),
                          static_cast<long long>(page_count())));
    }
    set_size(z_size, c_size);
    deal_ome_pages(*ome, z_size, c_size);
    for (int axis = 0; axis < 3; ++axis) take_ome_size(*ome, axis);
  }

  /// Takes the pages of the frame read from the planes that the description deals out, in its
  /// order of dimensions.
  void deal_ome_pages(const OmePixels& ome, std::int64_t z_size, std::int64_t c_size) {
    const std::size_t no_page = pages_.pages().size();
    page_of_plane_.assign(static_cast<std::size_t>(z_size * c_size), no_page);
    const std::string own_name = std::filesystem::path(summary_.path).filename().string();
    const std::vector<OmePlanes> all{OmePlanes{}};
    const std::array<std::int64_t, 3> sizes{z_size, c_size, summary_.frames};
    for (const OmePlanes& planes : ome.planes.empty() ? all : ome.planes) {
      if (!planes.file.empty() && planes.file != own_name) continue;
      std::array<std::int64_t, 3> at{planes.first_z, planes.first_c / first_page().samples,
                                     planes.first_t};  // z, c, t
      for (std::int64_t i = 0; i != planes.count; ++i) {
        const std::int64_t page = planes.page + i;
        const bool inside = at[0] >= 0 && at[0] < z_size && at[1] >= 0 && at[1] < c_size &&
                            at[2] >= 0 && at[2] < summary_.frames;
        if (!inside || page < 0 || page >= page_count()) break;
        if (at[2] == summary_.frame)
          page_of_plane_[static_cast<std::size_t>(at[0] * c_size + at[1])] =
              static_cast<std::size_t>(page);
        advance(ome.dimension_order, sizes, at);
      }
    }
    const auto missing = std::find(page_of_plane_.begin(), page_of_plane_.end(), no_page);
    if (missing != page_of_plane_.end()) {
      const auto index = static_cast<long long>(missing - page_of_plane_.begin());
      refuse(summary_.path,
             base::format("its OME-XML names no page of this file for plane %lld of channel %lld",
                          index / static_cast<long long>(c_size),
                          index % static_cast<long long>(c_size)));
    }
  }

  /// The next plane in an order such as "XYCZT"; beyond the last, its slowest index leaves its
  /// size.
  static void advance(const std::string& order, const std::array<std::int64_t, 3>& sizes,
                      std::array<std::int64_t, 3>& at) {
    std::size_t axis = 0;
    for (const char name : order) {
      axis = std::string("ZCT").find(name);
      if (axis > 2) continue;
      if (++at[axis] < sizes[axis]) return;
      at[axis] = 0;
    }
    if (axis < 3) at[axis] = sizes[axis];
  }

  void take_ome_size(const OmePixels& ome, int axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (!ome.physical_size[a] || !(*ome.physical_size[a] > 0.0)) return;
    if (const auto scale = micrometres_per(ome.physical_unit[a])) {
      summary_.voxel_size.set(axis, *ome.physical_size[a] * *scale, "OME attributes");
    } else {
      summary_.notes.push_back("the OME attributes give the voxel size in \"" +
                               ome.physical_unit[a] +
                               "\", which is no unit of length known here; not used");
    }
  }

  void take_imagej_calibration(const std::map<std::string, std::string>& settings) {
    const auto text = [&](const char* key, const std::string& otherwise) {
      const auto found = settings.find(key);
      return found == settings.end() ? otherwise : found->second;
    };
    const std::string unit = text("unit", "");
    if (!micrometres_per(unit)) {
      if (!unit.empty() && unit != "pixel" && unit != "pixels")
        summary_.notes.push_back("ImageJ's unit \"" + unit +
                                 "\" is no unit of length known here; not used");
      take_resolution_by_tag_unit();
      return;
    }
    const TiffTags& tags = pages_.tags();
    take_resolution(0, tags.pixels_per_unit_x, tags.rounding_x, micrometres_per(unit), unit,
                    "ImageJ tags");
    take_resolution(1, tags.pixels_per_unit_y, tags.rounding_y,
                    micrometres_per(text("yunit", unit)), unit, "ImageJ tags");
    const double spacing = std::strtod(text("spacing", "0").c_str(), nullptr);
    const auto z_scale = micrometres_per(text("zunit", unit));
    if (spacing > 0.0 && std::isfinite(spacing) && z_scale) {
      summary_.voxel_size.set(2, spacing * *z_scale, "ImageJ tags");
    } else if (spacing != 0.0) {
      summary_.notes.push_back("ImageJ's spacing \"" + text("spacing", "") +
                               "\" is not positive; not used");
    }
  }

  void take_resolution_by_tag_unit() {
    const TiffTags& tags = pages_.tags();
    if (tags.resolution_unit == RESUNIT_NONE) return;
    const bool inch = tags.resolution_unit == RESUNIT_INCH;
    const std::optional<double> scale = inch ? 25400.0 : 1e4;
    const char* unit = inch ? "inch" : "cm";
    take_resolution(0, tags.pixels_per_unit_x, tags.rounding_x, scale, unit,
                    "TIFF resolution tags");
    take_resolution(1, tags.pixels_per_unit_y, tags.rounding_y, scale, unit,
                    "TIFF resolution tags");
  }

  /// Resolutions of printers and screens are no calibration.
  void take_resolution(int axis, const std::optional<double>& resolution, double rounding,
                       const std::optional<double>& scale, const std::string& unit,
                       const std::string& place) {
    if (!resolution || !scale) return;
    const double per_inch = *resolution * 25400.0 / *scale;
    const bool printer = (place != "ImageJ tags" || unit == "inch") && per_inch < 1300.0;
    if (printer) {
      if (axis == 0)
        summary_.notes.push_back(
            base::format("%g pixels per %s is a printer's or a screen's resolution; not used",
                         *resolution, unit.c_str()));
      return;
    }
    summary_.voxel_size.set(axis, length_of_pixel(*resolution, rounding) * *scale, place);
  }

  TiffPages pages_;
  std::vector<std::size_t> page_of_plane_;  ///< (z * page channels + c)
  bool in_one_piece_ = false;
  std::uint64_t start_ = 0;
};

}  // namespace

std::unique_ptr<ImageSource> open_tiff(const ImageRequest& request) {
  return std::make_unique<TiffSource>(request);
}

}  // namespace stroma::image
