// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Reads a file that is packed by gzip (or zlib) or bzip2, or not at all.

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace stroma::image {

enum class Packing { none, gzip, bzip2 };

/// The bytes of a file from some byte on, unpacked. Packed streams may follow one another.
class UnpackedFile {
 public:
  /// \throws base::InputError when the file cannot be opened
  UnpackedFile(const std::string& path, std::uint64_t offset, Packing packing);
  ~UnpackedFile();
  UnpackedFile(const UnpackedFile&) = delete;
  UnpackedFile& operator=(const UnpackedFile&) = delete;

  /// The next bytes; returns how many, fewer than asked for at the end of the file or stream.
  /// \throws base::InputError when the packed stream is broken, its checksum included
  std::size_t read(unsigned char* to, std::size_t count);

  struct Unpacker;

 private:
  bool fill();

  std::string path_;
  std::ifstream file_;
  std::vector<unsigned char> packed_;
  std::size_t at_ = 0, end_ = 0;  ///< what of packed_ is still to be used
  std::unique_ptr<Unpacker> unpacker_;
  bool stream_ended_ = false;
};

/// At most `most` bytes from the start of a file, unpacked as far as they can be.
std::string first_unpacked_bytes(const std::string& path, std::size_t most, Packing packing);

/// Whether a file that begins so is packed by gzip.
bool is_gzip(const std::string& head);

}  // namespace stroma::image
