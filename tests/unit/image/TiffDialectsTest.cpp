// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What microscopes and ImageJ put into TIFF files beside plain pages.

#include <gtest/gtest.h>
#include <tiff.h>
#include <tiffio.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ReadBack.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/labels/Histogram.hpp"
#include "support/Places.hpp"

namespace stroma::test {
namespace {

const ValueType u8{Kind::unsigned_integer, 1};

image::ImageSummary summary;

image::ImageParameters file(const std::string& name) {
  image::ImageParameters parameters;
  parameters.file = name;
  return parameters;
}

/// A file of tests/data/cases.
image::ImageParameters case_file(const std::string& name) {
  return file(clone_folder().string() + "/tests/data/cases/" + name);
}

std::string number(std::int64_t value, int bytes) {
  return encode(static_cast<double>(value), {Kind::unsigned_integer, bytes}, false);
}

/// An entry of a directory; its values follow the directory when they are longer than 4 bytes.
struct Entry {
  int tag, type;
  std::int64_t count;
  std::string values;
};

Entry entry(int tag, std::int64_t value) { return {tag, TIFF_LONG, 1, number(value, 4)}; }
Entry entry(int tag, const std::string& text) {
  return {tag, TIFF_ASCII, static_cast<std::int64_t>(text.size()) + 1, text + std::string(5, '\0')};
}

/// A TIFF file of one directory: 8 bytes, the values, the directory. More entries than those of a
/// page of one strip in ascending order of their tags.
std::string tiff_of(std::int64_t width, std::int64_t height, int bits, const std::string& values,
                    const std::vector<Entry>& more) {
  std::vector<Entry> entries = {
      entry(256, width), entry(257, height), entry(258, bits),
      entry(259, 1),     entry(262, 1),      entry(273, 8),
      entry(277, 1),     entry(278, height), entry(279, (width * bits + 7) / 8 * height)};
  for (const Entry& one : more) {
    const auto same = std::find_if(entries.begin(), entries.end(),
                                   [&](const Entry& e) { return e.tag == one.tag; });
    if (same != entries.end()) {
      *same = one;
    } else {
      entries.insert(std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& e) { return e.tag > one.tag; }),
                     one);
    }
  }
  const auto start = static_cast<std::int64_t>(8 + values.size());
  const auto count = static_cast<std::int64_t>(entries.size());
  std::string directory = number(count, 2), behind;
  for (const Entry& e : entries) {
    directory += number(e.tag, 2) + number(e.type, 2) + number(e.count, 4);
    if (e.values.size() <= 4) {
      directory += e.values;
    } else {
      directory += number(start + 2 + 12 * count + 4 + static_cast<std::int64_t>(behind.size()), 4);
      behind += e.values;
    }
  }
  return "II" + number(42, 2) + number(start, 4) + values + directory + number(0, 4) + behind;
}

voxels::IntensityVolume read_bytes_as(const std::string& name, const std::string& bytes) {
  on_root([&] { write_bytes(folder() + "/" + name, bytes); });
  return read_back(file(name), summary);
}

image::Statistics statistics_of(const voxels::IntensityVolume& volume) {
  return image::statistics(base::Communicator::world(), volume);
}

double fraction_above(const voxels::IntensityVolume& volume, double threshold) {
  return image::fraction_above(base::Communicator::world(), volume, threshold);
}

/// A pattern of planes that follow one another as pages: (z, c, t) is page z of a stack.
Pattern frame_of(const Pattern& pages, std::int64_t z_step, std::int64_t c_step,
                 std::int64_t offset) {
  return [=](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t c) {
    return pages(x, y, offset + z * z_step + c * c_step, 0);
  };
}

TEST(TiffDialects, FramesOfAnImageJHyperstack) {
  TiffOptions options;
  options.size = {5, 4, 24};  // 2 channels, 3 slices, 4 frames
  options.description = "ImageJ=1.53t\nimages=24\nchannels=2\nslices=3\nframes=4\n";
  on_root([&] { write_tiff_file(folder() + "/frames.tif", options, pattern_for(u8)); });
  image::ImageParameters parameters = file("frames.tif");
  for (const int frame : {0, 2, 3}) {
    for (const int channel : {0, 1}) {
      parameters.frame = frame;
      parameters.channel = channel;
      expect_pattern(read_back(parameters, summary), {5, 4, 3},
                     frame_of(pattern_for(u8), 2, 1, 6 * frame), channel);
    }
  }
  EXPECT_EQ(summary.frames, 4);
  EXPECT_TRUE(has_note(summary, "time series of 4 frames; frame 3 is read"));
  parameters.frame = 4;
  expect_refused(parameters, "has no frame 4 (Image|Frame); admissible: 0 to 3");
}

