// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/ImageSource.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/formats/UnpackedFile.hpp"

namespace stroma::image {
namespace {

enum class Format { tiff, pic, hdf5, metaimage, nrrd, nifti, zarr };

bool begins_with(const std::string& head, const std::string& magic) {
  return head.compare(0, magic.size(), magic) == 0;
}

/// By the size of its header, in either byte order: whether it is whole, its reader says.
bool is_nifti(const std::string& head) {
  for (const std::string size : {"\x5C\x01", "\x1C\x02"}) {  // 348, 540
    const std::string zeros(2, '\0'), reversed(size.rbegin(), size.rend());
    if (begins_with(head, size + zeros) || begins_with(head, zeros + reversed)) return true;
  }
  return false;
}

/// The first bytes of a file, after the questions that come before its format.
std::string first_bytes(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code trouble;
  const fs::file_status status = fs::status(path, trouble);
  if (!fs::exists(status)) refuse(path, "no such file");
  if (fs::is_directory(status))
    refuse(path, "is a folder; admissible: an image file, or a folder of Zarr");
  if (!fs::is_regular_file(status)) refuse(path, "is not a regular file");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(path, "cannot be opened for reading");
  std::string head(1024, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  if (head.empty()) refuse(path, "is empty (0 bytes)");
  return head;
}

/// HDF5's signature stands at the begin, or behind a block of the user's of 512, 1024, ... bytes, such as
/// the head of a MATLAB 7.3 file.
bool has_hdf5_signature(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string signature(8, '\0');
  for (std::streamoff at = 0; file.seekg(at) && file.read(signature.data(), 8);
       at = at == 0 ? 512 : 2 * at)
    if (signature == "\x89HDF\r\n\x1a\n") return true;
  return false;
}

Format format_of(const std::string& path) {
  if (is_zarr(path)) return Format::zarr;
  const std::string head = first_bytes(path);
  const bool tiff_order = begins_with(head, "II") || begins_with(head, "MM");
  if (tiff_order && head.size() >= 4 && (head[2] + head[3] == 42 || head[2] + head[3] == 43))
    return Format::tiff;  // 42: classic, 43: BigTIFF
  if (has_hdf5_signature(path)) return Format::hdf5;
  if (begins_with(head, "NRRD")) return Format::nrrd;
  if (is_nifti(head)) return Format::nifti;
  if (head.find("ObjectType") != std::string::npos || head.find("NDims") != std::string::npos)
    return Format::metaimage;
  if (is_gzip(head)) {
    if (is_nifti(first_unpacked_bytes(path, 4, Packing::gzip))) return Format::nifti;
    refuse(path, "is packed by gzip, and holds no NIfTI image; unpack it first");
  }
  if (head.size() >= 56 && head[54] == '\x39' && head[55] == '\x30') return Format::pic;
  refuse(path,
         "is in no format known here (judged by its first bytes); admissible: TIFF, Bio-Rad PIC, "
         "NRRD, MetaImage, NIfTI, HDF5, and folders of Zarr");
}

/// IEEE 754's 16 bits, which C++17 has no type for.
struct Half {
  std::uint16_t bits;

  explicit operator double() const {
    const int exponent = bits >> 10 & 0x1f;
    const double fraction = (bits & 0x3ff) / 1024.0;
    const double size = exponent == 0    ? std::ldexp(fraction, -14)
                        : exponent == 31 ? (fraction == 0.0 ? HUGE_VAL : std::nan(""))
                                         : std::ldexp(1.0 + fraction, exponent - 15);
    return bits & 0x8000 ? -size : size;
  }
};

template <class T>
void decode_as(const unsigned char* bytes, bool swapped, std::int64_t count, std::int64_t stride,
               double* values) {
  for (std::int64_t i = 0; i < count; ++i) {
    unsigned char one[sizeof(T)];
    std::memcpy(one, bytes + static_cast<std::size_t>(i * stride) * sizeof(T), sizeof(T));
    if (swapped) std::reverse(one, one + sizeof(T));
    T value;
    std::memcpy(&value, one, sizeof(T));
    values[i] = static_cast<double>(value);
  }
}

}  // namespace

void refuse(const std::string& path, const std::string& what) {
  throw base::InputError(path + ": " + what);
}

void check_size(const std::string& path, const std::array<std::int64_t, 3>& size,
                std::int64_t values_per_voxel, int bytes_per_value, std::uint64_t file_length,
                double expansion) {
  const std::string claim =
      base::format("%lld x %lld x %lld voxels", static_cast<long long>(size[0]),
                   static_cast<long long>(size[1]), static_cast<long long>(size[2]));
  if (*std::min_element(size.begin(), size.end()) < 1)
    refuse(path, "says that it holds " + claim + "; admissible: at least 1 x 1 x 1");
  const double needed = static_cast<double>(size[0]) * static_cast<double>(size[1]) *
                        static_cast<double>(size[2]) * static_cast<double>(values_per_voxel) *
                        bytes_per_value;
  if (needed > expansion * static_cast<double>(file_length)) {
    refuse(path,
           "says that it holds " + claim +
               base::format(
                   ", which take %.0f bytes; its %llu bytes cannot hold them (broken or truncated)",
                   needed, static_cast<unsigned long long>(file_length)));
  }
}

std::string not_applied(const std::string& attribute) {
  return "its attribute " + attribute + " is not applied: the values are those stored";
}

void check_channel(const std::string& path, std::int64_t channel, std::int64_t channels) {
  if (channel >= 0 && channel < channels) return;
  refuse(path, base::format("has no channel %lld (Image|Channel); admissible: 0 to %lld",
                            static_cast<long long>(channel), static_cast<long long>(channels - 1)));
}

void check_frame(const std::string& path, std::int64_t frame, std::int64_t frames) {
  if (frame >= 0 && frame < frames) return;
  refuse(path, base::format("has no frame %lld (Image|Frame); admissible: 0 to %lld",
                            static_cast<long long>(frame), static_cast<long long>(frames - 1)));
}

void decode(const unsigned char* bytes, const ValueType& type, bool swapped, std::int64_t count,
            std::int64_t stride, double* values) {
  const auto as = [&](auto example) {
    decode_as<decltype(example)>(bytes, swapped, count, stride, values);
  };
  using Kind = ValueType::Kind;
  if (type.kind == Kind::floating)
    return type.bytes == 2 ? as(Half{}) : type.bytes == 4 ? as(float{}) : as(double{});
  const bool has_sign = type.kind == Kind::signed_integer;
  switch (type.bytes) {
    case 1:
      return has_sign ? as(std::int8_t{}) : as(std::uint8_t{});
    case 2:
      return has_sign ? as(std::int16_t{}) : as(std::uint16_t{});
    case 4:
      return has_sign ? as(std::int32_t{}) : as(std::uint32_t{});
    default:
      return has_sign ? as(std::int64_t{}) : as(std::uint64_t{});
  }
}

void read_raw(const std::string& path, std::uint64_t offset, const ValueType& type, bool swapped,
              const std::array<std::int64_t, 3>& size, const voxels::Box& box, double* values) {
  std::ifstream file(path, std::ios::binary);
  const std::int64_t row_bytes = size[0] * type.bytes;
  std::vector<unsigned char> rows(static_cast<std::size_t>(row_bytes * box.count[1]));
  for (std::int64_t k = 0; k < box.count[2]; ++k) {
    const std::int64_t row = (box.first[2] + k) * size[1] + box.first[1];
    file.seekg(static_cast<std::streamoff>(offset + static_cast<std::uint64_t>(row * row_bytes)));
    file.read(reinterpret_cast<char*>(rows.data()), static_cast<std::streamsize>(rows.size()));
    if (!file) {
      refuse(path, base::format("ends in the middle of plane %lld (truncated)",
                                static_cast<long long>(box.first[2] + k)));
    }
    for (std::int64_t j = 0; j < box.count[1]; ++j) {
      decode(rows.data() + j * row_bytes + box.first[0] * type.bytes, type, swapped, box.count[0],
             1, values + (k * box.count[1] + j) * box.count[0]);
    }
  }
}

std::unique_ptr<ImageSource> open_image(const base::Communicator& communicator,
                                        const ImageRequest& wanted) {
  ImageRequest request = wanted;
  request.reads_whole = communicator.is_root();
  int format = 0;
  std::unique_ptr<ImageSource> source;
  const auto open = [&] {
    switch (static_cast<Format>(format)) {
      case Format::tiff:
        source = open_tiff(request);
        break;
      case Format::pic:
        source = open_pic(request);
        break;
      case Format::hdf5:
        source = open_hdf5(request);
        break;
      case Format::metaimage:
        source = open_metaimage(request);
        break;
      case Format::nrrd:
        source = open_nrrd(request);
        break;
      case Format::nifti:
        source = open_nifti(request);
        break;
      case Format::zarr:
        source = open_zarr(request);
        break;
    }
    check_frame(request.path, request.frame, source->summary().frames);
  };
  // Rank 0 looks first, so that what is wrong with a file is said once and the others never touch
  // it.
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    format = static_cast<int>(format_of(request.path));
    if (!request.dataset.empty() && static_cast<Format>(format) != Format::hdf5)
      refuse(request.path,
             "is not an HDF5 file, so Image|Dataset \"" + request.dataset + "\" has no meaning");
    open();
  });
  if (communicator.size() == 1) return source;
  communicator.broadcast(format);
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) open();
  });
  return source;
}

}  // namespace stroma::image
