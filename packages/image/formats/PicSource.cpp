// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Bio-Rad PIC, the format of the MRC confocal microscopes: a header of 76 bytes, planes of 8 or 16
/// bit values, then notes of 96 bytes, all little-endian.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/LengthUnit.hpp"

namespace stroma::image {
namespace {

constexpr std::int64_t header_bytes = 76;
constexpr std::size_t note_bytes = 96;

/// Whether a note may be what somebody wrote: not what a plane holds.
bool is_text(const std::string& line) {
  return std::none_of(line.begin(), line.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r';
  });
}

class PicSource : public ImageSource {
 public:
  explicit PicSource(const ImageRequest& request) {
    summary_.path = request.path;
    summary_.format = "Bio-Rad PIC";
    summary_.channel = request.channel;
    const std::uint64_t length = std::filesystem::file_size(request.path);
    std::ifstream file(request.path, std::ios::binary);
    unsigned char header[header_bytes];
    file.read(reinterpret_cast<char*>(header), header_bytes);
    if (!file) refuse(request.path, "ends within the header of a Bio-Rad PIC file (truncated)");
    const auto word = [&](int at) { return static_cast<int>(header[at] | header[at + 1] << 8); };
    summary_.file_size = {word(0), word(2), word(4)};
    summary_.type = {ValueType::Kind::unsigned_integer, word(14) == 1 ? 1 : 2};
    check_size(request.path, summary_.file_size, 1, summary_.type.bytes,
               length - static_cast<std::uint64_t>(header_bytes), 1.0);
    check_channel(request.path, request.channel, 1);
    const bool has_notes = header[10] || header[11] || header[12] || header[13];
    const bool are_notes = has_notes && read_notes(file);
    const auto behind = static_cast<std::int64_t>(length) - end_of_planes();
    if (has_notes && !(are_notes && behind % static_cast<std::int64_t>(note_bytes) == 0))
      summary_.notes.push_back(base::format(
          "the header counts %lld planes and says that notes follow, but the %lld bytes behind them "
          "are no notes of 96 bytes each: it may count too few planes, or too many, of which notes "
          "are part then",
          static_cast<long long>(summary_.file_size[2]), static_cast<long long>(behind)));
    else if (!has_notes && behind > 0)
      summary_.notes.push_back(base::format(
          "the file holds %lld bytes more than the planes that its header announces; they are not "
          "read",
          static_cast<long long>(behind)));
  }

  void read(const voxels::Box& box, double* values) override {
    read_raw(summary_.path, header_bytes, summary_.type, false, summary_.file_size, box, values);
  }

 private:
  std::int64_t end_of_planes() const {
    const auto& size = summary_.file_size;
    return header_bytes + size[0] * size[1] * size[2] * summary_.type.bytes;
  }

  /// AXIS_2, AXIS_3 and AXIS_4 calibrate x, y and z: "AXIS_2 257 0.000000e+00 1.050000e+00
  /// microns", that is name, type (its low byte 1: a linear axis with a length), origin, increment,
  /// unit. \return whether there are notes, all of them text
  bool read_notes(std::ifstream& file) {
    file.seekg(end_of_planes());
    char note[note_bytes];
    bool more = true, are_text = true;
    int count = 0;
    while (more && file.read(note, note_bytes)) {
      more = note[2] || note[3] || note[4] || note[5];
      const std::string field(note + 16, note_bytes - 16), line = field.substr(0, field.find('\0'));
      are_text = are_text && is_text(line);
      ++count;
      std::istringstream text(line);
      std::string name, unit;
      int type = 0;
      double origin = 0.0, increment = 0.0;
      text >> name >> type >> origin >> increment >> unit;
      const bool is_axis = name == "AXIS_2" || name == "AXIS_3" || name == "AXIS_4";
      if (!is_axis || (type & 0xff) != 1 || !(increment > 0.0) || !std::isfinite(increment))
        continue;
      take_axis(name[5] - '2', name, increment, unit);
    }
    return count > 0 && are_text;
  }

  /// The microscopes' own unit is the micrometre; some writers leave it out.
  void take_axis(int axis, const std::string& name, double increment, const std::string& unit) {
    const auto scale = unit.empty() ? std::optional<double>(1.0) : micrometres_per(unit);
    if (!scale) {
      summary_.notes.push_back(
          base::format("the note %s gives %g %s, which is no unit of length known here; not used",
                       name.c_str(), increment, unit.c_str()));
      return;
    }
    summary_.voxel_size.set(axis, increment * *scale, "PIC notes");
    if (unit.empty())
      summary_.notes.push_back(base::format("the note %s gives %g without a unit: taken as um",
                                            name.c_str(), increment));
  }
};

}  // namespace

std::unique_ptr<ImageSource> open_pic(const ImageRequest& request) {
  return std::make_unique<PicSource>(request);
}

}  // namespace stroma::image