TEST(TiffDialects, FramesOfAnImageJStackInOnePiece) {
  on_root([&] {
    std::string bytes = tiff_head(5, 4, 400, "ImageJ=1.53t\nimages=6\nslices=3\nframes=2\n", true);
    write_bytes(folder() + "/one_piece.tif", bytes + encode({5, 4, 6}, u8, true, pattern_for(u8)));
  });
  image::ImageParameters parameters = file("one_piece.tif");
  for (const int frame : {0, 1}) {
    parameters.frame = frame;
    expect_pattern(read_back(parameters, summary), {5, 4, 3},
                   frame_of(pattern_for(u8), 1, 0, 3 * frame));
  }
}

TEST(TiffDialects, FramesOfAnOmeTiffInEveryOrder) {
  const std::int64_t sizes[3] = {3, 2, 4};  // z, c, t
  for (const std::string order : {"XYZCT", "XYZTC", "XYCZT", "XYCTZ", "XYTZC", "XYTCZ"}) {
    SCOPED_TRACE(order);
    std::int64_t step[3], next = 1;  // of z, c and t from page to page
    for (const char axis : order.substr(2)) {
      const std::size_t a = std::string("ZCT").find(axis);
      step[a] = next;
      next *= sizes[a];
    }
    TiffOptions options;
    options.size = {5, 4, 24};
    options.description = "<OME><Image><Pixels DimensionOrder=\"" + order +
                          "\" SizeX=\"5\" SizeY=\"4\" SizeZ=\"3\" SizeC=\"2\" SizeT=\"4\">"
                          "<TiffData/></Pixels></Image></OME>";
    on_root([&] { write_tiff_file(folder() + "/frames.ome.tif", options, pattern_for(u8)); });
    image::ImageParameters parameters = file("frames.ome.tif");
    parameters.channel = 1;
    for (const int frame : {0, 3}) {
      parameters.frame = frame;
      expect_pattern(read_back(parameters, summary), {5, 4, 3},
                     frame_of(pattern_for(u8), step[0], step[1], frame * step[2]), 1);
    }
    EXPECT_EQ(summary.frames, 4);
    base::Communicator::world().barrier();
  }
}

TEST(TiffDialects, FramesOfTheCase) {
  image::ImageParameters parameters = case_file("time_series/tz.ome.tif");
  read_back(parameters, summary);
  EXPECT_TRUE(has_note(summary, "time series of 2 frames; frame 0 is read"));
  EXPECT_EQ(summary.size, (Size{14, 10, 6}));
  parameters.frame = 1;
  read_back(parameters, summary);
  EXPECT_TRUE(has_note(summary, "frame 1 is read"));
  parameters.frame = 2;
  expect_refused(parameters, "has no frame 2 (Image|Frame); admissible: 0 to 1");
}

TEST(TiffDialects, PlanesOfATileBehindOneDirectory) {
  const voxels::IntensityVolume volume =
      read_back(case_file("tiff_planes_in_one_ifd/volumetric.tif"), summary);
  expect_pattern(volume, {16, 16, 16}, [](auto x, auto y, auto z, auto) {
    return static_cast<double>((256 * z + 16 * y + x) % 251);
  });
  // The same, compressed, in a tile that reaches beyond the image.
  const std::string tile = encode({16, 16, 4}, u8, false, pattern_for(u8));
  uLongf length = compressBound(tile.size());
  std::string packed(length, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &length,
           reinterpret_cast<const Bytef*>(tile.data()), tile.size());
  const std::string bytes =
      tiff_of(9, 7, 8, packed.substr(0, length),
              {entry(259, COMPRESSION_ADOBE_DEFLATE), entry(322, 16), entry(323, 16), entry(324, 8),
               entry(325, static_cast<std::int64_t>(length)), entry(32997, 3), entry(32998, 4)});
  expect_pattern(read_bytes_as("tile.tif", bytes), {9, 7, 3}, pattern_for(u8));
}

