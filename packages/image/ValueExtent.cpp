#include "image/ValueExtent.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "base/Log.hpp"
#include "image/ImageSource.hpp"

namespace stroma::image {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void too_short(const std::string& path, std::uint64_t needed, std::uint64_t found) {
  refuse(path, base::format("is truncated: its header announces %llu bytes, %llu are there",
                            static_cast<unsigned long long>(needed),
                            static_cast<unsigned long long>(found)));
}

void check_metaimage(const std::string& path, std::uint64_t bytes) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line)) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    const auto word = [](const std::string& text) {
      const std::size_t first = text.find_first_not_of(" \t\r");
      return first == std::string::npos
                 ? std::string()
                 : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
    };
    const std::string name = word(line.substr(0, equals)), value = word(line.substr(equals + 1));
    const bool said_yes = !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
    if (name == "CompressedData" && said_yes) return;
    if (name == "BinaryData" && !said_yes) return;
    if (name != "ElementDataFile") continue;
    if (value == "LOCAL" || value == "Local" || value == "local") {
      const std::uint64_t needed = static_cast<std::uint64_t>(file.tellg()) + bytes;
      if (fs::file_size(path) < needed) too_short(path, needed, fs::file_size(path));
      return;
    }
    const fs::path other = fs::path(path).parent_path() / value;
    if (fs::is_regular_file(other) && fs::file_size(other) < bytes)
      too_short(other.string(), bytes, fs::file_size(other));
    return;
  }
}

struct CloseGzip {
  void operator()(gzFile file) const { gzclose(file); }
};

/// Where the values of a NIfTI file start, from its header in either byte order.
std::uint64_t nifti_offset(const std::vector<unsigned char>& header) {
  const auto integer = [&](std::size_t at, int size, bool swapped) {
    std::vector<unsigned char> raw(header.begin() + static_cast<long>(at),
                                   header.begin() + static_cast<long>(at) + size);
    if (swapped) std::reverse(raw.begin(), raw.end());
    std::uint64_t value = 0;
    std::memcpy(&value, raw.data(), static_cast<std::size_t>(size));
    return value;
  };
  const bool second_version = integer(0, 4, false) == 540 || integer(0, 4, true) == 540;
  const bool swapped = integer(0, 4, true) == (second_version ? 540u : 348u);
  if (second_version) return integer(168, 8, swapped);
  const auto raw = static_cast<std::uint32_t>(integer(108, 4, swapped));
  float offset = 0.0f;
  std::memcpy(&offset, &raw, sizeof offset);
  return offset > 0.0f ? static_cast<std::uint64_t>(offset) : 0;
}

void check_nifti(const std::string& path, std::uint64_t bytes) {
  const std::unique_ptr<gzFile_s, CloseGzip> file(
      gzopen(path.c_str(), "rb"));  // reads plain files as well
  std::vector<unsigned char> buffer(1 << 20);
  constexpr std::uint64_t header_bytes = 540;
  const int got = file ? gzread(file.get(), buffer.data(), header_bytes) : -1;
  if (got < 348) too_short(path, 348, static_cast<std::uint64_t>(std::max(got, 0)));
  const fs::path values = fs::path(path).replace_extension(".img");
  const bool two_files =
      std::memcmp(&buffer[344], "ni1", 3) == 0 || std::memcmp(&buffer[4], "ni2", 3) == 0;
  const std::uint64_t needed = nifti_offset(buffer) + bytes;
  if (two_files) {
    if (fs::is_regular_file(values) && fs::file_size(values) < needed)
      too_short(values.string(), needed, fs::file_size(values));
    return;
  }
  std::uint64_t there = fs::file_size(path);
  if (gzdirect(file.get()) == 0) {
    // Only decompression tells how much a gzip file holds.
    there = static_cast<std::uint64_t>(got);
    for (int more = got; more > 0 && there < needed;
         there += static_cast<std::uint64_t>(std::max(more, 0)))
      more = gzread(file.get(), buffer.data(), static_cast<unsigned>(buffer.size()));
  }
  if (there < needed) too_short(path, needed, there);
}

}  // namespace

void require_all_values(const std::string& path, const std::string& format, std::uint64_t bytes) {
  if (format == "MetaImage") check_metaimage(path, bytes);
  if (format == "NIfTI") check_nifti(path, bytes);
}

}  // namespace stroma::image
