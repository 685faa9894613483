// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// How the pages of a TIFF file stack up to a volume: plain stacks, ImageJ's (hyper)stacks,
/// OME-TIFF, MetaMorph's and Zeiss' stacks.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/ImageJDescription.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/MicroscopeTags.hpp"
#include "stroma/image/formats/OmeXml.hpp"
#include "stroma/image/formats/TiffLengths.hpp"
#include "stroma/image/formats/TiffPages.hpp"
#include "stroma/image/formats/WholeNumber.hpp"

namespace stroma::image {
namespace {

/// What tifffile says of the array in a description of its own: {"shape": [6, 10, 14], "axes": "ZYX"}.
struct ShapedDescription {
  std::vector<std::int64_t> shape;  ///< slowest first; empty: not stated
  std::string axes;                 ///< a letter each; empty: not stated

  /// The count of an axis; 1 where there is none.
  std::int64_t count(char axis) const {
    const std::size_t place = axes.find(axis);
    return place == std::string::npos ? 1 : shape[place];
  }
  /// Planes from one to the next along an axis, those of Y, X and S being one.
  std::int64_t stride(char axis) const {
    std::int64_t planes = 1;
    for (std::size_t d = axes.size(); d-- > 0 && axes[d] != axis;)
      if (std::string("YXS").find(axes[d]) == std::string::npos) planes *= shape[d];
    return planes;
  }
};

ShapedDescription tifffile_description(const std::string& description) {
  ShapedDescription found;
  if (description.empty() || description.front() != '{') return found;
  using Json = nlohmann::json;
  constexpr int deepest = 4;
  const Json json = Json::parse(
      description, [](int depth, Json::parse_event_t, const Json&) { return depth < deepest; },
      false);
  if (!json.is_object() || !json.contains("shape") || !json["shape"].is_array()) return found;
  for (const Json& count : json["shape"])
    found.shape.push_back(count.is_number_integer() && count > 0 && count <= largest_count
                              ? count.get<std::int64_t>()
                              : 0);
  if (!json.contains("axes") || !json["axes"].is_string()) return found;
  const auto axes = json["axes"].get<std::string>();
  std::string sorted = axes;
  std::sort(sorted.begin(), sorted.end());
  const bool are_known = axes.find_first_not_of("TZCYXS") == std::string::npos &&
                         std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  if (are_known && axes.size() == found.shape.size()) found.axes = axes;
  return found;
}

class TiffSource : public ImageSource {
 public:
  explicit TiffSource(const ImageRequest& request) : pages_(request.path) {
    summary_.path = request.path;
    summary_.channel = request.channel;
    summary_.frame = request.frame;
    const std::string& description = pages_.tags().description;
    const bool is_ome = !is_imagej(description) && (description.find("<OME") != std::string::npos ||
                                                    description.find(":OME ") != std::string::npos);
    if (!is_ome) leave_out_extras();  // OME counts all of the file's pages
    TiffDirectory directory(request.path, pages_.pages().front().offset);
    if (is_imagej(description)) {
      stack_imagej(description);
    } else if (is_ome) {
      stack_ome(description);
    } else if (const auto stk = read_stk(directory)) {
      stack_metamorph(*stk);
    } else if (const auto lsm = read_lsm(directory)) {
      stack_zeiss(*lsm);
    } else {
      stack_plain();
    }
    check_pages_read();
    note_what_is_odd();
  }

  void read(const voxels::Box& box, double* values) override {
    const std::int64_t plane_voxels = box.count[0] * box.count[1];
    for (std::int64_t k = 0, run = 1; k < box.count[2]; k += run) {
      const std::int64_t plane = plane_of(box.first[2] + k);
      // Planes of one page are read together: they may lie in the same tiles.
      run = 1;
      while (k + run < box.count[2] && plane_of(box.first[2] + k + run) == plane + run &&
             (in_one_piece_ || page_of(plane + run) == page_of(plane)))
        ++run;
      voxels::Box part = box;
      part.first[2] = in_one_piece_ ? plane : plane % reference_.depth;
      part.count[2] = run;
      double* const to = values + k * plane_voxels;
      if (in_one_piece_) {
        read_raw(summary_.path, start_, reference_.type, pages_.is_swapped(),
                 {reference_.width, reference_.height, plane_count()}, part, to);
      } else {
        pages_.read(page_of(plane), summary_.channel % reference_.samples, part, to);
      }
    }
    if (intercept_ == 0.0 && slope_ == 1.0) return;
    for (double* value = values; value < values + box.voxels(); ++value)
      *value = intercept_ + slope_ * *value;
  }

