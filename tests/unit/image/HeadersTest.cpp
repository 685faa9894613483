// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// MetaImage, NRRD and NIfTI: every way in which a header may say where values lie, and what a
/// header must not say. The files of tests/data/cases went wrong once.

#include <bzlib.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "ReadBack.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/labels/Histogram.hpp"
#include "support/Places.hpp"

namespace stroma::test {
namespace {

const ValueType u8{Kind::unsigned_integer, 1}, u16{Kind::unsigned_integer, 2},
    i16{Kind::signed_integer, 2}, f32{Kind::floating, 4};
const Size size{5, 4, 3};

std::string at(const std::string& name) { return folder() + "/" + name; }

std::string case_file(const std::string& name) {
  return clone_folder().string() + "/tests/data/cases/" + name;
}

/// Rank 0 writes; the others wait until it is there, and nobody still reads what was there before.
std::string write(const std::string& name, const std::string& bytes) {
  base::Communicator::world().barrier();
  on_root([&] { write_bytes(at(name), bytes); });
  return at(name);
}

std::string stored(const ValueType& type, std::int64_t channel = 0) {
  return encode(size, type, false, pattern_for(type), channel);
}

/// Numbers as text, a line each.
std::string as_text(const ValueType& type) {
  std::string text;
  for (std::int64_t z = 0; z < size[2]; ++z)
    for (std::int64_t y = 0; y < size[1]; ++y)
      for (std::int64_t x = 0; x < size[0]; ++x)
        text += base::format("%.9g\n", pattern_for(type)(x, y, z, 0));
  return text;
}

/// \param window  of zlib: 15 for its own container, 31 for gzip's
std::string deflated(const std::string& bytes, int window) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY);
  std::string packed(bytes.size() + 1000, '\0');
  stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<unsigned>(bytes.size());
  stream.next_out = reinterpret_cast<unsigned char*>(packed.data());
  stream.avail_out = static_cast<unsigned>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string bzipped(const std::string& bytes) {
  std::string packed(bytes.size() + 1000, '\0');
  auto length = static_cast<unsigned>(packed.size());
  BZ2_bzBuffToBuffCompress(packed.data(), &length, const_cast<char*>(bytes.data()),
                           static_cast<unsigned>(bytes.size()), 9, 0, 0);
  packed.resize(length);
  return packed;
}

std::string meta(const std::string& type, const std::string& fields, const std::string& file) {
  return "ObjectType = Image\nNDims = 3\n" + fields +
         "ElementSpacing = 0.5 0.25 2\nDistanceUnits = um\nDimSize = 5 4 3\nElementType = " + type +
         "\nElementDataFile = " + file + "\n";
}

std::string nrrd(const std::string& type, const std::string& fields) {
  return "NRRD0005\ntype: " + type + "\ndimension: 3\nsizes: 5 4 3\nendian: little\n" + fields;
}

image::ImageSummary summary;

voxels::IntensityVolume read(const std::string& path, int channel = 0,
                             std::optional<std::array<int, 6>> region = {}) {
  image::ImageParameters parameters;
  parameters.file = path;
  parameters.channel = channel;
  parameters.region = region;
  return read_back(parameters, summary);
}

void expect_read(const std::string& path, const ValueType& type, int channel = 0) {
  SCOPED_TRACE(path);
  expect_pattern(read(path, channel), size, pattern_for(type), channel);
  expect_pattern(read(path, channel, {{1, 1, 1, 3, 2, 2}}), {3, 2, 2}, pattern_for(type), channel,
                 {1, 1, 1});
}

bool noted(const std::string& words) { return has_note(summary, words); }

TEST(MetaImage, ValuesAsTextOnAnyNumberOfRanks) {
  const voxels::IntensityVolume volume = read(case_file("metaimage_ascii/ascii.mha"));
  for (std::int64_t k = 0; k < volume.planes; ++k)
    for (std::int64_t j = 0; j < 10; ++j)
      for (std::int64_t i = 0; i < 14; ++i)
        ASSERT_EQ(volume.plane(k)[14 * j + i],
                  j + 2 * (k + volume.first_plane) < 10 ? 20.0 : 200.0);
  expect_read(
      write("text16.mha", meta("MET_USHORT", "BinaryData = False\n", "LOCAL") + as_text(u16)), u16);
  write("values.txt", as_text(f32));
  expect_read(write("text.mhd", meta("MET_FLOAT", "BinaryData = False\n", "values.txt")), f32);
}

TEST(MetaImage, PackedValuesWithAndWithoutTheirLength) {
  const voxels::IntensityVolume volume = read(case_file("metaimage_incomplete/nosize.mha"));
  const image::Statistics statistics = image::statistics(base::Communicator::world(), volume);
  EXPECT_EQ(statistics.min, 1);
  EXPECT_EQ(statistics.max, 4089);
  EXPECT_DOUBLE_EQ(statistics.mean, 2045);
  for (const int container : {15, 31}) {
    const std::string packed = deflated(stored(u16), container);
    const std::string length =
        "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\n";
    expect_read(write("packed.mha", meta("MET_USHORT", length, "LOCAL") + packed), u16);
    write("packed.zraw", packed);
    expect_read(write("packed.mhd", meta("MET_USHORT", "CompressedData = True\n", "packed.zraw")),
                u16);
  }
}

TEST(MetaImage, FilesBesideTheHeader) {
  const std::string values = stored(u16);
  write("plain.raw", values);
  expect_read(write("plain.mhd", meta("MET_USHORT", "", "plain.raw")), u16);
  EXPECT_TRUE(noted("little-endian taken"));
  write("headed.raw", "head" + values);
  expect_read(write("headed.mhd", meta("MET_USHORT", "HeaderSize = 4\n", "headed.raw")), u16);
  expect_read(write("last.mhd", meta("MET_USHORT", "HeaderSize = -1\n", "headed.raw")), u16);
  read(write("longer.mhd", meta("MET_USHORT", "", "headed.raw")));
  EXPECT_TRUE(noted("headed.raw holds more bytes than its header announces"));
}

TEST(MetaImage, AFileForEachSlice) {
  const std::string values = stored(u16);
  for (std::size_t z = 0; z < 3; ++z)
    write("s" + std::to_string(4 + 2 * z) + ".raw", values.substr(40 * z, 40));
  expect_read(write("list.mhd", meta("MET_USHORT", "", "LIST") + "s4.raw\ns6.raw\ns8.raw\n"), u16);
  expect_read(write("pattern.mhd", meta("MET_USHORT", "", "s%d.raw 4 8 2")), u16);
  write("all.raw", values);
  expect_read(write("planes.mhd", meta("MET_USHORT", "", "LIST 2D") + "s4.raw\ns6.raw\ns8.raw\n"),
              u16);
  expect_read(write("whole.mhd", meta("MET_USHORT", "", "LIST 3") + "all.raw\n"), u16);
  for (std::size_t z = 0; z < 3; ++z)
    write("p0" + std::to_string(1 + z) + ".z", deflated(values.substr(40 * z, 40), 15));
  expect_read(write("packed_list.mhd", meta("MET_USHORT", "CompressedData = True\n", "p%02d.z")),
              u16);
}

// V-TRACE-2.
TEST(MetaImage, TheFilesItWasReadFromAreListed) {
  const std::string values = stored(u16);
  read(write("local.mha", meta("MET_USHORT", "", "LOCAL") + values));
  EXPECT_EQ(summary.files, std::vector<std::string>{at("local.mha")});
  write("beside.raw", values);
  read(write("beside.mhd", meta("MET_USHORT", "", "beside.raw")));
  EXPECT_EQ(summary.files, (std::vector<std::string>{at("beside.mhd"), at("beside.raw")}));
  for (int z = 0; z < 3; ++z)
    write("f" + std::to_string(z) + ".raw", values.substr(40 * static_cast<std::size_t>(z), 40));
  const std::vector<std::string> all{at("files.nhdr"), at("f0.raw"), at("f1.raw"), at("f2.raw")};
  read(write("files.nhdr", nrrd("uint16", "encoding: raw\ndata file: f%d.raw 0 2 1\n")));
  EXPECT_EQ(summary.files, all);
}

TEST(MetaImage, ChannelsLieTogether) {
  std::string values;
  for (std::int64_t z = 0; z < 3; ++z)
    for (std::int64_t y = 0; y < 4; ++y)
      for (std::int64_t x = 0; x < 5; ++x)
        for (std::int64_t c = 0; c < 2; ++c)
          values += encode(pattern_for(u16)(x, y, z, c), u16, true);
  const std::string path = write(
      "channels.mha",
      meta("MET_USHORT", "ElementNumberOfChannels = 2\nElementByteOrderMSB = True\n", "LOCAL") +
          values);
  for (const int channel : {0, 1}) expect_read(path, u16, channel);
}

TEST(MetaImage, WhatIsMissingIsNamed) {
  expect_refused(case_file("metaimage_slices/stack.mhd"), "slice3.raw, which does not exist");
  expect_refused(case_file("metaimage_incomplete/list.mhd"), "s5.raw, which does not exist");
  expect_refused(case_file("metaimage_incomplete/cut.mha"),
                 "is truncated: its header announces 1680");
  write("short.raw", std::string(119, 'x'));
  expect_refused(write("short.mhd", meta("MET_USHORT", "", "short.raw")),
                 "short.raw: is truncated: its header announces 120 bytes, 119 are there");
  expect_refused(write("few.mhd", meta("MET_UCHAR", "", "LIST") + "short.raw\n"),
                 "lists 1 files; its size takes 3");
  const std::string text = as_text(u16);
  read(write("cut_word.mha", meta("MET_USHORT", "BinaryData = False\n", "LOCAL") +
                                 text.substr(0, text.size() - 3)));
  // What cannot be read in parts is known to rank 0 alone, which writes the notes.
  EXPECT_EQ(noted("may have been cut short"), base::Communicator::world().is_root());
  expect_refused(write("fewer.mha", meta("MET_USHORT", "BinaryData = False\n", "LOCAL") +
                                        text.substr(0, text.size() / 2)),
                 "is truncated: its header announces 60 values");
}

TEST(MetaImage, HeadersThatMustNotBeBelieved) {
  for (const std::string name : {"ndims_negative_hang.mha", "segv.mha"})
    expect_refused(case_file("metaimage_headers/" + name), "a whole number from 1 to 7");
  expect_refused(case_file("metaimage_headers/pat.mhd"), "admissible: exactly one %d");
  for (const char* const pattern :
       {"a%d%d 1 3", "a%s 1 3", "a%n 1 3", "a%999d 1 3", "a% 1 3", "a%"})
    expect_refused(write("pattern.mhd", meta("MET_UCHAR", "", pattern)),
                   "admissible: exactly one %d");
  expect_refused(write("numbers.mhd", meta("MET_UCHAR", "", "a%d 1 4")), "numbers for the 3 files");
  expect_refused(write("step.mhd", meta("MET_UCHAR", "", "a%d 1 3 0")), "numbers for the 3 files");
  on_root([] { mkfifo(at("fifo").c_str(), 0600); });
  expect_refused(write("fifo.mhd", meta("MET_UCHAR", "", "fifo")),
                 "fifo, which is no regular file");
  expect_refused(write("folder.mhd", meta("MET_UCHAR", "", ".")), "which is no regular file");
  expect_refused(write("twice.mha", meta("MET_UCHAR", "NDims = 2\n", "LOCAL")), "says NDims twice");
  expect_refused(write("type.mha", meta("MET_STRING", "", "LOCAL")), "admissible: MET_CHAR");
  expect_refused(write("end.mha", "ObjectType = Image\nNDims = 3\n"), "has no ElementDataFile");
  expect_refused(write("mesh.mha", "ObjectType = Mesh\nNDims = 3\nElementDataFile = LOCAL\n"),
                 "ObjectType \"Mesh\"; admissible: Image");
  for (const std::string sizes : {"4 4", "4 4 4 4", "4 4 -4", "4 4 0", "4 4 four", "4 4 4e9"})
    expect_refused(write("sizes.mha", "NDims = 3\nElementType = MET_UCHAR\nDimSize = " + sizes +
                                          "\nElementDataFile = LOCAL\nx"),
                   "3 whole numbers, at least 1 each");
  expect_refused(write("huge.mha",
                       "NDims = 3\nElementType = MET_UCHAR\nDimSize = 4294967296 "
                       "4294967296 4294967296\nElementDataFile = LOCAL\nx"),
                 "more than any file holds");
  expect_refused(write("slices.mhd",
                       "NDims = 3\nElementType = MET_UCHAR\nDimSize = 1 1 1000000000"
                       "\nElementDataFile = f%d.raw\n"),
                 "admissible: 1 to 100000");
  expect_refused(write("word.mha", meta("MET_UCHAR", "BinaryData = False\n", "LOCAL") + "1 2 x"),
                 "\"x\" stands where a value is expected");
  expect_refused(write("range.mha", meta("MET_UCHAR", "BinaryData = False\n", "LOCAL") + "1 256"),
                 "the value 256 is no 8-bit unsigned integer");
}

TEST(Nrrd, EveryEncodingAndSkip) {
  const std::string values = stored(u16);
  expect_read(write("raw.nrrd", nrrd("uint16", "encoding: raw\n\n") + values), u16);
  expect_read(write("text.nrrd", nrrd("uint16", "encoding: ascii\n\n") + as_text(u16)), u16);
  expect_read(write("gzip.nrrd", nrrd("uint16", "encoding: gzip\n\n") + deflated(values, 31)), u16);
  expect_read(write("bzip2.nrrd", nrrd("uint16", "encoding: bzip2\n\n") + bzipped(values)), u16);
  expect_read(write("two.nrrd", nrrd("uint16", "encoding: bz2\n\n") +
                                    bzipped(values.substr(0, 50)) + bzipped(values.substr(50))),
              u16);
  expect_read(
      write("bytes.nrrd", nrrd("uint16", "encoding: raw\nbyte skip: 3\n\n") + "abc" + values), u16);
  expect_read(
      write("last.nrrd", nrrd("uint16", "encoding: raw\nbyteskip: -1\n\n") + "abc" + values), u16);
  expect_read(write("lines.nrrd", nrrd("uint16", "encoding: raw\nline skip: 2\nbyte skip: 1\n\n") +
                                      "one\ntwo\n3" + values),
              u16);
  expect_read(write("unpacked_skip.nrrd", nrrd("uint16", "encoding: gz\nbyte skip: 3\n\n") +
                                              deflated("abc" + values, 31)),
              u16);
}

TEST(Nrrd, ExtentsAloneAreNoVoxelSize) {
  const std::string extents = "axis mins: 0 0 0\naxis maxs: 5 4 3\nencoding: raw\n\n";
  expect_read(write("extents.nrrd", nrrd("uint8", extents) + stored(u8)), u8);
  EXPECT_FALSE(summary.voxel_size.known(0));
  EXPECT_TRUE(has_note(summary, "axis mins and axis maxs, without spacings"));
}

TEST(Nrrd, FilesBesideTheHeader) {
  const std::string values = stored(u16);
  for (std::size_t z = 0; z < 3; ++z)
    write("n" + std::to_string(1 + z) + ".raw", values.substr(40 * z, 40));
  write("all.raw", values);
  expect_read(write("one.nhdr", nrrd("uint16", "encoding: raw\ndata file: all.raw\n")), u16);
  expect_read(write("list.nhdr", nrrd("uint16",
                                      "encoding: raw\ndata file: LIST\nn1.raw\nn2.raw\n"
                                      "n3.raw\n")),
              u16);
  expect_read(write("pattern.nhdr", nrrd("uint16", "encoding: raw\ndata file: n%d.raw 1 3 1\n")),
              u16);
  // Each file holds a row.
  std::string list;
  for (std::size_t row = 0; row < 12; ++row) {
    write("row" + std::to_string(row), values.substr(10 * row, 10));
    list += "row" + std::to_string(row) + "\n";
  }
  expect_read(write("rows.nhdr", nrrd("uint16", "encoding: raw\ndata file: LIST 1\n" + list)), u16);
}

TEST(Nrrd, ChannelsWhereverTheirAxisIs) {
  // Values in the order of the axes, the first fastest.
  const auto file = [](const std::string& order) {
    std::string values, sizes, kinds;
    std::array<std::int64_t, 4> index{}, count{};
    for (std::size_t d = 0; d < 4; ++d) {
      count[d] = order[d] == 'x' ? 5 : order[d] == 'y' ? 4 : order[d] == 'z' ? 3 : 2;
      sizes += " " + std::to_string(count[d]);
      kinds += order[d] == 'c' ? " vector" : " domain";
    }
    for (index[3] = 0; index[3] < count[3]; ++index[3])
      for (index[2] = 0; index[2] < count[2]; ++index[2])
        for (index[1] = 0; index[1] < count[1]; ++index[1])
          for (index[0] = 0; index[0] < count[0]; ++index[0]) {
            const auto of = [&](char axis) { return index[order.find(axis)]; };
            values += encode(pattern_for(u8)(of('x'), of('y'), of('z'), of('c')), u8, false);
          }
    return "NRRD0004\ntype: uchar\ndimension: 4\nsizes:" + sizes + "\nkinds:" + kinds +
           "\nencoding: raw\n\n" + values;
  };
  for (const std::string order : {"cxyz", "xcyz", "xycz", "xyzc"}) {
    SCOPED_TRACE(order);
    const std::string path = write("channels.nrrd", file(order));
    for (const int channel : {0, 1}) expect_read(path, u8, channel);
    EXPECT_EQ(summary.channels, 2);
  }
}

TEST(Nrrd, HeadersThatMustNotBeBelieved) {
  expect_refused(case_file("nrrd_headers/dim10.nrrd"), "a whole number from 1 to 7");
  expect_refused(case_file("nrrd_headers/p.nhdr"), "admissible: exactly one %d");
  const auto with = [](const std::string& fields) {
    return write("bad.nrrd", "NRRD0004\n" + fields + "\nx");
  };
  expect_refused(with("type: uchar\ndimension: 8\nsizes: 1\nencoding: raw\n"), "from 1 to 7");
  expect_refused(with("type: uchar\ndimension: 3\nsizes: 1 1\nencoding: raw\n"),
                 "3 whole numbers, at least 1 each");
  expect_refused(with("type: block\ndimension: 1\nsizes: 1\nencoding: raw\n"), "type \"block\"");
  expect_refused(with("type: uchar\ndimension: 1\nsizes: 1\nencoding: hex\n"),
                 "encoding \"hex\"; admissible: raw, ascii, gzip, bzip2");
  expect_refused(with("type: short\ndimension: 1\nsizes: 1\nencoding: raw\n"), "has no endian");
  expect_refused(with("type: uchar\ntype: uchar\n"), "says type twice");
  expect_refused(with("type: uchar\ndimension: 4\nsizes: 1 1 1 2\nencoding: raw\n"),
                 "at most three axes of space");
  expect_refused(with("type: uchar\ndimension: 1\nsizes: 1\nencoding: raw\ndata file: fifo\n"),
                 "fifo, which is no regular file");
  expect_refused(
      with("type: uchar\ndimension: 1\nsizes: 1\nencoding: raw\ndata file: a%d 1 9999999999 1\n"),
      "admissible: 1 to 100000");
  expect_refused(write("new.nrrd", "NRRD0006\n\nx"), "NRRD0001 to NRRD0005");
  std::string damaged = deflated(stored(u16), 31);
  damaged[damaged.size() - 6] = static_cast<char>(damaged[damaged.size() - 6] ^ 1);  // checksum
  expect_refused(write("crc.nrrd", nrrd("uint16", "encoding: gzip\n\n") + damaged),
                 "cannot be unpacked");
  const std::string packed = bzipped(stored(u16));
  expect_refused(write("cut.nrrd",
                       nrrd("uint16", "encoding: bzip2\n\n") + packed.substr(0, packed.size() / 2)),
                 "is truncated: its header announces 120 bytes");
}

TEST(Spacing, NoLengthIsNoVoxelSize) {
  read(case_file("nrrd_nan_spacing/nan.nrrd"));
  EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.5, 0.25, 0.0}));
  EXPECT_TRUE(noted("spacing along z, nan, is no length; not used"));
  for (const std::string z : {"nan", "inf", "-inf", "0"}) {
    SCOPED_TRACE(z);
    const float number = std::stof(z);
    const std::vector<std::string> files = {
        write("z.nrrd", nrrd("uchar",
                             "encoding: raw\nspace dimension: 3\nspace directions: "
                             "(0.5,0,0) (0,0.25,0) (0,0," +
                                 z + ")\nspace units: \"um\" \"um\" \"um\"\n\n") +
                            stored(u8)),
        write("z.mha",
              "NDims = 3\nDimSize = 5 4 3\nElementType = MET_UCHAR\nDistanceUnits = um\n"
              "ElementSpacing = 0.5 0.25 " +
                  z + "\nElementDataFile = LOCAL\n" + stored(u8)),
        at("z.nii")};
    on_root([&] {
      write_nifti(at("z.nii"), size, 2, u8, pattern_for(u8), {0.5f, 0.25f, number}, 3);
    });
    for (const std::string& path : files) {
      SCOPED_TRACE(path);
      read(path);
      EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.5, 0.25, 0.0}));
      EXPECT_TRUE(noted("is no length; not used"));
    }
  }
  read(write("negative.nrrd", nrrd("uchar",
                                   "encoding: raw\nspacings: 0.5 -0.25 2\nunits: \"um\" "
                                   "\"nm\" \"mm\"\n\n") +
                                  stored(u8)));
  EXPECT_NEAR(summary.voxel_size.um[1], 0.25e-3, 1e-18);
  EXPECT_DOUBLE_EQ(summary.voxel_size.um[2], 2e3);
  EXPECT_TRUE(noted("is negative, -0.25; its size is taken"));
}

