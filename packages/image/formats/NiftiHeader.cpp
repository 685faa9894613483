// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The header of NIfTI: 348 bytes in version 1, 540 in version 2, in either byte order.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/LengthUnit.hpp"
#include "stroma/image/formats/VolumeHeader.hpp"

namespace stroma::image {
namespace {

using Kind = ValueType::Kind;

/// Where a field lies, and as what, in the two versions.
struct Field {
  std::size_t at1;
  ValueType type1;
  std::size_t at2;
  ValueType type2;
};

constexpr ValueType i8{Kind::signed_integer, 1}, i16{Kind::signed_integer, 2},
    i32{Kind::signed_integer, 4}, i64{Kind::signed_integer, 8}, f32{Kind::floating, 4},
    f64{Kind::floating, 8};

constexpr Field dim{40, i16, 16, i64}, datatype{70, i16, 12, i16}, bitpix{72, i16, 14, i16},
    pixdim{76, f32, 104, f64}, vox_offset{108, f32, 168, i64}, scl_slope{112, f32, 176, f64},
    scl_inter{116, f32, 184, f64}, xyzt_units{123, i8, 500, i32}, cal_max{124, f32, 192, f64},
    qform_code{252, i16, 344, i32}, sform_code{254, i16, 348, i32}, quatern{256, f32, 352, f64},
    srow{280, f32, 400, f64};

/// The fields as numbers. Every integer but an absurd 64-bit one is exact as a double.
class Fields {
 public:
  Fields(const std::string& path, const std::string& head) : head_(head) {
    if (head.size() < 348)
      refuse(path, base::format("is truncated: its header announces 348 bytes, %zu are there",
                                head.size()));
    for (const double size : {348.0, 540.0}) {
      for (const bool swapped : {false, true}) {
        swapped_ = swapped;
        version2_ = size == 540.0;
        if (number({0, i32, 0, i32}) != size) continue;
        check(path);
        return;
      }
    }
    refuse(path, "is broken: its NIfTI header does not begin with 348 or 540, the header's size");
  }

  double operator()(const Field& field, std::size_t index = 0) const {
    return number(field, index);
  }
  bool version2() const { return version2_; }
  bool swapped() const { return swapped_; }
  /// Values lie in the same file, not in one that ends in .img.
  bool one_file() const { return magic()[1] == '+'; }
  std::size_t size() const { return version2_ ? 540 : 348; }

 private:
  std::string magic() const { return head_.substr(version2_ ? 4 : 344, 3); }

  void check(const std::string& path) const {
    const std::string version = version2_ ? "2" : "1";
    if (magic() == "n+" + version || magic() == "ni" + version) {
      if (head_.size() >= size()) return;
      refuse(path, base::format("is truncated: its header announces %zu bytes, %zu are there",
                                size(), head_.size()));
    }
    refuse(path,
           "is not supported: it has the header of Analyze 7.5, or of a NIfTI version that is not "
           "known; admissible: NIfTI-1, NIfTI-2");
  }

  double number(const Field& field, std::size_t index = 0) const {
    const ValueType& type = version2_ ? field.type2 : field.type1;
    const std::size_t at =
        (version2_ ? field.at2 : field.at1) + index * static_cast<std::size_t>(type.bytes);
    double value = 0.0;
    decode(reinterpret_cast<const unsigned char*>(head_.data()) + at, type, swapped_, 1, 1, &value);
    return value;
  }

