// SPDX-License-Identifier: BSD-3-Clause

#include "WriteFiles.hpp"

#include <hdf5.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "stroma/base/Log.hpp"

namespace stroma::test {
namespace {

template <class T>
std::string bytes_of(double value, bool big_endian) {
  const T typed = static_cast<T>(value);
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &typed, sizeof(T));
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

class Folder {
 public:
  Folder() {
    const base::Communicator world = base::Communicator::world();
    if (world.is_root()) {
      path_ = (std::filesystem::temp_directory_path() / "stroma_image_XXXXXX").string();
      if (mkdtemp(path_.data()) == nullptr) std::abort();
    }
    world.broadcast(path_);
    owner_ = world.is_root();
  }
  ~Folder() {
    std::error_code ignored;
    if (owner_) std::filesystem::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool owner_ = false;
};

std::string words(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes += encode(value, {Kind::unsigned_integer, 2}, false);
  return bytes;
}

}  // namespace

Pattern pattern_for(const ValueType& type) {
  return [type](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t c) {
    const double base = static_cast<double>((x + 7 * y + 31 * z + 101 * c + 3) % 251);
    if (type.kind == Kind::floating) return 0.25 * base - 17.5;
    const double scale = type.bytes == 1 ? 1.0 : type.bytes == 2 ? 257.0 : 16843009.0;
    const double offset = type.kind == Kind::signed_integer ? 128.0 * scale : 0.0;
    return base * scale - offset;
  };
}

const std::string& folder() {
  static const Folder instance;
  return instance.path();
}

void on_root(const std::function<void()>& work) {
  if (base::Communicator::world().is_root()) work();
  base::Communicator::world().barrier();
}

std::string encode(double value, const ValueType& type, bool big_endian) {
  if (type.kind == Kind::floating)
    return type.bytes == 4 ? bytes_of<float>(value, big_endian)
                           : bytes_of<double>(value, big_endian);
  const bool has_sign = type.kind == Kind::signed_integer;
  switch (type.bytes) {
    case 1:
      return has_sign ? bytes_of<std::int8_t>(value, big_endian)
                      : bytes_of<std::uint8_t>(value, big_endian);
    case 2:
      return has_sign ? bytes_of<std::int16_t>(value, big_endian)
                      : bytes_of<std::uint16_t>(value, big_endian);
    case 4:
      return has_sign ? bytes_of<std::int32_t>(value, big_endian)
                      : bytes_of<std::uint32_t>(value, big_endian);
    default:
      return bytes_of<std::int64_t>(value, big_endian);
  }
}

std::string encode(const std::array<std::int64_t, 3>& size, const ValueType& type, bool big_endian,
                   const Pattern& pattern, std::int64_t channel) {
  std::string bytes;
  for (std::int64_t z = 0; z < size[2]; ++z) {
    for (std::int64_t y = 0; y < size[1]; ++y) {
      for (std::int64_t x = 0; x < size[0]; ++x)
        bytes += encode(pattern(x, y, z, channel), type, big_endian);
    }
  }
  return bytes;
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void write_tiff_file(const std::string& path, const TiffOptions& o, const Pattern& pattern) {
  const std::string mode = std::string("w") + (o.big_tiff ? "8" : "") + (o.big_endian ? "b" : "l");
  TIFF* file = TIFFOpen(path.c_str(), mode.c_str());
  const int formats[] = {SAMPLEFORMAT_UINT, SAMPLEFORMAT_INT, SAMPLEFORMAT_IEEEFP};
  const std::int64_t pages = o.size[2] * o.channels;
  for (std::int64_t page = 0; page < pages; ++page) {
    const std::int64_t z = o.z_fastest ? page % o.size[2] : page / o.channels;
    const std::int64_t c = o.z_fastest ? page / o.size[2] : page % o.channels;
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(o.size[0]));
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(o.size[1]));
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8 * o.type.bytes);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, o.samples);
    TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, formats[static_cast<int>(o.type.kind)]);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC,
                 o.samples == 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
    TIFFSetField(file, TIFFTAG_PLANARCONFIG,
                 o.samples_apart ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
    TIFFSetField(file, TIFFTAG_COMPRESSION, o.compression);
    TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, o.resolution_unit);
    if (o.resolution_x) TIFFSetField(file, TIFFTAG_XRESOLUTION, *o.resolution_x);
    if (o.resolution_y) TIFFSetField(file, TIFFTAG_YRESOLUTION, *o.resolution_y);
    if (!o.subfile_types.empty())
      TIFFSetField(file, TIFFTAG_SUBFILETYPE, o.subfile_types.at(static_cast<std::size_t>(page)));
    if (page == 0 && !o.description.empty())
      TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION, o.description.c_str());
    const auto value = [&](std::int64_t x, std::int64_t y, int sample) {
      return encode(pattern(x, y, z, o.samples > 1 ? sample : c), o.type, HOST_BIGENDIAN);
    };
    if (o.tiled) {
      TIFFSetField(file, TIFFTAG_TILEWIDTH, 16);
      TIFFSetField(file, TIFFTAG_TILELENGTH, 16);
      for (std::int64_t y0 = 0; y0 < o.size[1]; y0 += 16) {
        for (std::int64_t x0 = 0; x0 < o.size[0]; x0 += 16) {
          std::string tile;
          for (std::int64_t y = y0; y < y0 + 16; ++y) {
            for (std::int64_t x = x0; x < x0 + 16; ++x) tile += value(x, y, 0);
          }
          TIFFWriteEncodedTile(file,
                               TIFFComputeTile(file, static_cast<std::uint32_t>(x0),
                                               static_cast<std::uint32_t>(y0), 0, 0),
                               tile.data(), static_cast<tmsize_t>(tile.size()));
        }
      }
    } else {
      TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 3);  // so that the last strip is shorter
      for (int sample = 0; sample < (o.samples_apart ? o.samples : 1); ++sample) {
        for (std::int64_t y0 = 0; y0 < o.size[1]; y0 += 3) {
          std::string strip;
          for (std::int64_t y = y0; y < std::min(y0 + 3, o.size[1]); ++y) {
            for (std::int64_t x = 0; x < o.size[0]; ++x) {
              if (o.samples_apart) strip += value(x, y, sample);
              for (int s = 0; s < o.samples && !o.samples_apart; ++s) strip += value(x, y, s);
            }
          }
          const auto number = TIFFComputeStrip(file, static_cast<std::uint32_t>(y0),
                                               static_cast<std::uint16_t>(sample));
          TIFFWriteEncodedStrip(file, number, strip.data(), static_cast<tmsize_t>(strip.size()));
        }
      }
    }
    TIFFWriteDirectory(file);
  }
  TIFFClose(file);
}