/// A NIfTI header; fields are set by what follows.
class NiftiHead {
 public:
  NiftiHead(int version, bool big_endian)
      : second_(version == 2), big_(big_endian), bytes_(second_ ? 544 : 352, '\0') {
    put(0, second_ ? 540 : 348, i32());
    bytes_.replace(second_ ? 4 : 344, 3, second_ ? "n+2" : "n+1");
    dims({3, 5, 4, 3, 1, 1, 1, 1});
    type(512, 16);
    spacing({1, 0.5, 0.25, 2});
    put(second_ ? 168 : 108, second_ ? 544 : 352, second_ ? i64() : f32);
    units(3);
  }
  NiftiHead& dims(const std::vector<double>& d) {
    for (std::size_t i = 0; i < d.size(); ++i)
      second_ ? put(16 + 8 * i, d[i], i64()) : put(40 + 2 * i, d[i], i16);
    return *this;
  }
  NiftiHead& type(int code, int bits) {
    put(second_ ? 12 : 70, code, i16);
    put(second_ ? 14 : 72, bits, i16);
    return *this;
  }
  NiftiHead& spacing(const std::vector<double>& p) { return reals(76, 104, p); }
  NiftiHead& scaling(double slope, double intercept) { return reals(112, 176, {slope, intercept}); }
  NiftiHead& sform(const std::vector<double>& rows) {
    second_ ? put(348, 1, i32()) : put(254, 1, i16);
    return reals(280, 400, rows);
  }
  NiftiHead& units(int code) {
    second_ ? put(500, code, i32()) : put(123, code, u8);
    return *this;
  }
  NiftiHead& two_files() {
    bytes_.replace(second_ ? 4 : 344, 3, second_ ? "ni2" : "ni1");
    put(second_ ? 168 : 108, 0, second_ ? i64() : f32);
    return *this;
  }
  NiftiHead& put(std::size_t place, double value, const ValueType& as) {
    bytes_.replace(place, static_cast<std::size_t>(as.bytes), encode(value, as, big_));
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  static ValueType i32() { return {Kind::signed_integer, 4}; }
  static ValueType i64() { return {Kind::signed_integer, 8}; }
  NiftiHead& reals(std::size_t place1, std::size_t place2, const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      second_ ? put(place2 + 8 * i, values[i], {Kind::floating, 8})
              : put(place1 + 4 * i, values[i], f32);
    return *this;
  }

  bool second_, big_;
  std::string bytes_;
};

TEST(Nifti, BothVersionsInBothByteOrders) {
  for (const int version : {1, 2}) {
    for (const bool big : {false, true}) {
      const std::string values = encode(size, u16, big, pattern_for(u16));
      const NiftiHead head(version, big);
      expect_read(write("plain.nii", head.bytes() + values), u16);
      EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.5, 0.25, 2.0}));
      EXPECT_EQ(summary.format, "NIfTI");
      EXPECT_TRUE(summary.notes.empty());
      expect_read(write("packed_whatever_its_name", deflated(head.bytes() + values, 31)), u16);
      on_root([] { std::filesystem::remove(at("pair.img")); });
      const std::string pair = NiftiHead(version, big).two_files().bytes();
      write("pair.hdr", pair);
      write("pair.img.gz", deflated(values, 31));
      expect_read(at("pair.hdr"), u16);
      write("pair.img", values);
      expect_read(at("pair.hdr"), u16);
    }
  }
}