TEST(TiffDialects, PlanesOfAStripBehindOneDirectory) {
  const std::string values = encode({5, 4, 3}, u8, false, pattern_for(u8));
  // By ImageDepth; by the shape that tifffile describes.
  for (const Entry& depth :
       {entry(32997, 3), entry(270, "{\"shape\": [3, 4, 5], \"truncated\": true}"),
        entry(270, "{\"truncate\": true, \"shape\": [3, 4, 5], \"axes\": \"ZYX\"}")})
    expect_pattern(read_bytes_as("depth.tif", tiff_of(5, 4, 8, values, {depth})), {5, 4, 3},
                   pattern_for(u8));
}

TEST(TiffDialects, BitsInReverseBehindOneDirectoryAreRefused) {
  const std::string values = encode({5, 4, 3}, u8, false, pattern_for(u8));
  const Entry shape = entry(270, "{\"shape\": [3, 4, 5]}");
  expect_refused("reversed.tif", tiff_of(5, 4, 8, values, {entry(266, 2), shape}), "FillOrder 2");
}

TEST(TiffDialects, AnotherOrientationIsSaid) {
  const std::string values = encode({5, 4, 1}, u8, false, pattern_for(u8));
  expect_pattern(
      read_bytes_as("turned.tif", tiff_of(5, 4, 8, values, {{274, TIFF_SHORT, 1, number(4, 4)}})),
      {5, 4, 1}, pattern_for(u8));
  EXPECT_TRUE(has_note(summary, "its Orientation tag, 4, turns or mirrors the picture"));
}

TEST(TiffDialects, AxesThatTifffileStates) {
  const struct {
    std::string axes, shape;
    Size size;
    std::int64_t z_step, c_step, t_step;
    int frame, channel;
  } cases[] = {{"TZYX", "3, 4, 4, 5", {5, 4, 4}, 1, 0, 4, 2, 0},
               {"CYX", "12, 4, 5", {5, 4, 1}, 0, 1, 0, 0, 7},
               {"CZYX", "2, 6, 4, 5", {5, 4, 6}, 1, 6, 0, 0, 1},
               {"TZCYX", "2, 3, 2, 4, 5", {5, 4, 3}, 2, 1, 6, 1, 1}};
  for (const auto& one : cases) {
    TiffOptions options;
    options.size = {5, 4, 12};
    options.description = "{\"axes\": \"" + one.axes + "\", \"shape\": [" + one.shape + "]}";
    on_root([&] { write_tiff_file(folder() + "/shaped.tif", options, pattern_for(u8)); });
    image::ImageParameters parameters = file("shaped.tif");
    parameters.frame = one.frame;
    parameters.channel = one.channel;
    expect_pattern(read_back(parameters, summary), one.size,
                   frame_of(pattern_for(u8), one.z_step, one.c_step, one.frame * one.t_step),
                   one.channel);
  }
}

std::string ome_of(const std::string& sizes, const std::string& planes) {
  return "<?xml version=\"1.0\"?><OME><Image><Pixels DimensionOrder=\"XYZCT\" SizeX=\"5\" SizeY=\"4\" " +
         sizes + " SizeC=\"1\" SizeT=\"1\">" + planes + "</Pixels></Image></OME>";
}

// OME counts all directories of the file, tifffile's and others' stacks the full ones.
TEST(TiffDialects, PagesThatCallThemselvesReduced) {
  TiffOptions options;
  options.subfile_types = {0, 1, 0};
  on_root([&] { write_tiff_file(folder() + "/reduced.tif", options, pattern_for(u8)); });
  expect_pattern(read_back(file("reduced.tif"), summary), {5, 4, 2},
                 frame_of(pattern_for(u8), 2, 0, 0));
  EXPECT_TRUE(has_note(summary, "1 pages as large as the first call themselves reduced images"));
  options.description =
      ome_of("SizeZ=\"2\"", "<TiffData IFD=\"0\" FirstZ=\"0\"/><TiffData IFD=\"2\" FirstZ=\"1\"/>");
  on_root([&] { write_tiff_file(folder() + "/reduced.ome.tif", options, pattern_for(u8)); });
  expect_pattern(read_back(file("reduced.ome.tif"), summary), {5, 4, 2},
                 frame_of(pattern_for(u8), 2, 0, 0));
  options.description.clear();
  options.subfile_types = {1, 1, 1};
  on_root([&] { write_tiff_file(folder() + "/all.tif", options, pattern_for(u8)); });
  expect_pattern(read_back(file("all.tif"), summary), {5, 4, 3}, pattern_for(u8));
  EXPECT_TRUE(has_note(summary, "all its pages call themselves reduced images or masks"));
}