 private:
  // Planes of the file are counted from page to page, and within a page along its depth.

  std::int64_t plane_count() const {
    return in_one_piece_ ? planes_in_piece_
                         : static_cast<std::int64_t>(pages_.pages().size()) * reference_.depth;
  }
  std::size_t page_of(std::int64_t plane) const {
    return static_cast<std::size_t>(plane / reference_.depth);
  }
  /// The plane of the file that is plane z of the channel and frame read.
  std::int64_t plane_of(std::int64_t z) const { return plane_of_[static_cast<std::size_t>(z)]; }
  /// The channel read, of those that are planes of their own.
  std::int64_t stacked_channel() const { return summary_.channel / reference_.samples; }

  /// The page that all others must be like.
  void refer_to(std::size_t page) {
    reference_ = pages_.pages()[page];
    if (!reference_.trouble.empty()) {
      refuse(summary_.path, reference_.trouble +
                                "; admissible: real values, integers of 1 to 16, 32 or 64 bits or "
                                "floats of 16, 32 or 64 bits");
    }
    summary_.type = reference_.type;
    if (reference_.depth > 1 && !reference_.tiled) {
      if (pages_.pages().size() > 1)
        refuse(summary_.path, "has several pages of several planes each; not supported");
      use_one_piece(reference_.depth, "its ImageDepth tag speaks");
    }
  }

  /// Sizes, once it is known that the file has these planes, of one channel at least.
  void set_size(std::int64_t planes, std::int64_t stacked_channels, std::int64_t frames) {
    summary_.file_size = {reference_.width, reference_.height, planes};
    summary_.channels = stacked_channels * reference_.samples;
    summary_.frames = frames;
    check_channel(summary_.path, summary_.channel, summary_.channels);
    check_frame(summary_.path, summary_.frame, frames);
    if (in_one_piece_) return;
    const double packing = 8.0 * reference_.type.bytes / reference_.bits;
    check_size(summary_.path, summary_.file_size, reference_.samples, reference_.type.bytes,
               pages_.file_length(), packing * largest_expansion_of(reference_));
  }

  /// Planes that follow one another: channel fastest, then z, then frame.
  void stack_in_order(std::int64_t planes, std::int64_t channels, std::int64_t frames) {
    set_size(planes, channels, frames);
    for (std::int64_t z = 0; z < planes; ++z)
      plane_of_.push_back((summary_.frame * planes + z) * channels + stacked_channel());
  }

  void check_pages_read() {
    if (in_one_piece_) return;
    for (std::int64_t z = 0; z < summary_.file_size[2]; ++z) {
      const std::size_t i = page_of(plane_of(z));
      const TiffPage& page = pages_.pages()[i];
      const TiffPage& like = reference_;
      const bool same = page.width == like.width && page.height == like.height &&
                        page.depth == like.depth && page.samples == like.samples &&
                        page.bits == like.bits && page.type.kind == like.type.kind &&
                        page.photometric == like.photometric;
      if (!same || !page.trouble.empty()) {
        refuse(summary_.path, base::format("page %zu is %s; the first is %s; admissible: pages of "
                                           "one kind",
                                           i, text_of(page).c_str(), text_of(like).c_str()));
      }
      pages_.check_pieces(i);
    }
  }

  static std::string text_of(const TiffPage& page) {
    return base::format("%lld x %lld pixels of %lld %s (photometric %d)",
                        static_cast<long long>(page.width), static_cast<long long>(page.height),
                        static_cast<long long>(page.samples), page.type.name().c_str(),
                        page.photometric);
  }

