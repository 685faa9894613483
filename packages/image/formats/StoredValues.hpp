// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The values of a volume, in the files that its header names.

#include <cstdint>
#include <string>
#include <vector>

#include "stroma/image/formats/VolumeHeader.hpp"

namespace stroma::image {

/// Finds the files, and reads any stretch of their values.
class StoredValues {
 public:
  /// Looks at every file. Values that are packed or written as text are read here, whole, into
  /// memory that grows with what is found, so that a header's claim alone takes none.
  /// \param header  of the volume, with the names of its files
  /// \param load    false: only look (ranks that will never read what cannot be read in parts)
  /// \param notes   what is odd
  /// \throws base::InputError when a file is missing, no regular file, or holds fewer values than
  /// the header announces
  StoredValues(const VolumeHeader& header, bool load, std::vector<std::string>& notes);

  /// The type that bytes() gives: the header's, or for text double.
  const ValueType& type() const { return type_; }
  bool swapped() const { return swapped_; }

  /// The bytes of values [first, first + count), which stay until the next call.
  /// \throws base::InputError when a file has become shorter
  const unsigned char* bytes(std::int64_t first, std::int64_t count);

 private:
  std::uint64_t locate_raw(const std::string& path, std::vector<std::string>& notes) const;
  void unpack(const std::string& path, std::vector<std::string>& notes);
  void parse_text(const std::string& path, std::vector<std::string>& notes);

  VolumeHeader header_;
  ValueType type_;
  bool swapped_ = false;
  std::vector<std::uint64_t> offsets_;  ///< raw: where the values of each file begin
  std::vector<unsigned char> bytes_;    ///< all, or what was last asked for
};

}  // namespace stroma::image
