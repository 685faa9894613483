// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/StoredValues.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/formats/HeaderText.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/UnpackedFile.hpp"

namespace stroma::image {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void too_short(const std::string& path, std::int64_t needed, std::int64_t found) {
  refuse(path, base::format("is truncated: its header announces %lld bytes, %lld are there",
                            static_cast<long long>(needed), static_cast<long long>(found)));
}

void note_excess(std::vector<std::string>& notes, const std::string& path,
                 const std::string& what) {
  const std::string note =
      fs::path(path).filename().string() + " holds more " + what + " than its header announces";
  if (notes.empty() || notes.back() != note) notes.push_back(note);
}

void require_regular(const std::string& path, const std::string& header) {
  std::error_code trouble;
  const fs::file_status status = fs::status(path, trouble);
  if (!fs::exists(status)) refuse(header, "names the file " + path + ", which does not exist");
  if (!fs::is_regular_file(status)) refuse(header, "names " + path + ", which is no regular file");
  // So are the endless ones of /proc.
  if (fs::file_size(path) == 0) refuse(header, "names " + path + ", which is empty (0 bytes)");
}

/// The byte after `lines` lines from `start` on.
std::uint64_t behind_lines(const std::string& path, std::int64_t start, std::int64_t lines) {
  if (lines == 0) return static_cast<std::uint64_t>(start);
  UnpackedFile file(path, static_cast<std::uint64_t>(start), Packing::none);
  std::vector<unsigned char> piece(1 << 16);
  auto at = static_cast<std::uint64_t>(start);
  while (const std::size_t got = file.read(piece.data(), piece.size())) {
    for (std::size_t i = 0; i < got; ++i)
      if (piece[i] == '\n' && --lines == 0) return at + i + 1;
    at += got;
  }
  refuse(path, base::format("is truncated: %lld lines fewer than its header skips",
                            static_cast<long long>(lines)));
}

constexpr std::size_t longest_word = 1000;  // longer ones are no numbers

/// A word as a value of a type. \throws base::InputError
double parse_value(const std::string& path, const ValueType& type, const std::string& word) {
  const auto value = to_real(word);
  if (!value || word.size() >= longest_word)
    refuse(path, "is broken: \"" + printable(word) + "\" stands where a value is expected");
  if (!type.is_integer()) return *value;
  const bool has_sign = type.kind == ValueType::Kind::signed_integer;
  const double limit = std::ldexp(1.0, 8 * type.bytes - (has_sign ? 1 : 0));
  if (!(*value >= (has_sign ? -limit : 0.0) && *value < limit) || *value != std::floor(*value))
    refuse(path, "is broken: the value " + printable(word) + " is no " + type.name());
  return *value;
}

}  // namespace

StoredValues::StoredValues(const VolumeHeader& header, bool load, std::vector<std::string>& notes)
    : header_(header), type_(header.type) {
  const unsigned one = 1;
  const bool host_is_big = *reinterpret_cast<const unsigned char*>(&one) == 0;
  swapped_ = header.big_endian != host_is_big;
  if (header.encoding == Encoding::text) {
    type_ = {ValueType::Kind::floating, 8};
    swapped_ = false;
  }
  for (const std::string& path : header_.files) require_regular(path, header_.path);
  for (const std::string& path : header_.files) {
    try {
      if (header.encoding == Encoding::raw) {
        offsets_.push_back(locate_raw(path, notes));
      } else if (load) {
        header.encoding == Encoding::text ? parse_text(path, notes) : unpack(path, notes);
      }
    } catch (const base::InputError& error) {
      if (path == header.path) throw;
      refuse(header.path, std::string("names a file that is not whole: ") + error.what());
    }
  }
}

std::uint64_t StoredValues::locate_raw(const std::string& path,
                                       std::vector<std::string>& notes) const {
  const auto there = static_cast<std::int64_t>(fs::file_size(path));
  const std::int64_t bytes = header_.bytes_per_file();
  if (header_.byte_skip < 0) {
    if (there - header_.start < bytes) too_short(path, header_.start + bytes, there);
    return static_cast<std::uint64_t>(there - bytes);
  }
  const auto begin =
      static_cast<std::int64_t>(behind_lines(path, header_.start, header_.line_skip)) +
      header_.byte_skip;
  if (there < begin + bytes) too_short(path, begin + bytes, there);
  if (there > begin + bytes) note_excess(notes, path, "bytes");
  return static_cast<std::uint64_t>(begin);
}