  void leave_out_extras() {
    const std::vector<TiffPage> out = pages_.leave_out_extras();
    const TiffPage& first = pages_.pages().front();
    const auto as_large = std::count_if(out.begin(), out.end(), [&](const TiffPage& page) {
      return page.width == first.width && page.height == first.height;
    });
    if (as_large > 0)
      summary_.notes.push_back(
          base::format("%lld pages as large as the first call themselves reduced images or masks "
                       "(NewSubfileType); they are not read",
                       static_cast<long long>(as_large)));
    if (first.is_extra)
      summary_.notes.push_back(
          "all its pages call themselves reduced images or masks (NewSubfileType); they are read");
  }

  void note_what_is_odd() {
    if (pages_.tags().orientation != ORIENTATION_TOPLEFT)
      summary_.notes.push_back(base::format(
          "its Orientation tag, %d, turns or mirrors the picture; x, y and z are those of "
          "the array, as stored",
          pages_.tags().orientation));
    if (reference_.bits % 8 != 0)
      summary_.notes.push_back(base::format("its values are packed to %d bits", reference_.bits));
    if (reference_.photometric == PHOTOMETRIC_MINISWHITE) {
      summary_.notes.push_back(
          "0 is white in this file (MinIsWhite); the values are those stored, as ImageJ states "
          "them: what looks dark has the larger value");
    }
    if (reference_.photometric == PHOTOMETRIC_PALETTE) {
      summary_.notes.push_back(
          "the values are those stored: indices into the file's table of colours, which need not "
          "rise with brightness");
    }
    const std::int64_t named =
        summary_.file_size[2] * summary_.frames * (summary_.channels / reference_.samples);
    if (named < plane_count() && images_ == 1) {
      summary_.notes.push_back(base::format(
          "%lld of the file's %lld planes are not in its description; they are not read",
          static_cast<long long>(plane_count() - named), static_cast<long long>(plane_count())));
    }
  }

  void stack_plain() {
    refer_to(0);
    const ShapedDescription shaped = tifffile_description(pages_.tags().description);
    const std::vector<std::int64_t>& shape = shaped.shape;
    double values = 1.0;
    for (const std::int64_t count : shape) values *= static_cast<double>(count);
    const double planes = values / static_cast<double>(reference_.width) /
                          static_cast<double>(reference_.height * reference_.samples);
    if (plane_count() == 1 && planes > 1.0 && planes == std::floor(planes) && planes < 1e9)
      use_one_piece(static_cast<std::int64_t>(planes), "its description speaks");
    if (shaped.axes.find('Y') != std::string::npos && planes == static_cast<double>(plane_count()))
      return stack_shaped(shaped);
    if (std::count_if(shape.begin(), shape.end(), [](auto n) { return n > 1; }) >
        3 + (reference_.samples > 1)) {
      std::string text;
      for (const std::int64_t count : shape)
        text += (text.empty() ? "" : " x ") + std::to_string(count);
      summary_.notes.push_back("its description gives the shape " + text +
                               ", without saying what the axes are; all planes are stacked");
    }
    note_bytes_behind();
    summary_.format = plane_count() == 1 ? "TIFF" : "TIFF, multi-page";
    stack_in_order(plane_count(), 1, 1);
    take_resolution_lengths(summary_, pages_.tags());
  }

  /// As the axes say that tifffile knows.
  void stack_shaped(const ShapedDescription& shaped) {
    summary_.format = "TIFF, " + shaped.axes;
    const std::int64_t planes = shaped.count('Z');
    set_size(planes, shaped.count('C'), shaped.count('T'));
    for (std::int64_t z = 0; z < planes; ++z)
      plane_of_.push_back(summary_.frame * shaped.stride('T') + z * shaped.stride('Z') +
                          stacked_channel() * shaped.stride('C'));
    take_resolution_lengths(summary_, pages_.tags());
  }

  /// More planes may follow the only page that has a directory, by a custom not known here.
  void note_bytes_behind() {
    constexpr std::uint64_t metadata = 65536;  // that much else may follow
    if (plane_count() > 1) return;
    const auto start = pages_.start_of_values(0);
    const auto page_bytes = static_cast<std::uint64_t>(reference_.width * reference_.height *
                                                       reference_.samples * reference_.bits / 8);
    if (!start || pages_.file_length() - *start < 2 * page_bytes + metadata) return;
    summary_.notes.push_back(
        base::format("%llu bytes follow the values of the only page; they are not read",
                     static_cast<unsigned long long>(pages_.file_length() - *start - page_bytes)));
  }

