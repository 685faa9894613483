// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Every format that Stroma reads, written here and read back value by value.

#include <gtest/gtest.h>
#include <tiff.h>
#include <zlib.h>

#include <fstream>

#include "ReadBack.hpp"
#include "stroma/image/formats/WriteTiff.hpp"

namespace stroma::test {
namespace {

const std::vector<ValueType> integer_types = {
    {Kind::unsigned_integer, 1}, {Kind::signed_integer, 1},   {Kind::unsigned_integer, 2},
    {Kind::signed_integer, 2},   {Kind::unsigned_integer, 4}, {Kind::signed_integer, 4}};

image::ImageSummary summary;

voxels::IntensityVolume read(const std::string& path, int channel = 0,
                             const std::string& dataset = "",
                             std::optional<std::array<int, 6>> region = {}) {
  image::ImageParameters parameters;
  parameters.file = path;
  parameters.channel = channel;
  if (!dataset.empty()) parameters.dataset = dataset;
  parameters.region = region;
  return read_back(parameters, summary);
}

TEST(Formats, TiffOfEveryTypeInBothByteOrders) {
  std::vector<ValueType> types = integer_types;
  types.push_back({Kind::floating, 4});
  types.push_back({Kind::floating, 8});
  for (const ValueType& type : types) {
    for (const bool big_endian : {false, true}) {
      const std::string path = folder() + "/types.tif";
      TiffOptions options;
      options.type = type;
      options.big_endian = big_endian;
      on_root([&] { write_tiff_file(path, options, pattern_for(type)); });
      SCOPED_TRACE(type.name() + (big_endian ? ", big-endian" : ", little-endian"));
      expect_pattern(read(path), options.size, pattern_for(type));
      EXPECT_EQ(summary.type.name(), type.name());
      base::Communicator::world().barrier();
    }
  }
}

TEST(Formats, TiffCompressedTiledBig) {
  const Pattern pattern = pattern_for({Kind::unsigned_integer, 2});
  for (const int compression :
       {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
    for (const bool tiled : {false, true}) {
      const std::string path = folder() + "/compressed.tif";
      TiffOptions options;
      options.size = {37, 21, 4};
      options.type = {Kind::unsigned_integer, 2};
      options.compression = compression;
      options.tiled = tiled;
      options.big_tiff = tiled;
      on_root([&] { write_tiff_file(path, options, pattern); });
      SCOPED_TRACE("compression " + std::to_string(compression) + (tiled ? ", tiles" : ", strips"));
      expect_pattern(read(path), options.size, pattern);
      expect_pattern(read(path, 0, "", {{18, 5, 1, 17, 14, 2}}), {17, 14, 2}, pattern, 0,
                     {18, 5, 1});
      base::Communicator::world().barrier();
    }
  }
}

TEST(Formats, ImageJHyperstackAndStackInOnePiece) {
  const ValueType type{Kind::unsigned_integer, 2};
  const Pattern pattern = pattern_for(type);
  TiffOptions options;
  options.type = type;
  options.channels = 2;
  options.big_endian = true;
  options.description =
      "ImageJ=1.53t\nimages=6\nchannels=2\nslices=3\nhyperstack=true\nunit=micron\nspacing=2.0\n";
  const std::string path = folder() + "/hyperstack.tif";
  on_root([&] { write_tiff_file(path, options, pattern); });
  for (const int channel : {0, 1})
    expect_pattern(read(path, channel), options.size, pattern, channel);
  EXPECT_EQ(summary.channels, 2);
  EXPECT_EQ(summary.format, "TIFF, ImageJ hyperstack");

  // One directory, behind it all planes: how ImageJ writes stacks of more than 4 GB.
  const ValueType u8{Kind::unsigned_integer, 1};
  const Pattern bytes = pattern_for(u8);
  const std::string big = folder() + "/one_piece.tif";
  on_root([&] {
    std::string file = tiff_head(5, 4, 400, "ImageJ=1.53t\nimages=6\nchannels=2\nslices=3\n", true);
    for (std::int64_t z = 0; z < 3; ++z) {
      for (std::int64_t c = 0; c < 2; ++c) {
        file += encode({5, 4, 1}, u8, true,
                       [&](auto x, auto y, auto, auto) { return bytes(x, y, z, c); });
      }
    }
    write_bytes(big, file);
  });
  for (const int channel : {0, 1}) expect_pattern(read(big, channel), {5, 4, 3}, bytes, channel);
}

TEST(Formats, SamplesOfAPixelAreChannels) {
  const ValueType type{Kind::unsigned_integer, 1};
  for (const bool apart : {false, true}) {
    TiffOptions options;
    options.type = type;
    options.samples = 3;
    options.samples_apart = apart;
    const std::string path = folder() + (apart ? "/planar.tif" : "/rgb.tif");
    on_root([&] { write_tiff_file(path, options, pattern_for(type)); });
    for (const int channel : {0, 1, 2})
      expect_pattern(read(path, channel), options.size, pattern_for(type), channel);
    EXPECT_EQ(summary.channels, 3);
  }
}

TEST(Formats, OmeTiffInBothOrders) {
  const ValueType type{Kind::unsigned_integer, 1};
  for (const bool z_fastest : {false, true}) {
    TiffOptions options;
    options.type = type;
    options.channels = 2;
    options.z_fastest = z_fastest;
    options.description = std::string(
                              "<?xml version=\"1.0\"?><OME "
                              "xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\"><Image "
                              "ID=\"Image:0\"><Pixels ID=\"Pixels:0\" DimensionOrder=\"") +
                          (z_fastest ? "XYZCT" : "XYCZT") +
                          "\" Type=\"uint8\" SizeX=\"5\" SizeY=\"4\" SizeZ=\"3\" SizeC=\"2\" "
                          "SizeT=\"1\" PhysicalSizeX=\"500\" "
                          "PhysicalSizeXUnit=\"nm\" PhysicalSizeY=\"0.5\" PhysicalSizeZ=\"0.002\" "
                          "PhysicalSizeZUnit=\"mm\"><TiffData/>"
                          "</Pixels></Image></OME>";
    const std::string path = folder() + "/ome.ome.tif";
    on_root([&] { write_tiff_file(path, options, pattern_for(type)); });
    for (const int channel : {0, 1})
      expect_pattern(read(path, channel), options.size, pattern_for(type), channel);
    EXPECT_EQ(summary.format, "OME-TIFF");
    EXPECT_DOUBLE_EQ(summary.voxel_size.um[0], 0.5);
    EXPECT_DOUBLE_EQ(summary.voxel_size.um[1], 0.5);
    EXPECT_DOUBLE_EQ(summary.voxel_size.um[2], 2.0);
    EXPECT_EQ(summary.voxel_size.source(), "OME attributes");
    base::Communicator::world().barrier();
  }
}

TEST(Formats, BioRadPicWithNotes) {
  const Size size{5, 4, 3};
  for (const int bytes : {1, 2}) {
    const Pattern pattern = pattern_for({Kind::unsigned_integer, bytes});
    const std::string path = folder() + "/stack.pic";
    on_root([&] {
      write_pic(path, size, bytes, pattern,
                {"Live recording", "AXIS_2 257 0.000000e+00 1.050000e+00 microns",
                 "AXIS_3 257 0.000000e+00 1.050000e+00 microns",
                 "AXIS_4 257 0.000000e+00 2.000000e+00 microns"});
    });
    expect_pattern(read(path), size, pattern);
    EXPECT_EQ(summary.format, "Bio-Rad PIC");
    EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{1.05, 1.05, 2.0}));
    EXPECT_EQ(summary.voxel_size.source(), "PIC notes");
    base::Communicator::world().barrier();
  }
}

// A plane too few or too many: what follows is no note, or notes are read as a plane.
TEST(Formats, BioRadPicWithAnotherCountOfPlanesIsTold) {
  const std::string path = folder() + "/count.pic";
  for (const char planes : {2, 3, 4}) {
    on_root([&] {
      write_pic(path, {5, 4, 3}, 1, pattern_for({Kind::unsigned_integer, 1}),
                {"Live recording", "AXIS_4 257 0.000000e+00 2.000000e+00 microns"});
      std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(4);
      file.put(planes);
    });
    read(path);
    EXPECT_EQ(summary.notes.size(), planes == 3 ? 0u : 1u) << int{planes};
    for (const std::string& note : summary.notes)
      EXPECT_NE(note.find("are no notes of 96 bytes each"), std::string::npos) << note;
    base::Communicator::world().barrier();
  }
}

TEST(Formats, NrrdInBothByteOrders) {
  const ValueType type{Kind::signed_integer, 2};
  for (const bool big_endian : {false, true}) {
    const std::string path = folder() + "/volume.nrrd";
    on_root([&] {
      write_nrrd(path, {5, 4, 3}, "int16", type, big_endian, pattern_for(type),
                 "spacings: 0.5 0.5 2\nunits: \"um\" \"um\" \"um\"\n");
    });
    expect_pattern(read(path), {5, 4, 3}, pattern_for(type));
    expect_pattern(read(path, 0, "", {{1, 1, 1, 3, 2, 2}}), {3, 2, 2}, pattern_for(type), 0,
                   {1, 1, 1});
    EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.5, 0.5, 2.0}));
    base::Communicator::world().barrier();
  }
}

