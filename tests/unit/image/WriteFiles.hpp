// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Writes small image files of every format, for the tests to read back. Rank 0 writes; all ranks
/// may call.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/image/formats/ImageSummary.hpp"

namespace stroma::test {

using image::ValueType;
using Kind = ValueType::Kind;

/// The value of voxel (x, y, z) of channel c.
using Pattern =
    std::function<double(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t c)>;

/// A pattern whose values differ from voxel to voxel, fill the type's range and are exact in it.
Pattern pattern_for(const ValueType& type);

/// A folder of this run's own; removed when the program ends.
const std::string& folder();
/// Runs on rank 0; the others wait.
void on_root(const std::function<void()>& work);
/// The bytes of one value.
std::string encode(double value, const ValueType& type, bool big_endian);
/// Values of one channel, x fastest.
std::string encode(const std::array<std::int64_t, 3>& size, const ValueType& type, bool big_endian,
                   const Pattern& pattern, std::int64_t channel = 0);
void write_bytes(const std::string& path, const std::string& bytes);
std::string read_bytes(const std::string& path);

/// How a TIFF file is to be.
struct TiffOptions {
  std::array<std::int64_t, 3> size{5, 4, 3};
  ValueType type;
  std::int64_t channels = 1;  ///< pages: channel fastest, then z
  bool z_fastest = false;     ///< pages: z fastest, then channel
  int samples = 1;            ///< values per pixel; the pattern's channels, then
  bool samples_apart = false;
  bool big_endian = false;
  bool big_tiff = false;
  bool tiled = false;
  int compression = 1;
  std::string description;
  std::optional<double> resolution_x, resolution_y;
  int resolution_unit = 1;         ///< 1: none, 2: inch, 3: cm
  std::vector<int> subfile_types;  ///< NewSubfileType of each page; empty: none is stated
};
void write_tiff_file(const std::string& path, const TiffOptions& options, const Pattern& pattern);

/// The start of a TIFF file with one 8-bit page in one strip, its directory in front, as ImageJ
/// writes it. The values belong at `values_at`, which must be at least 400.
std::string tiff_head(std::int64_t width, std::int64_t height, std::int64_t values_at,
                      const std::string& description, bool big_endian);

/// A Bio-Rad PIC file; `axes` are the texts of its notes.
void write_pic(const std::string& path, const std::array<std::int64_t, 3>& size, int bytes,
               const Pattern& pattern, const std::vector<std::string>& notes);
void write_nrrd(const std::string& path, const std::array<std::int64_t, 3>& size,
                const std::string& type_name, const ValueType& type, bool big_endian,
                const Pattern& pattern, const std::string& spacing_fields);
void write_metaimage(const std::string& path, const std::array<std::int64_t, 3>& size,
                     const std::string& type_name, const ValueType& type, bool big_endian,
                     const Pattern& pattern, const std::string& spacing_fields);
/// \param units  NIfTI's xyzt_units: 0 unknown, 1 m, 2 mm, 3 um
void write_nifti(const std::string& path, const std::array<std::int64_t, 3>& size, int code,
                 const ValueType& type, const Pattern& pattern, const std::array<float, 3>& spacing,
                 int units);

/// A dataset of an HDF5 file.
struct Hdf5Dataset {
  std::string name;
  std::array<std::int64_t, 3> size{5, 4, 3};
  std::int64_t channels = 0;  ///< 0: no channel axis
  bool flat = false;          ///< [y][x]
  bool compressed = false;
  ValueType type;
  std::vector<double> element_size;  ///< z, y, x; empty: no attribute
};
void write_hdf5(const std::string& path, const std::vector<Hdf5Dataset>& datasets);

}  // namespace stroma::test