  void stack_imagej(const std::string& description) {
    refer_to(0);
    std::string problem;
    const auto found = read_imagej(description, plane_count(), problem);
    if (!found) refuse(summary_.path, "its ImageJ tags speak of " + problem);
    const ImageJDescription& imagej = *found;
    if (plane_count() == 1 && imagej.images > 1)
      use_one_piece(imagej.images, "its ImageJ tags speak");
    if (plane_count() != imagej.images) {
      refuse(
          summary_.path,
          base::format("its ImageJ tags speak of %lld images, but it holds %lld pages%s",
                       static_cast<long long>(imagej.images), static_cast<long long>(plane_count()),
                       imagej.images > plane_count() ? " (truncated?)" : ", which is more"));
    }
    summary_.format = imagej.channels > 1 || imagej.frames > 1 ? "TIFF, ImageJ hyperstack"
                      : imagej.images > 1                      ? "TIFF, ImageJ stack"
                                                               : "TIFF, ImageJ";
    stack_in_order(imagej.slices, imagej.channels, imagej.frames);
    summary_.notes.insert(summary_.notes.end(), imagej.notes.begin(), imagej.notes.end());
    calibrate_values(imagej);
    take_imagej_lengths(summary_, pages_.tags(), imagej);
  }

  /// ImageJ calibrates values of 8 and 16 bits only.
  void calibrate_values(const ImageJDescription& imagej) {
    const ValueType stored = summary_.type;
    if (!imagej.calibrated() || !stored.is_integer() || stored.bytes > 2) return;
    intercept_ = imagej.intercept;
    slope_ = imagej.slope;
    summary_.notes.push_back(base::format(
        "ImageJ's calibration of values is used: %g + %g x stored", intercept_, slope_));
    const bool whole = slope_ == 1.0 && intercept_ == std::floor(intercept_);
    const bool signed_16 = stored.kind == ValueType::Kind::unsigned_integer && stored.bytes == 2 &&
                           intercept_ == -32768.0;
    summary_.type = !whole || std::abs(intercept_) > 1e9
                        ? ValueType{ValueType::Kind::floating, 8}
                        : ValueType{ValueType::Kind::signed_integer, signed_16 ? 2 : 4};
  }

  /// ImageJ writes stacks of more than 4 GB with the directory of the first page alone; the planes
  /// follow it. MetaMorph does so always.
  /// \param says  who tells of them: "its ImageJ tags speak"
  void use_one_piece(std::int64_t planes, const std::string& says) {
    const auto start = pages_.start_of_values(0);
    if (reference_.bits_reversed)
      refuse(summary_.path,
             "stores the bits of each byte in reverse (FillOrder 2), and several planes "
             "behind one page; not supported together");
    if (!start || reference_.samples != 1 || reference_.bits % 8 != 0) {
      refuse(summary_.path, says + base::format(" of %lld images, but it holds 1 page (truncated?)",
                                                static_cast<long long>(planes)));
    }
    check_size(summary_.path, {reference_.width, reference_.height, planes}, 1,
               reference_.type.bytes, pages_.file_length() - std::min(*start, pages_.file_length()),
               1.0);
    in_one_piece_ = true;
    planes_in_piece_ = planes;
    start_ = *start;
  }

