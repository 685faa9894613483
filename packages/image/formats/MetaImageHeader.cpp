// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The header of MetaImage: lines "Name = value", the last of which is ElementDataFile.

#include <algorithm>
#include <map>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/HeaderText.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/LengthUnit.hpp"
#include "stroma/image/formats/VolumeHeader.hpp"

namespace stroma::image {
namespace {

const char* const format = "MetaImage";

/// Names of types have been stored by C's names, with a long of 4 bytes.
ValueType value_type(const HeaderFields& fields) {
  using Kind = ValueType::Kind;
  static const std::map<std::string, ValueType> types = {
      {"MET_CHAR", {Kind::signed_integer, 1}},      {"MET_UCHAR", {Kind::unsigned_integer, 1}},
      {"MET_SHORT", {Kind::signed_integer, 2}},     {"MET_USHORT", {Kind::unsigned_integer, 2}},
      {"MET_INT", {Kind::signed_integer, 4}},       {"MET_UINT", {Kind::unsigned_integer, 4}},
      {"MET_LONG", {Kind::signed_integer, 4}},      {"MET_ULONG", {Kind::unsigned_integer, 4}},
      {"MET_LONG_LONG", {Kind::signed_integer, 8}}, {"MET_ULONG_LONG", {Kind::unsigned_integer, 8}},
      {"MET_FLOAT", {Kind::floating, 4}},           {"MET_DOUBLE", {Kind::floating, 8}}};
  const auto found = types.find(fields.required("ElementType"));
  if (found == types.end()) {
    std::string names;
    for (const auto& type : types) names += (names.empty() ? "" : ", ") + type.first;
    fields.refuse_field("ElementType", names);
  }
  return found->second;
}

/// The fields up to ElementDataFile; `at` is moved behind that line.
HeaderFields read_fields(const std::string& path, const std::string& head, std::size_t& at) {
  HeaderFields fields(path, format);
  for (std::string line; !fields.has("ElementDataFile") && next_line(head, at, line);) {
    if (trimmed(line).empty()) continue;
    const std::size_t sign = std::min(line.find('='), line.find(':'));
    if (sign == std::string::npos)
      refuse(path, "has the line \"" + printable(line) +
                       "\" in its MetaImage header; admissible: Name = value");
    const std::string name = trimmed(line.substr(0, sign));
    if (name != "Comment") fields.add(name, trimmed(line.substr(sign + 1)));
  }
  return fields;
}

/// NDims and DimSize, with channels fastest and a fourth dimension as frames.
void take_sizes(VolumeHeader& header, const HeaderFields& fields) {
  const auto dimensions = static_cast<std::size_t>(fields.integer("NDims", 1, most_dimensions));
  const std::vector<std::int64_t> sizes = fields.sizes("DimSize", dimensions);
  if (fields.has("ElementNumberOfChannels"))
    header.channels = fields.integer("ElementNumberOfChannels", 1, 1000000);
  std::vector<std::pair<std::int64_t, std::int64_t*>> axes = {
      {header.channels, &header.channel_stride}};
  std::int64_t unused = 0;
  for (std::size_t d = 0; d < dimensions; ++d) {
    if (d < 3) header.size[d] = sizes[d];
    if (d == 3) header.frames = sizes[d];
    if (d > 3 && sizes[d] != 1)
      fields.refuse_field("DimSize", "x, y, z and frames; further ones must be 1");
    axes.emplace_back(sizes[d], d < 3    ? &header.stride[d]
                                : d == 3 ? &header.frame_stride
                                         : &unused);
  }
  set_strides(header, axes);
}

/// One name; LIST and a name a line; or a pattern with its first and last number and step.
void take_files(VolumeHeader& header, const HeaderFields& fields, const std::string& head,
                std::size_t at) {
  const std::string name = fields.text("ElementDataFile");
  const std::vector<std::string> parts = words(name);
  if (parts.empty()) fields.refuse_field("ElementDataFile", "LOCAL or names of files");
  if (lower_case(name) == "local") {
    header.start = static_cast<std::int64_t>(at);
    header.files = {header.path};
    return;
  }
  const std::vector<std::int64_t> sizes =
      fields.sizes("DimSize", words(fields.text("DimSize")).size());
  std::size_t dimensions_per_file = sizes.size() - 1;
  const bool is_list = parts[0] == "LIST";
  if (is_list && parts.size() > 1) {
    const auto given = to_integer(parts[1].substr(0, parts[1].find_last_not_of("dD") + 1));  // "2D"
    if (parts.size() > 2 || !given || *given < 1 ||
        *given > static_cast<std::int64_t>(sizes.size()))
      fields.refuse_field("ElementDataFile", "LIST and the number of dimensions of each file");
    dimensions_per_file = static_cast<std::size_t>(*given);
  }
  std::int64_t count = 1;
  for (std::size_t d = dimensions_per_file; d < sizes.size(); ++d) count *= sizes[d];

  std::vector<std::string> names;
  if (is_list) {
    for (std::string line; next_line(head, at, line);)
      if (!trimmed(line).empty()) names.push_back(trimmed(line));
  } else if (name.find('%') != std::string::npos) {
    std::vector<std::int64_t> numbers;
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const auto number = to_integer(parts[i]);
      if (!number || i > 3)
        fields.refuse_field("ElementDataFile", "a pattern, its first and last number and the step");
      numbers.push_back(*number);
    }
    const std::int64_t first = numbers.empty() ? 1 : numbers[0];
    const std::int64_t step = numbers.size() > 2 ? numbers[2] : 1;
    names = numbered_files(header.path, parts[0], first, step, count);
    const std::int64_t last = first + (count - 1) * step;
    if (numbers.size() > 1 && (step < 1 || numbers[1] < last || numbers[1] >= last + step))
      fields.refuse_field("ElementDataFile", base::format("numbers for the %lld files of this size",
                                                          static_cast<long long>(count)));
  } else {
    names = {name};
    count = 1;
  }
  if (static_cast<std::int64_t>(names.size()) != count)
    refuse(header.path, base::format("lists %zu files; its size takes %lld", names.size(),
                                     static_cast<long long>(count)));
  for (const std::string& each : names) header.files.push_back(beside(header.path, each));
}

/// HeaderSize, which counts from the start of a file, whatever it holds.
void take_skip(VolumeHeader& header, const HeaderFields& fields) {
  if (!fields.has("HeaderSize")) return;
  const std::int64_t skip = fields.integer("HeaderSize", -1, 1LL << 50);
  if (skip == 0) return;
  const bool into_header = skip > 0 && skip < header.start;
  if (into_header || (skip < 0 && header.encoding != Encoding::raw))
    fields.refuse_field("HeaderSize", "bytes in front of the values; -1 for uncompressed ones");
  header.start = 0;
  header.byte_skip = skip;
  if (skip > 0 && header.encoding == Encoding::gzip) {
    header.start = skip;  // counted before unpacking
    header.byte_skip = 0;
  }
}

void take_spacing(VolumeHeader& header, const HeaderFields& fields, std::size_t dimensions) {
  const std::string name = fields.has("ElementSpacing") ? "ElementSpacing" : "ElementSize";
  if (fields.has(name)) {
    std::vector<double> spacing = fields.reals(name, dimensions);
    spacing.resize(std::min<std::size_t>(dimensions, 3));
    const auto unit = micrometres_per(fields.text("DistanceUnits"));
    if (!unit) note_no_unit(header, spacing);
    for (std::size_t d = 0; unit && d < spacing.size(); ++d)
      set_spacing(header, static_cast<int>(d), spacing[d], *unit);
  }
  for (const char* const matrix : {"TransformMatrix", "Orientation", "Rotation"}) {
    if (!fields.has(matrix)) continue;
    const std::vector<double> numbers = fields.reals(matrix, dimensions * dimensions);
    const std::size_t in_space = std::min<std::size_t>(dimensions, 3);
    std::vector<std::array<double, 3>> axes(in_space, {0.0, 0.0, 0.0});
    for (std::size_t i = 0; i < in_space; ++i)
      for (std::size_t j = 0; j < in_space; ++j) axes[i][j] = numbers[i * dimensions + j];
    return note_orientation(header, axes);
  }
}

}  // namespace