  const std::string& head_;
  bool swapped_ = false, version2_ = false;
};

void take_type(VolumeHeader& header, const Fields& fields) {
  struct Type {
    ValueType value;
    int channels;
  };
  static const std::map<int, Type> types = {
      {2, {{Kind::unsigned_integer, 1}, 1}},    {4, {{Kind::signed_integer, 2}, 1}},
      {8, {{Kind::signed_integer, 4}, 1}},      {16, {{Kind::floating, 4}, 1}},
      {64, {{Kind::floating, 8}, 1}},           {128, {{Kind::unsigned_integer, 1}, 3}},
      {256, {{Kind::signed_integer, 1}, 1}},    {512, {{Kind::unsigned_integer, 2}, 1}},
      {768, {{Kind::unsigned_integer, 4}, 1}},  {1024, {{Kind::signed_integer, 8}, 1}},
      {1280, {{Kind::unsigned_integer, 8}, 1}}, {2304, {{Kind::unsigned_integer, 1}, 4}}};
  static const std::map<int, std::string> others = {{1, "bits"},
                                                    {32, "complex numbers"},
                                                    {1536, "128-bit floats"},
                                                    {1792, "complex numbers"},
                                                    {2048, "complex numbers"}};
  const int code = static_cast<int>(fields(datatype));
  const auto found = types.find(code);
  if (found == types.end()) {
    const auto other = others.find(code);
    refuse(header.path,
           "is not supported: it holds " +
               (other != others.end() ? other->second : base::format("values of type %d", code)) +
               "; admissible: real values of 8 to 64 bits, RGB, RGBA");
  }
  header.type = found->second.value;
  header.channels = found->second.channels;
  const int bits = 8 * header.type.bytes * static_cast<int>(header.channels);
  if (static_cast<int>(fields(bitpix)) != bits)
    header.notes.push_back(
        base::format("the header speaks of %d bits a voxel, its type has %d; the type is taken",
                     static_cast<int>(fields(bitpix)), bits));
}

/// x, y, z, time and vector components, in this order; further dimensions must be 1.
void take_sizes(VolumeHeader& header, const Fields& fields) {
  const double dimensions = fields(dim);
  if (!(dimensions >= 1.0 && dimensions <= most_dimensions))
    refuse(header.path,
           base::format("has %g dimensions by its NIfTI header; admissible: 1 to 7", dimensions));
  std::vector<std::pair<std::int64_t, std::int64_t*>> axes;
  std::int64_t unused = 0;
  const bool colours = header.channels > 1;
  if (colours) axes.emplace_back(header.channels, &header.channel_stride);
  for (std::size_t d = 1; d <= static_cast<std::size_t>(dimensions); ++d) {
    const double stated = fields(dim, d);
    if (!(stated >= 1.0 && stated <= 9e15))
      refuse(header.path, base::format("says that it has %.0f values along dimension %zu; "
                                       "admissible: at least 1",
                                       stated, d));
    const auto size = static_cast<std::int64_t>(stated);
    std::int64_t* stride = &unused;
    if (d <= 3) {
      header.size[d - 1] = size;
      stride = &header.stride[d - 1];
    } else if (d == 4) {
      header.frames = size;
      stride = &header.frame_stride;
    } else if (d == 5 && !colours) {
      header.channels = size;
      stride = &header.channel_stride;
    } else if (size != 1) {
      refuse(header.path, base::format("is not supported: it has %lld values along dimension %zu",
                                       static_cast<long long>(size), d));
    }
    axes.emplace_back(size, stride);
  }
  set_strides(header, axes);
}

void take_place(VolumeHeader& header, const Fields& fields) {
  const double stated = fields(vox_offset);
  const double least = fields.one_file() ? static_cast<double>(fields.size() + 4) : 0.0;
  const bool unset = stated == 0.0 && fields.one_file();
  if (unset) {
    header.notes.push_back(
        base::format("the header does not say where its values begin; byte %.0f taken", least));
  } else if (!(stated >= least && stated < 9e15) || stated != std::floor(stated)) {
    refuse(header.path, base::format("says that its values begin at byte %g; admissible: a whole "
                                     "number from %.0f on",
                                     stated, least));
  }
  header.byte_skip = static_cast<std::int64_t>(unset ? least : stated);
  std::filesystem::path file = header.path;
  if (!fields.one_file()) {
    if (file.extension() == ".gz") file.replace_extension();
    file.replace_extension(".img");
  }
  header.files = {file.string()};
}

/// A slope of 0 means none; what is not a number says nothing.
void take_scaling(VolumeHeader& header, const Fields& fields) {
  const double slope = fields(scl_slope), intercept = fields(scl_inter);
  const bool colours = header.channel_stride == 1 && header.channels > 1;
  if (slope == 0.0 || !std::isfinite(slope) || colours || (slope == 1.0 && intercept == 0.0))
    return;
  if (!std::isfinite(intercept))
    refuse(header.path, base::format("is broken: values times %g plus %g, its NIfTI header says",
                                     slope, intercept));
  header.slope = slope;
  header.intercept = intercept;
  header.notes.push_back(
      base::format("values are those stored (%s) times %.9g plus %.9g, as the header says",
                   header.type.name().c_str(), slope, intercept));
}

/// Columns of the rotation of qform; none if the quaternion is not one.
std::vector<std::array<double, 3>> qform_axes(const Fields& fields) {
  const double b = fields(quatern, 0), c = fields(quatern, 1), d = fields(quatern, 2);
  const double rest = 1.0 - (b * b + c * c + d * d);
  if (!(rest > -1e-5)) return {};
  const double a = std::sqrt(std::max(rest, 0.0));
  const double last = fields(pixdim) < 0.0 ? -1.0 : 1.0;
  return {{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
          {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)},
          {2 * last * (b * d + a * c), 2 * last * (c * d - a * b),
           last * (a * a + d * d - c * c - b * b)}};
}

/// pixdim is the voxel size; the two orientations only give notes.
void take_spacing(VolumeHeader& header, const Fields& fields) {
  const auto dimensions = static_cast<std::size_t>(std::min(fields(dim), 3.0));
  std::vector<double> spacing;
  for (std::size_t d = 1; d <= dimensions; ++d) spacing.push_back(fields(pixdim, d));
  const bool oriented = fields(sform_code) > 0.0;
  if (oriented) {
    std::vector<std::array<double, 3>> axes(dimensions);
    bool agree = true;
    for (std::size_t d = 0; d < dimensions; ++d) {
      for (std::size_t row = 0; row < 3; ++row) axes[d][row] = fields(srow, 4 * row + d);
      const double length = std::hypot(axes[d][0], axes[d][1], axes[d][2]);
      agree = agree && std::abs(length - std::abs(spacing[d])) <= 1e-3 * length;
    }
    if (!agree)
      header.notes.push_back(
          "the header's sizes of a voxel, pixdim and the lengths of sform's columns, contradict "
          "each other; pixdim is taken");
    note_orientation(header, axes);
  } else if (fields(qform_code) > 0.0) {
    std::vector<std::array<double, 3>> axes = qform_axes(fields);
    axes.resize(dimensions, {0.0, 0.0, 0.0});
    note_orientation(header, axes);
  }

  const int unit = static_cast<int>(fields(xyzt_units)) & 7;
  if (unit < 1 || unit > 3) {
    header.notes.push_back("the NIfTI header does not name the unit of its spacing; not used");
    return;
  }
  const double micrometres = unit == 1 ? 1e6 : unit == 2 ? 1e3 : 1.0;
  for (std::size_t d = 0; d < dimensions; ++d) {
    // So that what was written as 1.05 does not come back as 1.0499999523.
    const double um = spacing[d] * micrometres;
    set_spacing(header, static_cast<int>(d),
                fields.version2() ? um : shortest_decimal(static_cast<float>(um)), 1.0);
  }
}

}  // namespace

VolumeHeader nifti_header(const std::string& path, const std::string& head) {
  const Fields fields(path, head);
  VolumeHeader header;
  header.path = path;
  header.format = "NIfTI";
  const unsigned one = 1;
  const bool host_is_big = *reinterpret_cast<const unsigned char*>(&one) == 0;
  header.big_endian = fields.swapped() != host_is_big;
  take_type(header, fields);
  take_sizes(header, fields);
  take_place(header, fields);
  take_scaling(header, fields);
  take_spacing(header, fields);
  if (header.slope == 1.0 && header.intercept == 0.0) note_range(header, fields(cal_max));
  return header;
}

}  // namespace stroma::image
