// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/MicroscopeTags.hpp"

#include <tiff.h>

#include <cmath>
#include <cstring>

#include "stroma/image/formats/WholeNumber.hpp"

namespace stroma::image {
namespace {

constexpr std::uint16_t uic1 = 33628, uic2 = 33629;  // MetaMorph's: settings; planes
constexpr std::uint16_t cz_lsminfo = 34412;          // Zeiss'

std::optional<double> quotient(TiffDirectory& directory, std::uint64_t at) {
  const auto numerator = directory.integer(at, 4), denominator = directory.integer(at + 4, 4);
  if (!numerator || !denominator || *denominator == 0) return std::nullopt;
  return static_cast<double>(*numerator) / static_cast<double>(*denominator);
}

/// A string behind its length, which counts the closing zero.
std::string counted_string(TiffDirectory& directory, std::uint64_t at) {
  const std::uint64_t length = directory.integer(at, 4).value_or(0);
  std::string text;
  for (std::uint64_t i = 0; i < length && i < 64; ++i) {
    const auto character = directory.integer(at + 4 + i, 1);
    if (!character || *character == 0) break;
    text += static_cast<char>(*character);
  }
  return text;
}

/// UIC1 is a list of pairs, an identifier and a value or where it lies.
void read_uic1(TiffDirectory& directory, const TiffEntry& entry, StkTags& tags) {
  constexpr std::uint64_t x_calibration = 4, y_calibration = 5, calibration_units = 6;
  constexpr std::uint64_t identifiers = 200;  // more than MetaMorph has
  if (entry.type != TIFF_LONG) return;
  for (std::uint64_t i = 0; i < entry.count && i < identifiers; ++i) {
    const auto identifier = directory.integer(entry.value + 8 * i, 4);
    const auto place = directory.integer(entry.value + 8 * i + 4, 4);
    if (!place) return;
    if (*identifier == x_calibration) tags.pixel_size[0] = quotient(directory, *place);
    if (*identifier == y_calibration) tags.pixel_size[1] = quotient(directory, *place);
    if (*identifier == calibration_units) tags.unit = counted_string(directory, *place);
  }
}

/// UIC2 has six integers a plane, the first two of which make the distance in z; its count is that
/// of the planes.
void read_uic2(TiffDirectory& directory, const TiffEntry& entry, StkTags& tags) {
  tags.planes = entry.count <= static_cast<std::uint64_t>(largest_count)
                    ? static_cast<std::int64_t>(entry.count)
                    : 0;
  for (std::int64_t plane = 0; plane < tags.planes; ++plane) {
    const std::uint64_t place = entry.value + 24 * static_cast<std::uint64_t>(plane);
    const auto numerator = directory.integer(place, 4),
               denominator = directory.integer(place + 4, 4);
    if (!numerator || !denominator || *denominator == 0) {
      tags.z_distances.clear();
      return;
    }
    // Where the stage moves down it is negative, in an unsigned number's place.
    const auto step = static_cast<std::int32_t>(static_cast<std::uint32_t>(*numerator));
    tags.z_distances.push_back(std::abs(static_cast<double>(step)) /
                               static_cast<double>(*denominator));
  }
}

}  // namespace

std::optional<StkTags> read_stk(TiffDirectory& directory) {
  const auto planes = directory.find(uic2);
  if (!planes) return std::nullopt;
  StkTags tags;
  read_uic2(directory, *planes, tags);
  if (const auto settings = directory.find(uic1)) read_uic1(directory, *settings, tags);
  return tags;
}

std::optional<LsmTags> read_lsm(TiffDirectory& directory) {
  const auto entry = directory.find(cz_lsminfo);
  if (!entry) return std::nullopt;
  const std::uint64_t at = entry->value;
  const auto magic = directory.integer(at, 4);
  if (!magic || (*magic != 0x0300494C && *magic != 0x0400494C)) return std::nullopt;
  const auto count = [&](std::uint64_t offset) {
    const std::uint64_t value = directory.integer(at + offset, 4).value_or(0);
    return value <= static_cast<std::uint64_t>(largest_count) ? static_cast<std::int64_t>(value)
                                                              : 0;
  };
  LsmTags tags;
  tags.planes = count(16);
  tags.channels = count(20);
  tags.frames = count(24);
  for (std::uint64_t axis = 0; axis < 3; ++axis) {
    const std::uint64_t bits = directory.integer(at + 40 + 8 * axis, 8).value_or(0);
    std::memcpy(&tags.voxel_size[axis], &bits, sizeof bits);
  }
  return tags;
}

}  // namespace stroma::image