TEST(Nifti, SlopeAndIntercept) {
  const voxels::IntensityVolume volume = read(case_file("nifti_slope/slope.nii"));
  for (std::int64_t k = 0; k < volume.planes; ++k)
    for (std::int64_t v = 0; v < 140; ++v)
      ASSERT_NEAR(volume.plane(k)[v],
                  static_cast<double>(140 * (k + volume.first_plane) + v) * 0.013 - 7.7, 1e-4);
  EXPECT_EQ(summary.type.name(), "64-bit float");
  EXPECT_TRUE(noted("values are those stored (16-bit signed integer) times"));
  const Pattern scaled = [](auto x, auto y, auto z, auto c) {
    return 0.5 * pattern_for(u16)(x, y, z, c) - 3.0;
  };
  expect_pattern(read(write("two.nii", NiftiHead(2, true).scaling(0.5, -3.0).bytes() +
                                           encode(size, u16, true, pattern_for(u16)))),
                 size, scaled);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [slope, intercept] : {std::pair{0.0, 7.0}, {nan, nan}, {nan, 0.0}, {1.0, 0.0}}) {
    expect_read(
        write("none.nii", NiftiHead(1, false).scaling(slope, intercept).bytes() + stored(u16)),
        u16);
    EXPECT_EQ(summary.type.name(), "16-bit unsigned integer");
  }
  expect_refused(write("bad.nii", NiftiHead(1, false).scaling(2.0, nan).bytes() + stored(u16)),
                 "times 2 plus nan");
}

