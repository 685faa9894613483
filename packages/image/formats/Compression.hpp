// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Bytes of an image, packed piece by piece: the strips of a TIFF, the chunks of a Zarr array.

#include <cstddef>
#include <string>
#include <vector>

namespace stroma::image {

enum class Compression { none, zlib, zstd, blosc };

using Bytes = std::vector<unsigned char>;

/// Packs bytes of values of `value_bytes` each: zlib's and zstd's level 1, or Blosc's LZ4 with its
/// shuffle. \throws std::runtime_error when the library refuses
Bytes pack(const unsigned char* bytes, std::size_t count, Compression compression,
           std::size_t value_bytes);

/// Unpacks what must give `count` bytes: nothing is written beyond them, whatever the packed bytes
/// say of themselves. A stream of gzip counts as zlib.
/// \return  what is wrong with it; empty: nothing
std::string unpack(const Bytes& packed, Compression compression, unsigned char* bytes,
                   std::size_t count);

}  // namespace stroma::image