TEST(TiffDialects, LengthsThatAreNoNumbersAreNotUsed) {
  TiffOptions options;
  options.description = ome_of("SizeZ=\"3\" PhysicalSizeX=\"1,5\" PhysicalSizeZ=\"0.5 mm\"", "");
  on_root([&] { write_tiff_file(folder() + "/comma.ome.tif", options, pattern_for(u8)); });
  read_back(file("comma.ome.tif"), summary);
  EXPECT_FALSE(summary.voxel_size.known(0) || summary.voxel_size.known(2));
  EXPECT_TRUE(has_note(summary, "PhysicalSizeX, \"1,5\", is no number; not used"));
  options.description =
      "ImageJ=1.53t\nimages=3\nslices=3\nunit=um\nspacing=1,5\ncf=0\nc0=1,5\nc1=2\n";
  on_root([&] { write_tiff_file(folder() + "/comma.tif", options, pattern_for(u8)); });
  expect_pattern(read_back(file("comma.tif"), summary), {5, 4, 3}, pattern_for(u8));
  EXPECT_FALSE(summary.voxel_size.known(2));
  EXPECT_TRUE(has_note(summary, "ImageJ's spacing, \"1,5\", is no number; not used"));
  EXPECT_TRUE(has_note(summary, "says nothing; not used"));
  options.description = "ImageJ=1.53t\nimages=3\nslices=3\nunit=um\nspacing=0\n";
  on_root([&] { write_tiff_file(folder() + "/flat.tif", options, pattern_for(u8)); });
  read_back(file("flat.tif"), summary);
  EXPECT_FALSE(summary.voxel_size.known(2));
  EXPECT_TRUE(has_note(summary, "ImageJ's spacing, \"0\", is no length above 0; not used"));
  options.description = "ImageJ=1.53t\nimages=3\nslices=3\nunit=um\nyunit=furlong\n";
  on_root([&] { write_tiff_file(folder() + "/furlong.tif", options, pattern_for(u8)); });
  read_back(file("furlong.tif"), summary);
  EXPECT_FALSE(summary.voxel_size.known(1));
  EXPECT_TRUE(has_note(summary, "unit along y, \"furlong\", is no unit of length known here"));
}

TEST(TiffDialects, MetaMorphStack) {
  // Of the settings, the calibration: 0.25 and 0.5 um; the planes are 1.5 um apart.
  const std::string values = encode({5, 4, 3}, u8, false, pattern_for(u8));
  const auto at = static_cast<std::int64_t>(8 + values.size());
  const std::string behind = number(1, 4) + number(4, 4) + number(1, 4) + number(2, 4) +
                             number(3, 4) + std::string("um\0\0", 4);
  const std::string settings = number(4, 4) + number(at, 4) + number(5, 4) + number(at + 8, 4) +
                               number(6, 4) + number(at + 16, 4);
  std::string planes;
  for (int plane = 0; plane < 3; ++plane)
    planes += number(plane == 0 ? 0 : 3, 4) + number(2, 4) + std::string(16, '\0');
  const std::string bytes =
      tiff_of(5, 4, 8, values + behind,
              {{33628, TIFF_LONG, 3, settings}, {33629, TIFF_RATIONAL, 3, planes}});
  expect_pattern(read_bytes_as("stack.stk", bytes), {5, 4, 3}, pattern_for(u8));
  EXPECT_EQ(summary.format, "TIFF, MetaMorph stack");
  EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.25, 0.5, 1.5}));

  for (std::size_t plane = 1; plane < 3; ++plane)  // a stage that moves down: -3 / 2
    planes.replace(24 * plane, 4, number(4294967293, 4));
  read_bytes_as("down.stk", tiff_of(5, 4, 8, values, {{33629, TIFF_RATIONAL, 3, planes}}));
  EXPECT_EQ(summary.voxel_size.um[2], 1.5);

  expect_refused("many.stk", tiff_of(5, 4, 8, values, {{33629, TIFF_RATIONAL, 1000000, planes}}),
                 "cannot hold them");
  expect_refused("packed.stk",
                 tiff_of(5, 4, 8, values, {entry(259, 5), {33629, TIFF_RATIONAL, 3, planes}}),
                 "its MetaMorph tags speak of 3 images");
}

