// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Entries of a TIFF directory as they stand in the file, for what libtiff does not hand out: exact
/// rationals, and tags whose count means something else than a number of values.

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

namespace stroma::image {

/// Where the values of an entry are.
struct TiffEntry {
  std::uint16_t type = 0;
  std::uint64_t count = 0;
  std::uint64_t place = 0;  ///< where a value of at most 4 bytes (8 in a BigTIFF) itself stands
  std::uint64_t value = 0;  ///< what stands there; longer values lie at this offset
};

/// Reads a directory in the file's byte order. What lies beyond the end of the file reads as
/// nothing.
class TiffDirectory {
 public:
  /// \param path    of the file
  /// \param offset  of the directory
  TiffDirectory(const std::string& path, std::uint64_t offset);

  bool big_tiff() const { return big_tiff_; }
  /// The entry of a tag, if the directory has it.
  std::optional<TiffEntry> find(std::uint16_t tag);
  /// The two integers of a rational tag.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> rational(std::uint16_t tag);
  /// The unsigned integer of 1 to 8 bytes at an offset.
  std::optional<std::uint64_t> integer(std::uint64_t offset, int bytes);

 private:
  std::ifstream file_;
  std::uint64_t offset_;
  bool big_endian_ = false;
  bool big_tiff_ = false;
};

}  // namespace stroma::image