TEST(Formats, MetaImageInBothByteOrders) {
  const ValueType type{Kind::unsigned_integer, 2};
  for (const bool big_endian : {false, true}) {
    const std::string path = folder() + "/volume.mha";
    on_root([&] {
      write_metaimage(path, {5, 4, 3}, "MET_USHORT", type, big_endian, pattern_for(type),
                      "DistanceUnits = um\nElementSpacing = 0.5 0.25 2\n");
    });
    expect_pattern(read(path), {5, 4, 3}, pattern_for(type));
    expect_pattern(read(path, 0, "", {{1, 1, 1, 3, 2, 2}}), {3, 2, 2}, pattern_for(type), 0,
                   {1, 1, 1});
    EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.5, 0.25, 2.0}));
    base::Communicator::world().barrier();
  }
}

TEST(Formats, Nifti) {
  const ValueType type{Kind::floating, 4};
  const std::string path = folder() + "/volume.nii";
  on_root([&] {
    write_nifti(path, {5, 4, 3}, 16, type, pattern_for(type), {1.05f, 1.05f, 1.0f}, 3);
  });
  expect_pattern(read(path), {5, 4, 3}, pattern_for(type));
  EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{1.05, 1.05, 1.0}));
  EXPECT_EQ(summary.voxel_size.source(), "NIfTI header");
  // The same, compressed.
  on_root([&] {
    const std::string bytes = read_bytes(path);
    const gzFile file = gzopen((path + ".gz").c_str(), "wb");
    gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(file);
  });
  expect_pattern(read(path + ".gz"), {5, 4, 3}, pattern_for(type));
}

