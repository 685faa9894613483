// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/Compression.hpp"

#include <blosc.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "stroma/base/Log.hpp"

namespace stroma::image {
namespace {

constexpr int fastest = 1;  // level of zlib and zstd
constexpr int blosc_level = 5;

std::string other_size(unsigned long long found, std::size_t count) {
  return base::format("unpacks to %llu bytes instead of %zu", found, count);
}

std::string inflate_all(const Bytes& packed, unsigned char* bytes, std::size_t count) {
  constexpr int zlib_or_gzip = 15 + 32;
  constexpr std::size_t most = std::numeric_limits<uInt>::max();
  if (packed.size() > most || count > most) return "is larger than 4 GiB";
  z_stream stream{};
  if (inflateInit2(&stream, zlib_or_gzip) != Z_OK) throw std::bad_alloc();
  stream.next_in = const_cast<unsigned char*>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = bytes;
  stream.avail_out = static_cast<uInt>(count);
  const int ended = inflate(&stream, Z_FINISH);
  const std::size_t found = count - stream.avail_out;
  inflateEnd(&stream);
  if (ended == Z_STREAM_END && found == count) return "";
  if (ended == Z_STREAM_END) return other_size(found, count);
  return found == count ? base::format("unpacks to more than %zu bytes", count)
                        : "is no stream of zlib, or is cut short";
}

std::string unpack_zstd(const Bytes& packed, unsigned char* bytes, std::size_t count) {
  const unsigned long long stated = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (stated == ZSTD_CONTENTSIZE_ERROR) return "is no frame of zstd";
  if (stated != ZSTD_CONTENTSIZE_UNKNOWN && stated != count) return other_size(stated, count);
  const std::size_t found = ZSTD_decompress(bytes, count, packed.data(), packed.size());
  if (ZSTD_isError(found)) return std::string("cannot be unpacked: ") + ZSTD_getErrorName(found);
  return found == count ? "" : other_size(found, count);
}

std::string unpack_blosc(const Bytes& packed, unsigned char* bytes, std::size_t count) {
  std::size_t stated = 0;
  if (blosc_cbuffer_validate(packed.data(), packed.size(), &stated) != 0)
    return "is no buffer of Blosc, or is cut short";
  if (stated != count) return other_size(stated, count);
  const int found = blosc_decompress_ctx(packed.data(), bytes, count, 1);
  if (found < 0 || static_cast<std::size_t>(found) != count)
    return "cannot be unpacked by the Blosc of this machine (broken, or of an unusual kind)";
  return "";
}

}  // namespace

Bytes pack(const unsigned char* bytes, std::size_t count, Compression compression,
           std::size_t value_bytes) {
  Bytes packed;
  bool is_done = true;
  if (compression == Compression::none) {
    packed.assign(bytes, bytes + count);
  } else if (compression == Compression::zlib) {
    uLongf size = compressBound(count);
    packed.resize(size);
    is_done = compress2(packed.data(), &size, bytes, count, fastest) == Z_OK;
    packed.resize(size);
  } else if (compression == Compression::zstd) {
    packed.resize(ZSTD_compressBound(count));
    const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes, count, fastest);
    is_done = !ZSTD_isError(size);
    packed.resize(is_done ? size : 0);
  } else {
    packed.resize(count + BLOSC_MAX_OVERHEAD);
    const int size = blosc_compress_ctx(blosc_level, BLOSC_SHUFFLE, value_bytes, count, bytes,
                                        packed.data(), packed.size(), BLOSC_LZ4_COMPNAME, 0, 1);
    is_done = size > 0;
    packed.resize(is_done ? static_cast<std::size_t>(size) : 0);
  }
  if (!is_done) throw std::runtime_error(base::format("%zu bytes cannot be compressed", count));
  return packed;
}

std::string unpack(const Bytes& packed, Compression compression, unsigned char* bytes,
                   std::size_t count) {
  if (compression == Compression::zlib) return inflate_all(packed, bytes, count);
  if (compression == Compression::zstd) return unpack_zstd(packed, bytes, count);
  if (compression == Compression::blosc) return unpack_blosc(packed, bytes, count);
  if (packed.size() != count)
    return base::format("has %zu bytes instead of %zu", packed.size(), count);
  std::copy(packed.begin(), packed.end(), bytes);
  return "";
}

}  // namespace stroma::image