TEST(Nifti, OrientationIsNotedAndTheArrayRead) {
  const voxels::IntensityVolume volume = read(case_file("nifti_orientation/shear.nii"));
  for (std::int64_t k = 0; k < volume.planes; ++k)
    for (std::int64_t v = 0; v < 140; ++v)
      ASSERT_EQ(volume.plane(k)[v], 140 * (k + volume.first_plane) + v);
  EXPECT_TRUE(noted("not at right angles"));
  EXPECT_NEAR(summary.voxel_size.um[2], std::hypot(2.0, 0.2), 1e-6);
  const auto with = [](const std::vector<double>& rows) {
    read(write("oriented.nii", NiftiHead(1, false).sform(rows).bytes() + stored(u16)));
    EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.5, 0.25, 2.0}));
  };
  with({0.5, 0, 0, 7, 0, 0.25, 0, 7, 0, 0, 2, 7});
  EXPECT_TRUE(summary.notes.empty());
  with({0.6, 0, 0, 7, 0, 0.3, 0, 7, 0, 0, 2.5, 7});
  EXPECT_TRUE(noted("contradict each other; pixdim is taken"));
  with({-0.5, 0, 0, 7, 0, 0.25, 0, 7, 0, 0, 2, 7});
  EXPECT_TRUE(noted("turns or mirrors the axes"));
  with({0, 0, 0, 7, 0, 0.25, 0, 7, 0, 0, 2, 7});
  EXPECT_TRUE(noted("directions of the axes are none"));
}