TEST(Formats, Hdf5OfEveryTypeAndShape) {
  std::vector<ValueType> types = integer_types;
  types.push_back({Kind::floating, 4});
  types.push_back({Kind::floating, 8});
  types.push_back({Kind::signed_integer, 8});
  std::vector<Hdf5Dataset> datasets;
  for (std::size_t i = 0; i < types.size(); ++i) {
    Hdf5Dataset set;
    set.name = "volume" + std::to_string(i);
    set.type = types[i];
    set.compressed = i % 2 == 0;
    datasets.push_back(set);
  }
  Hdf5Dataset channels;
  channels.name = "channels";
  channels.channels = 2;
  channels.element_size = {2.0, 1.05, 1.04};
  datasets.push_back(channels);
  Hdf5Dataset flat;
  flat.name = "flat";
  flat.flat = true;
  datasets.push_back(flat);
  const std::string path = folder() + "/volumes.h5";
  on_root([&] { write_hdf5(path, datasets); });

  for (std::size_t i = 0; i < types.size(); ++i) {
    SCOPED_TRACE(types[i].name());
    expect_pattern(read(path, 0, "volume" + std::to_string(i)), {5, 4, 3}, pattern_for(types[i]));
    EXPECT_EQ(summary.type.name(), types[i].name());
  }
  expect_pattern(read(path, 0, "/volume0", {{1, 1, 1, 3, 2, 2}}), {3, 2, 2}, pattern_for(types[0]),
                 0, {1, 1, 1});
  for (const int channel : {0, 1})
    expect_pattern(read(path, channel, "channels"), {5, 4, 3}, pattern_for(channels.type), channel);
  EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{1.04, 1.05, 2.0}));
  expect_pattern(read(path, 0, "flat"), {5, 4, 1}, pattern_for(flat.type));
}

TEST(Formats, WhatWriteTiffWritesReadsBack) {
  const base::Communicator world = base::Communicator::world();
  const Pattern pattern = pattern_for({Kind::unsigned_integer, 1});
  voxels::Volume<std::uint8_t> volume(world, {6, 5, 7}, {1.05, 0.93, 0.4994126});
  std::size_t voxel = 0;
  for (std::int64_t z = 0; z < volume.planes; ++z) {
    for (std::int64_t y = 0; y < 5; ++y) {
      for (std::int64_t x = 0; x < 6; ++x)
        volume.values[voxel++] =
            static_cast<std::uint8_t>(pattern(x, y, z + volume.first_plane, 0));
    }
  }
  const std::string path = folder() + "/written.tif";
  image::write_tiff(world, path, volume);
  expect_pattern(read(path), volume.size, pattern);
  EXPECT_NEAR(summary.voxel_size.um[0], 1.05, 1e-9);
  EXPECT_NEAR(summary.voxel_size.um[1], 0.93, 1e-9);
  EXPECT_NEAR(summary.voxel_size.um[2], 0.4994126, 1e-9);
  EXPECT_EQ(summary.voxel_size.source(), "ImageJ tags");
}

}  // namespace
}  // namespace stroma::test
