// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The header of NRRD: "NRRD000X", lines "field: value", and an empty line in front of the values,
/// or the names of the files that hold them.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/HeaderText.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/LengthUnit.hpp"
#include "stroma/image/formats/VolumeHeader.hpp"

namespace stroma::image {
namespace {

const char* const format_name = "NRRD";

using Kind = ValueType::Kind;

ValueType value_type(const HeaderFields& fields) {
  static const std::map<std::string, ValueType> types = {
      {"signed char", {Kind::signed_integer, 1}},
      {"int8", {Kind::signed_integer, 1}},
      {"int8_t", {Kind::signed_integer, 1}},
      {"uchar", {Kind::unsigned_integer, 1}},
      {"unsigned char", {Kind::unsigned_integer, 1}},
      {"uint8", {Kind::unsigned_integer, 1}},
      {"uint8_t", {Kind::unsigned_integer, 1}},
      {"short", {Kind::signed_integer, 2}},
      {"short int", {Kind::signed_integer, 2}},
      {"signed short", {Kind::signed_integer, 2}},
      {"signed short int", {Kind::signed_integer, 2}},
      {"int16", {Kind::signed_integer, 2}},
      {"int16_t", {Kind::signed_integer, 2}},
      {"ushort", {Kind::unsigned_integer, 2}},
      {"unsigned short", {Kind::unsigned_integer, 2}},
      {"unsigned short int", {Kind::unsigned_integer, 2}},
      {"uint16", {Kind::unsigned_integer, 2}},
      {"uint16_t", {Kind::unsigned_integer, 2}},
      {"int", {Kind::signed_integer, 4}},
      {"signed int", {Kind::signed_integer, 4}},
      {"int32", {Kind::signed_integer, 4}},
      {"int32_t", {Kind::signed_integer, 4}},
      {"uint", {Kind::unsigned_integer, 4}},
      {"unsigned int", {Kind::unsigned_integer, 4}},
      {"uint32", {Kind::unsigned_integer, 4}},
      {"uint32_t", {Kind::unsigned_integer, 4}},
      {"longlong", {Kind::signed_integer, 8}},
      {"long long", {Kind::signed_integer, 8}},
      {"long long int", {Kind::signed_integer, 8}},
      {"signed long long", {Kind::signed_integer, 8}},
      {"signed long long int", {Kind::signed_integer, 8}},
      {"int64", {Kind::signed_integer, 8}},
      {"int64_t", {Kind::signed_integer, 8}},
      {"ulonglong", {Kind::unsigned_integer, 8}},
      {"unsigned long long", {Kind::unsigned_integer, 8}},
      {"unsigned long long int", {Kind::unsigned_integer, 8}},
      {"uint64", {Kind::unsigned_integer, 8}},
      {"uint64_t", {Kind::unsigned_integer, 8}},
      {"float", {Kind::floating, 4}},
      {"double", {Kind::floating, 8}}};
  const auto found = types.find(lower_case(fields.required("type")));
  if (found == types.end())
    fields.refuse_field("type", "an integer of 1, 2, 4 or 8 bytes, float or double");
  return found->second;
}

/// The fields up to the empty line or the list of files; `at` is moved behind it.
HeaderFields read_fields(const std::string& path, const std::string& head, std::size_t& at,
                         std::vector<std::string>& notes) {
  static const std::set<std::string> known = {"dimension",
                                              "type",
                                              "block size",
                                              "encoding",
                                              "endian",
                                              "content",
                                              "min",
                                              "max",
                                              "old min",
                                              "old max",
                                              "data file",
                                              "line skip",
                                              "byte skip",
                                              "number",
                                              "sample units",
                                              "sizes",
                                              "spacings",
                                              "thicknesses",
                                              "axis mins",
                                              "axis maxs",
                                              "centers",
                                              "labels",
                                              "units",
                                              "kinds",
                                              "space",
                                              "space units",
                                              "space origin",
                                              "space dimension",
                                              "space directions",
                                              "measurement frame"};
  static const std::map<std::string, std::string> aliases = {
      {"datafile", "data file"},      {"lineskip", "line skip"}, {"byteskip", "byte skip"},
      {"oldmin", "old min"},          {"oldmax", "old max"},     {"blocksize", "block size"},
      {"axismins", "axis mins"},      {"axismaxs", "axis maxs"}, {"centerings", "centers"},
      {"sampleunits", "sample units"}};
  HeaderFields fields(path, format_name);
  std::string line;
  next_line(head, at, line);
  const std::string magic = trimmed(line);
  if (magic.size() != 8 || magic.compare(0, 7, "NRRD000") != 0 || magic[7] < '1' || magic[7] > '5')
    refuse(path,
           "is NRRD of the version \"" + printable(magic) + "\"; admissible: NRRD0001 to NRRD0005");
  bool ended = false;
  while (!ended && next_line(head, at, line)) {
    if (line.empty() || line == "\r") {
      ended = true;
      break;
    }
    if (line[0] == '#') continue;
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos && line[colon + 1] == '=') continue;  // key := value
    if (colon == std::string::npos)
      refuse(path, "has the line \"" + printable(line) +
                       "\" in its NRRD header; admissible: field: value");
    std::string name = lower_case(trimmed(line.substr(0, colon)));
    const auto alias = aliases.find(name);
    if (alias != aliases.end()) name = alias->second;
    if (known.count(name) == 0)
      notes.push_back("the header's field \"" + printable(name) + "\" is not known; not used");
    fields.add(name, trimmed(line.substr(colon + 1)));
    const std::vector<std::string> value = words(fields.text(name));
    if (name == "data file" && !value.empty() && value[0] == "LIST") ended = true;
  }
  if (!ended && !fields.has("data file"))
    refuse(path, "is no whole NRRD file: its header does not end with an empty line");
  return fields;
}

/// What an axis stands for.
enum class Role { space, channel, frame };

Role role_of(const HeaderFields& fields, const std::string& kind) {
  if (kind == "complex") fields.refuse_field("kinds", "real values");
  if (kind == "time") return Role::frame;
  if (kind == "domain" || kind == "space" || kind == "???" || kind == "none") return Role::space;
  return Role::channel;
}

/// The vectors "(a,b,c)" of `space directions`; an empty one for "none".
std::vector<std::vector<double>> directions(const HeaderFields& fields, std::size_t dimensions) {
  const std::string field = "space directions",
                    admissible = "a vector (a,b,c) or none for each axis";
  const std::string text = fields.text(field);
  std::vector<std::vector<double>> vectors;
  for (std::size_t at = text.find_first_not_of(" \t"); at != std::string::npos;
       at = text.find_first_not_of(" \t", at)) {
    vectors.emplace_back();
    if (text[at] != '(') {
      const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
      if (lower_case(text.substr(at, end - at)) != "none") fields.refuse_field(field, admissible);
      at = end;
      continue;
    }
    const std::size_t end = text.find(')', at);
    if (end == std::string::npos) fields.refuse_field(field, admissible);
    std::string inner = text.substr(at + 1, end - at - 1);
    std::replace(inner.begin(), inner.end(), ',', ' ');
    for (const std::string& word : words(inner)) {
      const auto number = to_real(word);
      if (!number) fields.refuse_field(field, admissible);
      vectors.back().push_back(*number);
    }
    if (vectors.back().empty() || vectors.back().size() > 8) fields.refuse_field(field, admissible);
    at = end + 1;
  }
  if (vectors.size() != dimensions) fields.refuse_field(field, admissible);
  return vectors;
}

/// The quoted words of a field, empty ones too.
std::vector<std::string> quoted_words(const std::string& text) {
  std::vector<std::string> found;
  std::size_t at = 0;
  while ((at = text.find('"', at)) != std::string::npos) {
    const std::size_t end = std::min(text.find('"', at + 1), text.size());
    found.push_back(text.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return found;
}

/// Reads the sizes of all axes into the header, each by its role; returns the axes of x, y and z.
std::vector<std::size_t> take_axes(VolumeHeader& header, const HeaderFields& fields) {
  const auto dimensions = static_cast<std::size_t>(fields.integer("dimension", 1, most_dimensions));
  const std::vector<std::int64_t> sizes = fields.sizes("sizes", dimensions);
  std::vector<std::string> kinds = words(lower_case(fields.text("kinds")));
  if (fields.has("kinds") && kinds.size() != dimensions)
    fields.refuse_field("kinds", base::format("%zu kinds", dimensions));
  if (kinds.empty()) kinds.resize(dimensions, "domain");
  if (!fields.has("kinds") && fields.has("space directions")) {
    const auto vectors = directions(fields, dimensions);
    for (std::size_t d = 0; d < dimensions; ++d)
      if (vectors[d].empty()) kinds[d] = "list";
  }
  std::vector<std::size_t> space;
  std::vector<std::pair<std::int64_t, std::int64_t*>> axes;
  std::int64_t unused = 0;
  for (std::size_t d = 0; d < dimensions; ++d) {
    std::int64_t* stride = &unused;
    const Role role = role_of(fields, kinds[d]);
    if (role == Role::space && space.size() < 3) {
      header.size[space.size()] = sizes[d];
      stride = &header.stride[space.size()];
      space.push_back(d);
    } else if (role == Role::channel && header.channel_stride == 0) {
      header.channels = sizes[d];
      stride = &header.channel_stride;
    } else if (role == Role::frame && header.frame_stride == 0) {
      header.frames = sizes[d];
      stride = &header.frame_stride;
    } else if (sizes[d] != 1) {
      fields.refuse_field("sizes",
                          "at most three axes of space, one of channels and one of time, "
                          "told apart by the field kinds");
    }
    *stride = -1;  // taken; set_strides gives the number
    axes.emplace_back(sizes[d], stride);
  }
  set_strides(header, axes);
  return space;
}

void take_encoding(VolumeHeader& header, const HeaderFields& fields) {
  static const std::map<std::string, Encoding> encodings = {
      {"raw", Encoding::raw},    {"txt", Encoding::text},   {"text", Encoding::text},
      {"ascii", Encoding::text}, {"gz", Encoding::gzip},    {"gzip", Encoding::gzip},
      {"bz2", Encoding::bzip2},  {"bzip2", Encoding::bzip2}};
  const auto found = encodings.find(lower_case(fields.required("encoding")));
  if (found == encodings.end())
    fields.refuse_field("encoding", "raw, ascii, gzip, bzip2; others are not supported");
  header.encoding = found->second;
  if (header.type.bytes > 1 && header.encoding != Encoding::text) {
    const std::string order = lower_case(fields.required("endian"));
    if (order != "little" && order != "big") fields.refuse_field("endian", "little or big");
    header.big_endian = order == "big";
  }
  constexpr std::int64_t most = 1LL << 50;
  if (fields.has("line skip")) header.line_skip = fields.integer("line skip", 0, most);
  if (fields.has("byte skip"))
    header.byte_skip = fields.integer("byte skip", header.encoding == Encoding::raw ? -1 : 0, most);
}

/// The values lie behind the header, in one file, in the files of a list or in those of a pattern.
void take_files(VolumeHeader& header, const HeaderFields& fields, const std::string& head,
                std::size_t at) {
  if (!fields.has("data file")) {
    header.files = {header.path};
    header.start = static_cast<std::int64_t>(at);
    return;
  }
  const std::string name = fields.text("data file");
  const std::vector<std::string> parts = words(name);
  const std::string admissible =
      "a file; LIST; or a pattern with one %d, its first and last number and the step";
  if (parts.empty()) fields.refuse_field("data file", admissible);
  std::vector<std::string> names;
  bool several = true;
  std::optional<std::int64_t> dimensions_per_file;
  const auto take_dimensions = [&](std::size_t part) {
    if (parts.size() <= part) return;
    dimensions_per_file = to_integer(parts[part]);
    if (parts.size() > part + 1 || !dimensions_per_file)
      fields.refuse_field("data file", admissible);
  };
  if (parts[0] == "LIST") {
    take_dimensions(1);
    for (std::string line; next_line(head, at, line);)
      if (!trimmed(line).empty()) names.push_back(trimmed(line));
  } else if (parts.size() >= 4 && name.find('%') != std::string::npos) {
    const auto first = to_integer(parts[1]), last = to_integer(parts[2]),
               step = to_integer(parts[3]);
    constexpr std::int64_t most = 1LL << 40;
    const bool counts = first && last && step && *step != 0 && std::abs(*first) < most &&
                        std::abs(*last) < most && std::abs(*step) < most &&
                        (*last - *first) / *step >= 0;
    if (!counts) fields.refuse_field("data file", admissible);
    take_dimensions(4);
    names = numbered_files(header.path, parts[0], *first, *step, (*last - *first) / *step + 1);
  } else {
    names = {name};
    several = false;
  }

  const std::vector<std::int64_t> sizes = fields.sizes("sizes", words(fields.text("sizes")).size());
  const auto dimensions = static_cast<std::int64_t>(sizes.size());
  const std::int64_t per_file = dimensions_per_file.value_or(
      several ? std::max<std::int64_t>(dimensions - 1, 1) : dimensions);
  if (per_file < 1 || per_file > dimensions)
    fields.refuse_field("data file", base::format("files of 1 to %lld dimensions",
                                                  static_cast<long long>(dimensions)));
  std::int64_t slabs = 1;  // of per_file dimensions
  for (std::int64_t d = per_file; d < dimensions; ++d) slabs *= sizes[static_cast<std::size_t>(d)];
  const auto count = static_cast<std::int64_t>(names.size());
  // Files of all dimensions are laid one behind another along the last.
  const bool fits = per_file < dimensions ? count == slabs : count > 0 && sizes.back() % count == 0;
  if (!fits || count > most_files)
    refuse(header.path, base::format("lists %lld files; its sizes take %lld",
                                     static_cast<long long>(count), static_cast<long long>(slabs)));
  for (const std::string& each : names) header.files.push_back(beside(header.path, each));
}

/// From `space directions` in `space units`, or `spacings` in `units`.
void take_spacing(VolumeHeader& header, const HeaderFields& fields,
                  const std::vector<std::size_t>& space) {
  const std::size_t dimensions = words(fields.text("sizes")).size();
  std::vector<double> spacing, unit;
  bool units_known = true;
  const auto add_unit = [&](const std::string& name) {
    const auto um = micrometres_per(name);
    units_known = units_known && um;
    return um.value_or(1.0);
  };
  if (fields.has("space directions")) {
    const auto vectors = directions(fields, dimensions);
    const std::vector<std::string> names = quoted_words(fields.text("space units"));
    std::vector<std::array<double, 3>> axes;
    for (const std::size_t axis : space) {
      double square = 0.0;
      std::array<double, 3> direction{0.0, 0.0, 0.0};
      for (std::size_t c = 0; c < vectors[axis].size(); ++c) {
        const double um = vectors[axis][c] * add_unit(c < names.size() ? names[c] : "");
        square += um * um;
        if (c < 3) direction[c] = um;
      }
      spacing.push_back(std::sqrt(square));
      unit.push_back(1.0);
      axes.push_back(direction);
    }
    note_orientation(header, axes);
  } else if (fields.has("spacings")) {
    const std::vector<double> all = fields.reals("spacings", dimensions);
    const std::vector<std::string> names = quoted_words(fields.text("units"));
    for (const std::size_t axis : space) {
      spacing.push_back(all[axis]);
      unit.push_back(add_unit(axis < names.size() ? names[axis] : ""));
    }
  } else if (fields.has("axis mins") || fields.has("axis maxs")) {
    header.notes.emplace_back(
        "its axis mins and axis maxs, without spacings or space directions, are not used");
  }
  if (!units_known) return note_no_unit(header, spacing);
  for (std::size_t d = 0; d < spacing.size(); ++d)
    set_spacing(header, static_cast<int>(d), spacing[d], unit[d]);
}

}  // namespace

VolumeHeader nrrd_header(const std::string& path, const std::string& head) {
  VolumeHeader header;
  header.path = path;
  header.format = format_name;
  std::size_t at = 0;
  const HeaderFields fields = read_fields(path, head, at, header.notes);
  header.type = value_type(fields);
  const std::vector<std::size_t> space = take_axes(header, fields);
  take_encoding(header, fields);
  take_files(header, fields, head, std::min(at, head.size()));
  take_spacing(header, fields, space);
  note_range(header, to_real(fields.text("max")).value_or(0.0));
  return header;
}

}  // namespace stroma::image