TEST(TiffDialects, ZeissStackOfFrames) {
  // One page, told to be two frames; one page, told to be itself.
  const auto zeiss = [](std::int64_t frames) {
    std::string info = number(0x0400494C, 4) + number(100, 4) + number(5, 4) + number(4, 4) +
                       number(1, 4) + number(1, 4) + number(frames, 4) + std::string(12, '\0');
    for (const double size : {0.5e-6, 0.25e-6, 2e-6})
      info += encode(size, {Kind::floating, 8}, false);
    return Entry{34412, TIFF_BYTE, 100, info + std::string(36, '\0')};
  };
  const std::string values = encode({5, 4, 1}, u8, false, pattern_for(u8));
  expect_pattern(read_bytes_as("one.lsm", tiff_of(5, 4, 8, values, {zeiss(1)})), {5, 4, 1},
                 pattern_for(u8));
  EXPECT_NEAR(summary.voxel_size.um[1], 0.25, 1e-12);
  EXPECT_NEAR(summary.voxel_size.um[2], 2.0, 1e-12);
  expect_refused("two.lsm", tiff_of(5, 4, 8, values, {zeiss(2)}),
                 "1 planes in 2 frames, but it holds 1 pages");
}

TEST(TiffDialects, BytesBehindTheOnlyPageAreSaid) {
  const std::string values = encode({5, 4, 1}, u8, false, pattern_for(u8));
  read_bytes_as("behind.tif", tiff_of(5, 4, 8, values + std::string(100000, 'v'), {}));
  EXPECT_TRUE(has_note(summary, "bytes follow the values of the only page; they are not read"));
}

TEST(TiffDialects, ImageJCalibratesValues) {
  const voxels::IntensityVolume signed_values =
      read_back(case_file("imagej_calibration/signed.tif"), summary);
  const image::Statistics statistics = statistics_of(signed_values);
  EXPECT_EQ(statistics.min, -1000.0);
  EXPECT_EQ(statistics.max, 300.0);
  EXPECT_EQ(fraction_above(signed_values, -200.0), 0.25);
  EXPECT_EQ(summary.type.name(), "16-bit signed integer");
  EXPECT_TRUE(has_note(summary, "calibration of values is used: -32768 + 1 x stored"));

  TiffOptions options;
  options.channels = 2;
  options.description =
      "ImageJ=1.53t\nimages=6\nchannels=2\nslices=3\ncf=0\nc0=-10.5\nc1=0.25\nvunit=Gray Value\n";
  image::ImageParameters second = file("channels.tif");
  second.channel = 1;
  const auto calibrated = [&](auto x, auto y, auto z, auto c) {
    return -10.5 + 0.25 * pattern_for(u8)(x, y, z, c);
  };
  on_root([&] { write_tiff_file(folder() + "/channels.tif", options, pattern_for(u8)); });
  expect_pattern(read_back(second, summary), {5, 4, 3}, calibrated, 1);
  EXPECT_EQ(summary.type.name(), "64-bit float");

  options.description = "ImageJ=1.53t\nimages=6\nchannels=2\nslices=3\ncf=7\nc0=1\nc1=2\nc2=3\n";
  on_root([&] { write_tiff_file(folder() + "/channels.tif", options, pattern_for(u8)); });
  expect_pattern(read_back(second, summary), {5, 4, 3}, pattern_for(u8), 1);
  EXPECT_TRUE(has_note(summary, "is no straight line (cf=7)"));
}

TEST(TiffDialects, WhatLooksOtherwiseIsSaid) {
  for (const auto& [name, words] :
       {std::make_pair("photometric/miniswhite.tif", "0 is white in this file (MinIsWhite)"),
        std::make_pair("photometric/palette.tif", "indices into the file's table of colours")}) {
    const voxels::IntensityVolume volume = read_back(case_file(name), summary);
    EXPECT_EQ(fraction_above(volume, 127.0), 0.75);  // as stored
    EXPECT_TRUE(has_note(summary, words)) << name;
  }
}