void StoredValues::unpack(const std::string& path, std::vector<std::string>& notes) {
  const Packing packing = header_.encoding == Encoding::bzip2 ? Packing::bzip2 : Packing::gzip;
  UnpackedFile file(path, behind_lines(path, header_.start, header_.line_skip), packing);
  constexpr std::int64_t piece = 1 << 20;
  std::vector<unsigned char> unused(static_cast<std::size_t>(piece));
  const std::int64_t needed = header_.byte_skip + header_.bytes_per_file();
  std::int64_t got = 0;
  const auto take = [&](std::int64_t count, unsigned char* to) {
    const auto read = static_cast<std::int64_t>(file.read(to, static_cast<std::size_t>(count)));
    got += read;
    if (read < count) too_short(path, needed, got);
  };
  while (got < header_.byte_skip) take(std::min(header_.byte_skip - got, piece), unused.data());
  while (got < needed) {
    const std::int64_t count = std::min(needed - got, piece);
    bytes_.resize(bytes_.size() + static_cast<std::size_t>(count));
    take(count, bytes_.data() + bytes_.size() - static_cast<std::size_t>(count));
  }
  // Reading on also compares the checksum at the stream's end.
  if (file.read(unused.data(), 1) == 1) note_excess(notes, path, "bytes");
}

void StoredValues::parse_text(const std::string& path, std::vector<std::string>& notes) {
  UnpackedFile file(path,
                    behind_lines(path, header_.start, header_.line_skip) +
                        static_cast<std::uint64_t>(header_.byte_skip),
                    Packing::none);
  const std::int64_t count = header_.values / static_cast<std::int64_t>(header_.files.size());
  const std::int64_t least = 2 * count - 1;  // a digit and a blank each
  if (static_cast<std::int64_t>(fs::file_size(path)) < least)
    too_short(path, least, static_cast<std::int64_t>(fs::file_size(path)));
  std::int64_t found = 0;
  std::string word;
  const auto end_word = [&] {
    if (word.empty()) return;
    if (++found <= count) {
      const double value = parse_value(path, header_.type, word);
      unsigned char raw[sizeof value];
      std::memcpy(raw, &value, sizeof value);
      bytes_.insert(bytes_.end(), raw, raw + sizeof value);
    }
    word.clear();
  };
  std::vector<unsigned char> piece(1 << 16);
  while (const std::size_t got = file.read(piece.data(), piece.size())) {
    for (std::size_t i = 0; i < got && found <= count; ++i) {
      if (std::isspace(piece[i])) {
        end_word();
      } else if (word.size() < longest_word) {
        word += static_cast<char>(piece[i]);
      }
    }
    if (found > count) break;
  }
  if (found == count - 1 && !word.empty())
    notes.push_back(fs::path(path).filename().string() +
                    " ends right behind its last value, which may have been cut short");
  end_word();
  if (found < count)
    refuse(path, base::format("is truncated: its header announces %lld values, %lld are there",
                              static_cast<long long>(count), static_cast<long long>(found)));
  if (found > count) note_excess(notes, path, "values");
}

const unsigned char* StoredValues::bytes(std::int64_t first, std::int64_t count) {
  const std::int64_t size = type_.bytes;
  if (header_.encoding != Encoding::raw) return bytes_.data() + first * size;
  bytes_.resize(static_cast<std::size_t>(count * size));
  const std::int64_t per_file = header_.bytes_per_file() / size;
  for (std::int64_t done = 0; done < count;) {
    const std::int64_t value = first + done;
    const std::int64_t within = value % per_file, part = std::min(per_file - within, count - done);
    const auto number = static_cast<std::size_t>(value / per_file);
    const std::string& path = header_.files[number];
    UnpackedFile file(path, offsets_[number] + static_cast<std::uint64_t>(within * size),
                      Packing::none);
    const auto wanted = static_cast<std::size_t>(part * size);
    if (file.read(bytes_.data() + done * size, wanted) != wanted)
      refuse(path, "ends in the middle of its values (truncated)");
    done += part;
  }
  return bytes_.data();
}

}  // namespace stroma::image