  void stack_ome(const std::string& description) {
    std::string problem;
    const std::optional<OmePixels> ome = read_ome_xml(description, problem);
    if (!ome) {
      summary_.notes.push_back("its OME-XML " + problem + ": read as a plain stack");
      leave_out_extras();
      return stack_plain();
    }
    if (!ome->contradiction.empty())
      refuse(summary_.path, "its OME-XML says " + ome->contradiction +
                                ", which cannot be; admissible: counts from 1 to 10^9");
    if (ome->is_latin1)
      summary_.notes.push_back("its OME-XML is not the UTF-8 it should be; read as Latin-1");
    summary_.format = "OME-TIFF";
    images_ = ome->images;
    if (images_ > 1)
      summary_.notes.push_back(
          base::format("the file holds %d images (series); the first is read", images_));

    std::string renamed;
    const std::string own_name = std::filesystem::path(summary_.path).filename().string();
    const std::vector<OmePlanes> planes = planes_of_file(*ome, own_name, renamed);
    if (!renamed.empty()) summary_.notes.push_back(renamed);
    const bool elsewhere = !planes.empty() && planes.front().page > 0 &&
                           planes.front().page < static_cast<std::int64_t>(pages_.pages().size());
    refer_to(elsewhere ? static_cast<std::size_t>(planes.front().page) : 0);
    const std::int64_t channels = std::max<std::int64_t>(ome->size_c / reference_.samples, 1);
    check_ome_sizes(*ome);
    set_size(ome->size_z, channels, ome->size_t);
    plane_of_ = pages_of_frame(*ome, planes, channels, reference_.samples, plane_count(),
                               stacked_channel(), summary_.frame);
    const auto missing = std::find(plane_of_.begin(), plane_of_.end(), -1);
    if (missing != plane_of_.end()) {
      refuse(
          summary_.path,
          base::format("its OME-XML names no page of this file for plane %lld of channel %lld in "
                       "frame %lld (truncated, or part of a set of files: all planes of the "
                       "channel and frame read must lie in the one that is given)",
                       static_cast<long long>(missing - plane_of_.begin()),
                       static_cast<long long>(stacked_channel()),
                       static_cast<long long>(summary_.frame)));
    }
    summary_.notes.insert(summary_.notes.end(), ome->notes.begin(), ome->notes.end());
    take_ome_lengths(summary_, *ome);
  }

  void check_ome_sizes(const OmePixels& ome) {
    if (ome.size_x != reference_.width || ome.size_y != reference_.height) {
      refuse(summary_.path,
             base::format("its OME-XML says %lld x %lld pixels, its pages have %lld x %lld",
                          static_cast<long long>(ome.size_x), static_cast<long long>(ome.size_y),
                          static_cast<long long>(reference_.width),
                          static_cast<long long>(reference_.height)));
    }
    if (ome.size_z > plane_count()) {
      refuse(
          summary_.path,
          base::format("its OME-XML says %lld planes, but it holds %lld pages (truncated, or "
                       "part of a set of files)",
                       static_cast<long long>(ome.size_z), static_cast<long long>(plane_count())));
    }
  }

  void stack_metamorph(const StkTags& stk) {
    refer_to(0);
    if (stk.planes < 1) refuse(summary_.path, "its MetaMorph tags count no planes");
    summary_.format = "TIFF, MetaMorph stack";
    if (plane_count() == 1 && stk.planes > 1) use_one_piece(stk.planes, "its MetaMorph tags speak");
    stack_in_order(plane_count(), 1, 1);
    take_stk_lengths(summary_, stk);
  }

  void stack_zeiss(const LsmTags& lsm) {
    refer_to(0);
    if (lsm.planes < 1 || lsm.frames < 1 ||
        static_cast<double>(lsm.planes) * static_cast<double>(lsm.frames) !=
            static_cast<double>(plane_count())) {
      refuse(summary_.path,
             base::format("its Zeiss tags speak of %lld planes in %lld frames, but it holds %lld "
                          "pages",
                          static_cast<long long>(lsm.planes), static_cast<long long>(lsm.frames),
                          static_cast<long long>(plane_count())));
    }
    summary_.format = "TIFF, Zeiss LSM";
    stack_in_order(lsm.planes, 1, lsm.frames);
    take_lsm_lengths(summary_, lsm);
  }

  TiffPages pages_;
  TiffPage reference_;                    ///< what all pages read are like
  std::vector<std::int64_t> plane_of_;    ///< [z], planes of the file
  int images_ = 1;                        ///< that the description tells of
  double intercept_ = 0.0, slope_ = 1.0;  ///< of ImageJ's calibration of values
  bool in_one_piece_ =
      false;  ///< all planes follow one another, uncompressed, behind one directory
  std::int64_t planes_in_piece_ = 0;
  std::uint64_t start_ = 0;  ///< of the piece in the file
};

}  // namespace

std::unique_ptr<ImageSource> open_tiff(const ImageRequest& request) {
  return std::make_unique<TiffSource>(request);
}

}  // namespace stroma::image