TEST(TiffDialects, CountsThatCannotBe) {
  expect_refused(case_file("imagej_counts/div0.tif"), "channels=4294967296; admissible: 1 to 10^9");
  expect_refused(case_file("imagej_counts/ov.tif"), "slices=2305843009213693953");
  expect_refused(case_file("imagej_counts/ome4.tif"), "its OME-XML says SizeZ=\"-8\"");
  TiffOptions options;
  const auto refused = [&](const std::string& description, const std::string& words) {
    options.description = description;
    on_root([&] { write_tiff_file(folder() + "/counts.tif", options, pattern_for(u8)); });
    expect_refused(file("counts.tif"), words);
  };
  refused("ImageJ=1.53t\nimages=3\nslices=0\n", "slices=0");
  refused("ImageJ=1.53t\nimages=3\nframes=\n", "frames=");
  refused("ImageJ=1.53t\nimages=3\nchannels=2\n", "2 channels x 1 slices x 1 frames");
  refused("ImageJ=1.53t\nimages=1000000000\nchannels=1000000000\nframes=1000000000\n",
          "1000000000 images, but of");
  const auto ome = [](const std::string& attributes, const std::string& data) {
    return "<OME><Image><Pixels SizeX=\"5\" SizeY=\"4\" " + attributes + ">" + data +
           "</Pixels></Image></OME>";
  };
  refused(ome("SizeZ=\"3\" SizeC=\"1000000000000\"", ""), "SizeC=\"1000000000000\"");
  refused(ome("SizeZ=\"1000000000\" SizeC=\"1000000000\"", ""), "but it holds 3 pages");
  refused(ome("SizeZ=\"3\"", "<TiffData IFD=\"-1\"/>"), "IFD=\"-1\"");
  refused(ome("SizeZ=\"3\"", "<TiffData IFD=\"1\"/>"), "names no page of this file for plane 1");
  refused(ome("SizeZ=\"3\" DimensionOrder=\"XYZZT\"", ""), "DimensionOrder=\"XYZZT\"");
  options.description = ome("SizeZ=\"2\"", "");
  on_root([&] { write_tiff_file(folder() + "/counts.tif", options, pattern_for(u8)); });
  read_back(file("counts.tif"), summary);
  EXPECT_TRUE(has_note(summary, "1 of the file's 3 planes are not in its description"));
}

TEST(TiffDialects, TilesFarLargerThanTheImage) {
  expect_refused(case_file("tiff_tiles/tile_4g.tif"), "cut into tiles of 65536 x 65536");
  const std::string values = encode({5, 4, 1}, u8, false, pattern_for(u8));
  expect_refused("deep.tif",
                 tiff_of(5, 4, 8, values,
                         {entry(322, 16), entry(323, 16), entry(324, 8), entry(325, 20),
                          entry(32998, 1000000000)}),
                 "16 x 16 x 1000000000");
  expect_refused("samples.tif", tiff_of(5, 4, 8, values, {entry(277, 60000)}), "cannot hold them");
  expect_pattern(read_bytes_as("strip.tif", tiff_of(5, 4, 8, values, {entry(278, 4294967295)})),
                 {5, 4, 1}, pattern_for(u8));
}

TEST(TiffDialects, WellCompressedMasks) {
  if (TIFFIsCODECConfigured(COMPRESSION_ZSTD)) {
    const voxels::IntensityVolume mask =
        read_back(case_file("compressed_well/mask_zstd.tif"), summary);
    EXPECT_EQ(std::llround(fraction_above(mask, 127.0) * static_cast<double>(mask.voxels())), 1600);
  }
  if (!TIFFIsCODECConfigured(COMPRESSION_LZMA)) GTEST_SKIP() << "no LZMA in the TIFF library";
  on_root([] {
    TIFF* tiff = TIFFOpen((folder() + "/lzma.tif").c_str(), "w");
    for (const auto& [tag, value] :
         {std::make_pair(TIFFTAG_IMAGEWIDTH, 4096), std::make_pair(TIFFTAG_IMAGELENGTH, 4096),
          std::make_pair(TIFFTAG_BITSPERSAMPLE, 8), std::make_pair(TIFFTAG_SAMPLESPERPIXEL, 1),
          std::make_pair(TIFFTAG_ROWSPERSTRIP, 4096), std::make_pair(TIFFTAG_PHOTOMETRIC, 1),
          std::make_pair(TIFFTAG_COMPRESSION, COMPRESSION_LZMA)})
      TIFFSetField(tiff, static_cast<std::uint32_t>(tag), value);
    std::string zeros(4096 * 4096, '\0');
    zeros[5] = 1;
    TIFFWriteEncodedStrip(tiff, 0, zeros.data(), static_cast<tmsize_t>(zeros.size()));
    TIFFClose(tiff);
  });
  EXPECT_LT(std::filesystem::file_size(folder() + "/lzma.tif"), 4096u);  // gains more than 4096
  EXPECT_EQ(statistics_of(read_back(file("lzma.tif"), summary)).max, 1.0);
}

