// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/UnpackedFile.hpp"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>

#include "stroma/base/Error.hpp"
#include "stroma/image/formats/ImageSource.hpp"

namespace stroma::image {

/// One packed stream after another.
struct UnpackedFile::Unpacker {
  enum class Outcome { more, ended, broken };

  virtual ~Unpacker() = default;
  /// Unpacks some; moves both ends on.
  virtual Outcome unpack(unsigned char*& from, std::size_t& from_count, unsigned char*& to,
                         std::size_t& to_count) = 0;
  /// What a further stream begins with.
  virtual std::string magic() const = 0;
  virtual void restart() = 0;
};

namespace {

using Outcome = UnpackedFile::Unpacker::Outcome;

constexpr std::size_t piece = 1 << 16;  // both libraries count in 32 bits

class Gzip : public UnpackedFile::Unpacker {
 public:
  Gzip() { inflateInit2(&stream_, 15 + 32); }  // 32: gzip or zlib, as it is found
  ~Gzip() override { inflateEnd(&stream_); }

  Outcome unpack(unsigned char*& from, std::size_t& from_count, unsigned char*& to,
                 std::size_t& to_count) override {
    stream_.next_in = from;
    stream_.avail_in = static_cast<unsigned>(from_count);
    stream_.next_out = to;
    stream_.avail_out = static_cast<unsigned>(to_count);
    const int result = inflate(&stream_, Z_NO_FLUSH);
    from = stream_.next_in;
    from_count = stream_.avail_in;
    to = stream_.next_out;
    to_count = stream_.avail_out;
    if (result == Z_STREAM_END) return Outcome::ended;
    return result == Z_OK || result == Z_BUF_ERROR ? Outcome::more : Outcome::broken;
  }
  std::string magic() const override { return "\x1f\x8b"; }
  void restart() override { inflateReset(&stream_); }

 private:
  z_stream stream_{};
};

class Bzip2 : public UnpackedFile::Unpacker {
 public:
  Bzip2() { BZ2_bzDecompressInit(&stream_, 0, 0); }
  ~Bzip2() override { BZ2_bzDecompressEnd(&stream_); }

  Outcome unpack(unsigned char*& from, std::size_t& from_count, unsigned char*& to,
                 std::size_t& to_count) override {
    stream_.next_in = reinterpret_cast<char*>(from);
    stream_.avail_in = static_cast<unsigned>(from_count);
    stream_.next_out = reinterpret_cast<char*>(to);
    stream_.avail_out = static_cast<unsigned>(to_count);
    const int result = BZ2_bzDecompress(&stream_);
    from = reinterpret_cast<unsigned char*>(stream_.next_in);
    from_count = stream_.avail_in;
    to = reinterpret_cast<unsigned char*>(stream_.next_out);
    to_count = stream_.avail_out;
    if (result == BZ_STREAM_END) return Outcome::ended;
    return result == BZ_OK ? Outcome::more : Outcome::broken;
  }
  std::string magic() const override { return "BZh"; }
  void restart() override {
    BZ2_bzDecompressEnd(&stream_);
    stream_ = bz_stream{};
    BZ2_bzDecompressInit(&stream_, 0, 0);
  }

 private:
  bz_stream stream_{};
};

}  // namespace

UnpackedFile::UnpackedFile(const std::string& path, std::uint64_t offset, Packing packing)
    : path_(path), file_(path, std::ios::binary) {
  if (!file_) refuse(path, "cannot be opened for reading");
  file_.seekg(static_cast<std::streamoff>(offset));
  if (packing == Packing::gzip) unpacker_ = std::make_unique<Gzip>();
  if (packing == Packing::bzip2) unpacker_ = std::make_unique<Bzip2>();
  if (unpacker_) packed_.resize(piece);
}

UnpackedFile::~UnpackedFile() = default;

/// Reads on behind what is left of the packed bytes. False when the file has no more.
bool UnpackedFile::fill() {
  std::memmove(packed_.data(), packed_.data() + at_, end_ - at_);
  end_ -= at_;
  at_ = 0;
  file_.read(reinterpret_cast<char*>(packed_.data() + end_),
             static_cast<std::streamsize>(packed_.size() - end_));
  end_ += static_cast<std::size_t>(file_.gcount());
  return file_.gcount() > 0;
}

std::size_t UnpackedFile::read(unsigned char* to, std::size_t count) {
  if (!unpacker_) {
    file_.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count));
    return static_cast<std::size_t>(file_.gcount());
  }
  std::size_t wanted = count;
  while (wanted > 0) {
    if (stream_ended_) {
      const std::string magic = unpacker_->magic();
      if (end_ - at_ < magic.size()) fill();
      const bool goes_on = end_ - at_ >= magic.size() &&
                           std::memcmp(packed_.data() + at_, magic.data(), magic.size()) == 0;
      if (!goes_on) break;
      unpacker_->restart();
      stream_ended_ = false;
    }
    const bool dry = at_ == end_ && !fill();  // what is inside the unpacker may still come out
    unsigned char* from = packed_.data() + at_;
    std::size_t from_count = end_ - at_, to_count = std::min(wanted, piece);
    const std::size_t room = to_count;
    const Outcome outcome = unpacker_->unpack(from, from_count, to, to_count);
    at_ = end_ - from_count;
    wanted -= room - to_count;
    if (outcome == Outcome::broken)
      refuse(path_, "is broken: its packed values cannot be unpacked");
    stream_ended_ = outcome == Outcome::ended;
    if (dry && !stream_ended_ && to_count == room) break;
  }
  return count - wanted;
}

std::string first_unpacked_bytes(const std::string& path, std::size_t most, Packing packing) {
  UnpackedFile file(path, 0, packing);
  std::string bytes(most, '\0');
  const auto read = [&](std::size_t at, std::size_t count) {
    return file.read(reinterpret_cast<unsigned char*>(&bytes[at]), count);
  };
  std::size_t got = 0;
  if (packing == Packing::none) {
    got = read(0, most);
  } else {
    try {  // byte by byte, so that what comes before a fault is kept
      while (got < most && read(got, 1) == 1) ++got;
    } catch (const base::InputError&) {
    }
  }
  bytes.resize(got);
  return bytes;
}

bool is_gzip(const std::string& head) { return head.compare(0, 2, "\x1f\x8b") == 0; }

}  // namespace stroma::image