// Of four dimensions the first three are those of space.
TEST(MetaImage, OrientationOfATimeSeriesIsNoted) {
  const std::string values = stored(u16) + stored(u16, 1);
  read(write("mirrored.mha",
             "NDims = 4\nDimSize = 5 4 3 2\nElementType = MET_USHORT\nTransformMatrix = "
             "-1 0 0 0  0 -1 0 0  0 0 1 0  0 0 0 1\nElementDataFile = LOCAL\n" +
                 values));
  EXPECT_TRUE(noted("turns or mirrors the axes"));
}

TEST(TimeSeries, AFrameOfEachFormat) {
  const std::string values = stored(u16) + stored(u16, 1);  // the pattern's channels are frames
  const std::vector<std::string> files = {
      write("t.mha",
            "NDims = 4\nDimSize = 5 4 3 2\nElementType = MET_USHORT\n"
            "ElementDataFile = LOCAL\n" +
                values),
      write("t.nrrd",
            "NRRD0004\ntype: ushort\ndimension: 4\nsizes: 5 4 3 2\nkinds: domain domain "
            "domain time\nencoding: raw\nendian: little\n\n" +
                values),
      write("t.nii", NiftiHead(1, false).dims({4, 5, 4, 3, 2}).bytes() + values)};
  for (const std::string& path : files) {
    SCOPED_TRACE(path);
    image::ImageParameters parameters;
    parameters.file = path;
    for (const int frame : {0, 1}) {
      parameters.frame = frame;
      expect_pattern(read_back(parameters, summary), size, pattern_for(u16), frame);
      EXPECT_TRUE(noted("time series of 2 frames"));
    }
    parameters.frame = 2;
    expect_refused(parameters, "has no frame 2 (Image|Frame); admissible: 0 to 1");
  }
}