TEST(TiffDialects, AFileThatShrinksIsAnError) {
  on_root([] {
    TiffOptions options;
    options.size = {64, 64, 20};
    const std::string path = folder() + "/shrinks.tif";
    write_tiff_file(path, options, pattern_for(u8));
    image::ImageRequest request;
    request.path = path;
    const auto source = image::open_tiff(request);
    std::filesystem::resize_file(path, 5000);
    std::vector<double> values(64 * 64 * 20);
    EXPECT_THROW(source->read({{0, 0, 0}, {64, 64, 20}}, values.data()), base::InputError);
  });
}

TEST(TiffDialects, MasksOfEveryWidth) {
  const auto mask = [](auto x, auto y, auto z, auto) {
    return x >= 4 && x < 9 && y >= 3 && y < 7 && z >= 2 && z < 4 ? 1.0 : 0.0;
  };
  for (const char* name : {"mask_types/int64.tif", "mask_types/float16.tif"}) {
    SCOPED_TRACE(name);
    expect_pattern(read_back(case_file(name), summary), {14, 10, 6}, mask);
  }
  EXPECT_EQ(summary.type.name(), "16-bit float");
  // Halves: 1, -2, the largest, the smallest, infinity.
  const std::string halves = number(0x3C00, 2) + number(0xC000, 2) + number(0x7BFF, 2) +
                             number(0x0001, 2) + number(0x7C00, 2);
  const double expected[] = {1.0, -2.0, 65504.0, 5.9604644775390625e-8, HUGE_VAL};
  expect_pattern(read_bytes_as("halves.tif", tiff_of(5, 1, 16, halves, {entry(339, 3)})), {5, 1, 1},
                 [&](auto x, auto, auto, auto) { return expected[x]; });
  // 10 x 2 pixels of one bit, rows filled up to bytes; 3 x 1 of twelve.
  const std::string bits("\xAA\x80\x55\x40", 4);
  expect_pattern(read_bytes_as("bits.tif", tiff_of(10, 2, 1, bits, {})), {10, 2, 1},
                 [](auto x, auto y, auto, auto) { return (x + y) % 2 == 0 ? 1.0 : 0.0; });
  EXPECT_TRUE(has_note(summary, "packed to 1 bits"));
  const double twelve[] = {0x123, 0x456, 0xFFF};
  expect_pattern(
      read_bytes_as("twelve.tif", tiff_of(3, 1, 12, "\x12\x34\x56\xFF\xF0", {entry(258, 12)})),
      {3, 1, 1}, [&](auto x, auto, auto, auto) { return twelve[x]; });
  expect_refused("wide.tif", tiff_of(3, 1, 24, "123456789", {}), "integers of 24 bits");
}

TEST(TiffDialects, ARenamedOmeTiff) {
  const double mean = statistics_of(read_back(case_file("ome_renamed/orig.ome.tif"), summary)).mean;
  EXPECT_FALSE(has_note(summary, "renamed"));
  EXPECT_EQ(statistics_of(read_back(case_file("ome_renamed/renamed.ome.tif"), summary)).mean, mean);
  EXPECT_TRUE(has_note(summary, "calls it orig.ome.tif; it was renamed"));
  // Without identifiers: its only name must be its own, but one of two files is not.
  const auto ome = [](const std::string& second) {
    return "<OME><Image><Pixels SizeX=\"5\" SizeY=\"4\" SizeZ=\"3\"><TiffData IFD=\"0\" "
           "PlaneCount=\"2\"><UUID FileName=\"a.tif\"/></TiffData><TiffData IFD=\"2\" "
           "FirstZ=\"2\"><UUID FileName=\"" +
           second + "\"/></TiffData></Pixels></Image></OME>";
  };
  TiffOptions options;
  options.description = ome("a.tif");
  on_root([&] { write_tiff_file(folder() + "/b.tif", options, pattern_for(u8)); });
  expect_pattern(read_back(file("b.tif"), summary), {5, 4, 3}, pattern_for(u8));
  EXPECT_TRUE(has_note(summary, "renamed"));
  options.description = ome("c.tif");
  on_root([&] { write_tiff_file(folder() + "/b.tif", options, pattern_for(u8)); });
  expect_refused(file("b.tif"), "part of a set of files");
}