VolumeHeader metaimage_header(const std::string& path, const std::string& head) {
  std::size_t at = 0;
  const HeaderFields fields = read_fields(path, head, at);
  VolumeHeader header;
  header.path = path;
  header.format = format;
  if (fields.has("ObjectType") && fields.text("ObjectType") != "Image")
    fields.refuse_field("ObjectType", "Image");
  fields.required("ElementDataFile");
  header.type = value_type(fields);
  take_sizes(header, fields);

  const bool binary = fields.truth("BinaryData", true);
  const bool packed = fields.truth("CompressedData", false);
  if (packed && !binary) fields.refuse_field("CompressedData", "False with BinaryData = False");
  // CompressedDataSize is not needed: a packed stream says itself where it ends.
  header.encoding = packed ? Encoding::gzip : binary ? Encoding::raw : Encoding::text;
  const bool said = fields.has("BinaryDataByteOrderMSB") || fields.has("ElementByteOrderMSB");
  header.big_endian =
      fields.truth("BinaryDataByteOrderMSB", false) || fields.truth("ElementByteOrderMSB", false);
  if (!said && binary && header.type.bytes > 1)
    header.notes.push_back("the header does not say in which order bytes are; little-endian taken");

  take_files(header, fields, head, std::min(at, head.size()));
  take_skip(header, fields);
  take_spacing(header, fields, words(fields.text("DimSize")).size());
  const auto is_not = [&](const char* name, double usual) {
    return fields.has(name) && fields.reals(name, 1)[0] != usual;
  };
  if (is_not("ElementToIntensityFunctionSlope", 1.0) ||
      is_not("ElementToIntensityFunctionOffset", 0.0))
    header.notes.push_back("the header's intensity function (slope, offset) is not applied");
  note_range(header, to_real(fields.text("ElementMax")).value_or(0.0));
  return header;
}

}  // namespace stroma::image