std::string tiff_head(std::int64_t width, std::int64_t height, std::int64_t values_at,
                      const std::string& description, bool big_endian) {
  const ValueType u16{Kind::unsigned_integer, 2}, u32{Kind::unsigned_integer, 4};
  const auto number = [&](std::int64_t value, const ValueType& type) {
    return encode(static_cast<double>(value), type, big_endian);
  };
  std::string directory;
  std::int64_t entries = 0;
  const auto entry = [&](int tag, int type, std::int64_t count, std::int64_t value) {
    directory += number(tag, u16) + number(type, u16) + number(count, u32) + number(value, u32);
    ++entries;
  };
  constexpr std::int64_t description_at = 200;
  constexpr int integer = 4, text = 2;
  entry(256, integer, 1, width);
  entry(257, integer, 1, height);
  entry(258, integer, 1, 8);
  entry(262, integer, 1, 1);
  entry(270, text, static_cast<std::int64_t>(description.size()) + 1, description_at);
  entry(273, integer, 1, values_at);
  entry(277, integer, 1, 1);
  entry(278, integer, 1, height);
  entry(279, integer, 1, width * height);
  std::string file = (big_endian ? "MM" : "II") + number(42, u16) + number(8, u32);
  file += number(entries, u16) + directory + number(0, u32);
  file.resize(description_at, '\0');
  file += description;
  file.resize(static_cast<std::size_t>(values_at), '\0');
  return file;
}

void write_pic(const std::string& path, const std::array<std::int64_t, 3>& size, int bytes,
               const Pattern& pattern, const std::vector<std::string>& notes) {
  std::string file = words(
      {static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]), 0, 255});
  file += words({notes.empty() ? 0 : 1, 0, bytes == 1 ? 1 : 0, 0});
  file += std::string(32, '\0');  // name
  file += words(
      {0, 7, 12345, 0, 255, 7, 0, 20});  // merged, colour, magic number, ramp, colour, edited, lens
  file += std::string(10, '\0');
  file += encode(size, {Kind::unsigned_integer, bytes}, false, pattern);
  for (std::size_t i = 0; i < notes.size(); ++i) {
    std::string text = notes[i];
    text.resize(80, '\0');
    file += words({0, i + 1 < notes.size() ? 1 : 0, 0, 1, 0x100, 20, 0, 0}) + text;
  }
  write_bytes(path, file);
}

void write_nrrd(const std::string& path, const std::array<std::int64_t, 3>& size,
                const std::string& type_name, const ValueType& type, bool big_endian,
                const Pattern& pattern, const std::string& spacing_fields) {
  const std::string header = base::format(
      "NRRD0004\ntype: %s\ndimension: 3\nsizes: %d %d %d\nencoding: raw\nendian: %s\n%s\n",
      type_name.c_str(), static_cast<int>(size[0]), static_cast<int>(size[1]),
      static_cast<int>(size[2]), big_endian ? "big" : "little", spacing_fields.c_str());
  write_bytes(path, header + encode(size, type, big_endian, pattern));
}