// A channel a file, as Bio-Formats and MicroManager split sets: each has its channel, and no other.
TEST(TiffDialects, AChannelOfAnOmeSet) {
  TiffOptions options;
  options.description =
      "<OME UUID=\"urn:1\"><Image><Pixels DimensionOrder=\"XYZCT\" SizeX=\"5\" SizeY=\"4\" SizeZ=\"3\" SizeC=\"2\" "
      "PhysicalSizeX=\"0.25\"><TiffData IFD=\"0\" PlaneCount=\"3\"><UUID FileName=\"c0.tif\">urn:0"
      "</UUID></TiffData><TiffData FirstC=\"1\" IFD=\"0\" PlaneCount=\"3\"><UUID "
      "FileName=\"c1.tif\">urn:1</UUID></TiffData></Pixels></Image></OME>";
  on_root([&] { write_tiff_file(folder() + "/c1.tif", options, pattern_for(u8)); });
  image::ImageParameters parameters = file("c1.tif");
  expect_refused(parameters, "for plane 0 of channel 0 in frame 0 (truncated, or part of a set");
  parameters.channel = 1;
  expect_pattern(read_back(parameters, summary), {5, 4, 3}, pattern_for(u8));
  EXPECT_EQ(summary.voxel_size.um[0], 0.25);
  EXPECT_EQ(summary.channels, 2);
  parameters.channel = 2;
  expect_refused(parameters, "admissible");
}

TEST(TiffDialects, BrokenOmeXmlIsAPlainStack) {
  read_back(case_file("ome_broken_xml/lat1.ome.tif"), summary);
  EXPECT_EQ(summary.size, (Size{14, 10, 6}));
  EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.5, 0.5, 2.0}));
  EXPECT_TRUE(has_note(summary, "read as Latin-1"));
  read_back(case_file("ome_broken_xml/series.ome.tif"), summary);
  EXPECT_EQ(summary.size, (Size{14, 10, 6}));
  EXPECT_TRUE(has_note(summary, "the file holds 2 images (series); the first is read"));
  TiffOptions options;
  for (const std::string xml : {"<OME><Image><Pixels SizeX=\"5\"", "<OME/>"}) {
    options.description = xml;
    on_root([&] { write_tiff_file(folder() + "/broken.ome.tif", options, pattern_for(u8)); });
    expect_pattern(read_back(file("broken.ome.tif"), summary), {5, 4, 3}, pattern_for(u8));
    EXPECT_TRUE(has_note(summary, "read as a plain stack")) << xml;
  }
  options.description =
      "<OME><BinaryOnly MetadataFile=\"set.companion.ome\" UUID=\"urn:0\"/></OME>";
  on_root([&] { write_tiff_file(folder() + "/binary.ome.tif", options, pattern_for(u8)); });
  expect_pattern(read_back(file("binary.ome.tif"), summary), {5, 4, 3}, pattern_for(u8));
  EXPECT_TRUE(has_note(summary, "its OME-XML leaves the description to set.companion.ome"));
}

TEST(TiffDialects, LengthsThatAreMeant) {
  read_back(case_file("imagej_unit_depth/z1.tif"), summary);
  EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.5, 0.5, 1.0}));
  EXPECT_TRUE(has_note(summary, "no spacing of the slices, which means 1 um"));
  read_back(case_file("pic_axis_without_unit/nu.pic"), summary);
  EXPECT_EQ(summary.voxel_size.um[0], 0.5);
  EXPECT_EQ(summary.voxel_size.um[1], 0.25);
  EXPECT_TRUE(summary.voxel_size.complete());
  EXPECT_TRUE(has_note(summary, "without a unit: taken as um"));
  // Another unit than a length is none.
  on_root([] {
    write_pic(folder() + "/time.pic", {5, 4, 3}, 1, pattern_for(u8),
              {"AXIS_2 257 0.0 0.5 um", "AXIS_4 257 0.0 2.0 seconds"});
  });
  read_back(file("time.pic"), summary);
  EXPECT_FALSE(summary.voxel_size.known(2));
  EXPECT_TRUE(has_note(summary, "gives 2 seconds, which is no unit of length known here"));
}

}  // namespace
}  // namespace stroma::test