TEST(Nifti, HeadersThatMustNotBeBelieved) {
  const auto head = [] { return NiftiHead(1, false); };
  const std::string values = stored(u16);
  expect_refused(write("dims.nii", head().dims({9}).bytes() + values), "admissible: 1 to 7");
  expect_refused(write("zero.nii", head().dims({3, 5, 0, 3}).bytes() + values), "at least 1");
  expect_refused(write("negative.nii", head().dims({3, 5, -4, 3}).bytes() + values), "at least 1");
  expect_refused(
      write("huge.nii", NiftiHead(2, false).dims({3, 4e15, 4e15, 4e15}).bytes() + values),
      "more than any file holds");
  expect_refused(write("complex.nii", head().type(32, 64).bytes() + values),
                 "is not supported: it holds complex numbers");
  expect_refused(write("offset.nii", head().put(108, 100, f32).bytes() + values), "from 352 on");
  expect_refused(write("analyze.hdr", head().put(344, 0, i16).bytes() + values),
                 "is not supported: it has the header of Analyze 7.5");
  expect_refused(write("short.nii", head().bytes() + values.substr(1)),
                 "is truncated: its header announces 472 bytes, 471 are there");
  expect_refused(write("alone.hdr", head().two_files().bytes()), "alone.img, which does not exist");
  on_root([] { mkfifo(at("pipe.img").c_str(), 0600); });
  expect_refused(write("pipe.hdr", head().two_files().bytes()), "which is no regular file");
  expect_refused(write("tar.gz", deflated("not an image", 31)), "holds no NIfTI image");
  read(write("bits.nii", head().type(512, 8).bytes() + values));
  EXPECT_TRUE(noted("8 bits a voxel, its type has 16"));
  read(write("longer.nii", head().bytes() + values + "more"));
  EXPECT_TRUE(noted("longer.nii holds more bytes than its header announces"));
  read(write("unsigned.nii", head().type(4, 16).put(124, 60000, f32).bytes() + values));
  EXPECT_TRUE(noted("meant unsigned"));
}

}  // namespace
}  // namespace stroma::test