void write_metaimage(const std::string& path, const std::array<std::int64_t, 3>& size,
                     const std::string& type_name, const ValueType& type, bool big_endian,
                     const Pattern& pattern, const std::string& spacing_fields) {
  const std::string header = base::format(
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = %s\n%sDimSize = "
      "%d %d %d\n"
      "ElementType = %s\nElementDataFile = LOCAL\n",
      big_endian ? "True" : "False", spacing_fields.c_str(), static_cast<int>(size[0]),
      static_cast<int>(size[1]), static_cast<int>(size[2]), type_name.c_str());
  write_bytes(path, header + encode(size, type, big_endian, pattern));
}

void write_nifti(const std::string& path, const std::array<std::int64_t, 3>& size, int code,
                 const ValueType& type, const Pattern& pattern, const std::array<float, 3>& spacing,
                 int units) {
  std::string header(352, '\0');
  const auto put = [&](std::size_t at, double value, const ValueType& as) {
    header.replace(at, static_cast<std::size_t>(as.bytes), encode(value, as, false));
  };
  const ValueType i16{Kind::signed_integer, 2}, i32{Kind::signed_integer, 4},
      f32{Kind::floating, 4};
  put(0, 348, i32);
  put(40, 3, i16);
  for (std::size_t d = 0; d < 7; ++d)
    put(42 + 2 * d, d < 3 ? static_cast<double>(size[d]) : 1.0, i16);
  put(70, code, i16);
  put(72, 8 * type.bytes, i16);
  put(76, 1.0, f32);
  for (std::size_t d = 0; d < 3; ++d) put(80 + 4 * d, spacing[d], f32);
  put(108, 352.0, f32);
  put(112, 1.0, f32);
  header[123] = static_cast<char>(units);
  header.replace(344, 3, "n+1");
  write_bytes(path, header + encode(size, type, false, pattern));
}

void write_hdf5(const std::string& path, const std::vector<Hdf5Dataset>& datasets) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  for (const Hdf5Dataset& set : datasets) {
    const Pattern pattern = pattern_for(set.type);
    std::vector<hsize_t> extent;
    if (set.channels > 0) extent.push_back(static_cast<hsize_t>(set.channels));
    if (!set.flat) extent.push_back(static_cast<hsize_t>(set.size[2]));
    extent.push_back(static_cast<hsize_t>(set.size[1]));
    extent.push_back(static_cast<hsize_t>(set.size[0]));
    const hid_t space = H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    if (set.compressed) {
      const std::vector<hsize_t> chunk(extent.size(), 2);
      H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
      H5Pset_deflate(properties, 4);
    }
    const bool has_sign = set.type.kind == Kind::signed_integer;
    const hid_t type = set.type.kind == Kind::floating
                           ? (set.type.bytes == 4 ? H5T_IEEE_F32LE : H5T_IEEE_F64LE)
                       : set.type.bytes == 1 ? (has_sign ? H5T_STD_I8BE : H5T_STD_U8BE)
                       : set.type.bytes == 2 ? (has_sign ? H5T_STD_I16BE : H5T_STD_U16BE)
                       : set.type.bytes == 4 ? (has_sign ? H5T_STD_I32BE : H5T_STD_U32BE)
                                             : H5T_STD_I64LE;
    const hid_t dataset =
        H5Dcreate2(file, set.name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    std::vector<double> values;
    for (std::int64_t c = 0; c < std::max<std::int64_t>(set.channels, 1); ++c) {
      for (std::int64_t z = 0; z < (set.flat ? 1 : set.size[2]); ++z) {
        for (std::int64_t y = 0; y < set.size[1]; ++y) {
          for (std::int64_t x = 0; x < set.size[0]; ++x) values.push_back(pattern(x, y, z, c));
        }
      }
    }
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    if (!set.element_size.empty()) {
      const hsize_t three = set.element_size.size();
      const hid_t line = H5Screate_simple(1, &three, nullptr);
      const hid_t attribute =
          H5Acreate2(dataset, "element_size_um", H5T_IEEE_F64LE, line, H5P_DEFAULT, H5P_DEFAULT);
      H5Awrite(attribute, H5T_NATIVE_DOUBLE, set.element_size.data());
      H5Aclose(attribute);
      H5Sclose(line);
    }
    H5Dclose(dataset);
    H5Pclose(properties);
    H5Sclose(space);
  }
  H5Fclose(file);
}

}  // namespace stroma::test
