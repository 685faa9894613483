// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/TiffDirectory.hpp"

#include <tiff.h>

#include <limits>

namespace stroma::image {

TiffDirectory::TiffDirectory(const std::string& path, std::uint64_t offset)
    : file_(path, std::ios::binary), offset_(offset) {
  char head[4] = {};
  file_.read(head, 4);
  big_endian_ = head[0] == 'M';
  big_tiff_ = (head[2] + head[3]) == 43;
}

std::optional<std::uint64_t> TiffDirectory::integer(std::uint64_t offset, int bytes) {
  if (offset > static_cast<std::uint64_t>(std::numeric_limits<std::streamoff>::max()))
    return std::nullopt;
  unsigned char raw[8] = {};
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(offset));
  if (!file_.read(reinterpret_cast<char*>(raw), bytes)) return std::nullopt;
  std::uint64_t value = 0;
  for (int i = 0; i < bytes; ++i) value = value << 8 | raw[big_endian_ ? i : bytes - 1 - i];
  return value;
}

std::optional<TiffEntry> TiffDirectory::find(std::uint16_t tag) {
  const int wide = big_tiff_ ? 8 : 4;
  const auto entries = integer(offset_, big_tiff_ ? 8 : 2);
  std::uint64_t at = offset_ + (big_tiff_ ? 8 : 2);
  for (std::uint64_t i = 0; entries && i < *entries; ++i, at += big_tiff_ ? 20 : 12) {
    const auto entry_tag = integer(at, 2);
    if (!entry_tag) return std::nullopt;
    if (*entry_tag != tag) continue;
    const std::uint64_t place = at + 4 + static_cast<std::uint64_t>(wide);
    const auto type = integer(at + 2, 2), count = integer(at + 4, wide),
               value = integer(place, wide);
    if (!value) return std::nullopt;
    return TiffEntry{static_cast<std::uint16_t>(*type), *count, place, *value};
  }
  return std::nullopt;
}

std::optional<std::pair<std::uint32_t, std::uint32_t>> TiffDirectory::rational(std::uint16_t tag) {
  const auto entry = find(tag);
  if (!entry || entry->type != TIFF_RATIONAL) return std::nullopt;
  // A rational takes 8 bytes: in place in a BigTIFF, elsewhere in a classic one.
  const std::uint64_t at = big_tiff_ ? entry->place : entry->value;
  const auto numerator = integer(at, 4), denominator = integer(at + 4, 4);
  if (!numerator || !denominator) return std::nullopt;
  return std::make_pair(static_cast<std::uint32_t>(*numerator),
                        static_cast<std::uint32_t>(*denominator));
}

}  // namespace stroma::image
