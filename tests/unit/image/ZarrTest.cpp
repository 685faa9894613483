// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Folders of Zarr as other programs write them, and such as nobody should. Claim V-ZARR-1,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ReadBack.hpp"
#include "stroma/image/formats/Compression.hpp"

namespace stroma::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const ValueType u8{Kind::unsigned_integer, 1}, u16{Kind::unsigned_integer, 2};

/// How an array is to be: axes t, c, z, y, x of sizes 2, 3, 7, 5, 6, in chunks of 1, 2, 3, 4, 4.
struct Options {
  ValueType type = u16;
  std::string dtype = "<u2";
  bool big_endian = false;
  std::string order = "C";
  std::string separator = "/";
  image::Compression compression = image::Compression::none;
  Json compressor = nullptr;
  Json axes = Json::parse(R"([{"name": "t", "type": "time"}, {"name": "c", "type": "channel"},
      {"name": "z", "type": "space", "unit": "micrometer"},
      {"name": "y", "type": "space", "unit": "nanometer"},
      {"name": "x", "type": "space", "unit": "nanometer"}])");
};

constexpr std::array<std::int64_t, 5> shape{2, 3, 7, 5, 6}, chunk{1, 2, 3, 4, 4};

Json array_of(const Options& options) {
  return {{"zarr_format", 2},
          {"shape", shape},
          {"chunks", chunk},
          {"dtype", options.dtype},
          {"compressor", options.compressor},
          {"fill_value", 7},
          {"order", options.order},
          {"filters", nullptr},
          {"dimension_separator", options.separator}};
}

Json attributes_of(const Options& options) {
  const Json datasets = Json::parse(R"([{"path": "s0", "coordinateTransformations":
      [{"type": "scale", "scale": [1, 1, 2, 500, 250]}, {"type": "translation",
        "translation": [0, 0, 9, 9, 9]}]}, {"path": "s1"}])");
  Json image{{"version", "0.4"}, {"axes", options.axes}, {"datasets", datasets}};
  image["coordinateTransformations"] =
      Json::parse(R"([{"type": "scale", "scale": [1, 1, 1, 2, 2]}])");
  return {{"multiscales", {image}}};
}

double value_at(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t c, std::int64_t t) {
  return static_cast<double>((x + 6 * y + 30 * z + 210 * c + 630 * t) % 251);
}

/// Writes all chunks but the last along z of channel 0, frame 0. On rank 0; the others wait.
std::string write(const Options& options) {
  const std::string image = folder() + "/written.zarr", array = image + "/s0";
  on_root([&] {
    fs::remove_all(image);
    fs::create_directories(array);
    write_bytes(image + "/.zattrs", attributes_of(options).dump());
    write_bytes(array + "/.zarray", array_of(options).dump());
    std::array<std::int64_t, 5> n{};
    for (n[0] = 0; n[0] < 2; ++n[0])
      for (n[1] = 0; n[1] < 2; ++n[1])
        for (n[2] = 0; n[2] < 3; ++n[2])
          for (n[3] = 0; n[3] < 2; ++n[3])
            for (n[4] = 0; n[4] < 2; ++n[4]) {
              if (n[0] == 0 && n[1] == 0 && n[2] == 2) continue;
              std::string name, bytes;
              for (const std::int64_t number : n)
                name += (name.empty() ? "" : options.separator) + std::to_string(number);
              for (int i = 0; i < 1 * 2 * 3 * 4 * 4; ++i) {
                std::array<std::int64_t, 5> at{};
                int rest = i;
                for (std::size_t k = 0; k < 5; ++k) {
                  const std::size_t d = options.order == "C" ? 4 - k : k;
                  at[d] = n[d] * chunk[d] + rest % chunk[d];
                  rest /= static_cast<int>(chunk[d]);
                }
                bytes += encode(value_at(at[4], at[3], at[2], at[1], at[0]), options.type,
                                options.big_endian);
              }
              const image::Bytes packed =
                  image::pack(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                              options.compression, static_cast<std::size_t>(options.type.bytes));
              const fs::path path = fs::path(array) / name;
              fs::create_directories(path.parent_path());
              write_bytes(path.string(), std::string(packed.begin(), packed.end()));
            }
  });
  return image;
}

void expect_read(const Options& options) {
  image::ImageParameters parameters;
  parameters.file = write(options);
  for (const int frame : {0, 1})
    for (const int channel : {0, 1, 2}) {
      parameters.frame = frame;
      parameters.channel = channel;
      image::ImageSummary summary;
      const auto volume = read_back(parameters, summary);
      EXPECT_EQ(summary.format, "OME-Zarr 0.4");
      EXPECT_EQ(summary.dataset, "s0");
      EXPECT_EQ(summary.type.name(), options.type.name());
      EXPECT_EQ(summary.channels, 3);
      EXPECT_EQ(summary.frames, 2);
      EXPECT_NEAR(summary.voxel_size.um[0], 0.5, 1e-15);
      EXPECT_NEAR(summary.voxel_size.um[1], 1.0, 1e-15);
      EXPECT_NEAR(summary.voxel_size.um[2], 2.0, 1e-15);
      EXPECT_TRUE(has_note(summary, "4 of the 48 chunks were never written"));
      expect_pattern(volume, {6, 5, 7}, [&](auto x, auto y, auto z, auto) {
        const bool is_missing = frame == 0 && channel < 2 && z == 6;
        return is_missing ? 7.0 : value_at(x, y, z, channel, frame);
      });
    }
}

TEST(Zarr, OfAllTypesOrdersSeparatorsAndCompressors) {
  expect_read({});
  const std::vector<std::pair<std::string, ValueType>> types{{"|u1", u8},
                                                             {">u2", u16},
                                                             {"<i2", {Kind::signed_integer, 2}},
                                                             {">i4", {Kind::signed_integer, 4}},
                                                             {"<u4", {Kind::unsigned_integer, 4}},
                                                             {"<i8", {Kind::signed_integer, 8}},
                                                             {"<u8", {Kind::unsigned_integer, 8}},
                                                             {"<f4", {Kind::floating, 4}},
                                                             {">f8", {Kind::floating, 8}}};
  for (const auto& [dtype, type] : types) {
    Options options;
    options.dtype = dtype;
    options.type = type;
    options.big_endian = dtype[0] == '>';
    expect_read(options);
  }
  for (const char* order : {"C", "F"})
    for (const char* separator : {".", "/"}) {
      Options options;
      options.order = order;
      options.separator = separator;
      expect_read(options);
    }
  const std::vector<std::pair<image::Compression, std::string>> compressors{
      {image::Compression::zlib, "zlib"},
      {image::Compression::zlib, "gzip"},
      {image::Compression::zstd, "zstd"},
      {image::Compression::blosc, "blosc"}};
  for (const auto& [compression, id] : compressors) {
    Options options;
    options.compression = compression;
    options.compressor = {{"id", id}};
    expect_read(options);
  }
}

TEST(Zarr, AxesMayBeNamesAlone) {
  Options options;
  options.axes = {"t", "c", "z", "y", "x"};  // OME-Zarr 0.3
  image::ImageParameters parameters;
  parameters.file = write(options);
  parameters.frame = 1;
  image::ImageSummary summary;
  const auto volume = read_back(parameters, summary);
  EXPECT_EQ(volume.size, (Size{6, 5, 7}));
  EXPECT_FALSE(summary.voxel_size.known(0));
  EXPECT_TRUE(has_note(summary, "scale along x, 500 without a unit, is no length; not used"));
}

/// A folder of which one of the JSON files is altered.
void expect_refused_with(const char* file, const Json& patch, const std::string& words) {
  const Options options;
  const std::string image = write(options);
  on_root([&] {
    Json json = std::string(file) == ".zattrs" ? attributes_of(options) : array_of(options);
    json.merge_patch(patch);
    write_bytes(image + (std::string(file) == ".zattrs" ? "/" : "/s0/") + file, json.dump());
  });
  expect_refused(image, words);
}

TEST(Zarr, HeadersThatCannotBeAreRefused) {
  const auto array = [](const std::string& patch, const std::string& words) {
    expect_refused_with(".zarray", Json::parse(patch), words);
  };
  array(R"({"zarr_format": 3})", "its .zarray says zarr_format = 3; admissible: 2");
  array(R"({"shape": [2, 3, 7, 5]})", "says chunks");
  array(R"({"shape": [2, 3, 7, 5, 0]})", "says shape");
  array(R"({"shape": [2, 3, 7, 5, -6]})", "says shape");
  array(R"({"shape": [2, 3, 7, 5, 6.5]})", "says shape");
  array(R"({"shape": [2, 3, 7, 5, 18446744073709551615]})", "says shape");
  array(R"({"shape": "all"})", "says shape = \"all\"");
  array(R"({"shape": [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]})", "says shape");
  array(R"({"dtype": "<c8"})", "says dtype = \"<c8\"");
  array(R"({"dtype": [["r", "|u1"]]})", "says dtype");
  array(R"({"dtype": "|u2"})", "says dtype");
  array(R"({"compressor": {"id": "lzma"}})", "says compressor");
  array(R"({"filters": [{"id": "delta"}]})", "says filters");
  array(R"({"order": "K"})", "says order = \"K\"");
  array(R"({"fill_value": "AAAA"})", "says fill_value");
  array(R"({"dimension_separator": "-"})", "says dimension_separator");
  // Sizes that nothing stands behind are refused before anything of their size is allocated.
  array(R"({"shape": [2, 3, 1000000000, 1000000000, 1000000000]})",
        "of which 44 were ever written");
  array(R"({"shape": [1, 1, 1000, 100000, 100000], "chunks": [1, 1, 1000, 100000, 100001]})",
        "has chunks of");
  array(R"({"chunks": [1, 2, 3, 4, 5]})", "instead of 240");

  const auto attributes = [](const std::string& patch, const std::string& words) {
    expect_refused_with(".zattrs", Json::parse(patch), words);
  };
  attributes(R"({"multiscales": 3})", "says multiscales = 3");
  attributes(R"({"multiscales": []})", "says multiscales");
  attributes(R"({"multiscales": [{"datasets": []}]})", "says multiscales[0].datasets");
  attributes(R"({"multiscales": [{"datasets": [{"path": "../other"}]}]})", "says path");
  attributes(R"({"multiscales": [{"datasets": [{"path": "/etc"}]}]})", "says path");
  attributes(R"({"multiscales": [{"datasets": [{"path": "s7"}]}]})", "there is no .zarray");
  attributes(R"({"multiscales": [{"datasets": [{"path": "s0"}], "axes": ["z", "y", "x"]}]})",
             "its axes \"zyx\" do not fit its array");
  attributes(
      R"({"multiscales": [{"datasets": [{"path": "s0"}], "axes": ["t", "c", "x", "y", "x"]}]})",
      "name an axis twice");
  attributes(
      R"({"multiscales": [{"datasets": [{"path": "s0"}], "axes": ["t", "c", "q", "y", "x"]}]})",
      "name an axis of several entries otherwise");
}

TEST(Zarr, FilesThatAreBrokenAreRefused) {
  const auto broken = [](const image::Compression compression, const std::string& id,
                         const std::string& bytes, const std::string& words) {
    Options options;
    options.compression = compression;
    if (!id.empty()) options.compressor = {{"id", id}};
    const std::string image = write(options);
    on_root([&] { write_bytes(image + "/s0/0/0/0/0/0", bytes); });
    expect_refused(image, words);
  };
  using image::Compression;
  broken(Compression::none, "", "short", "its chunk 0/0/0/0/0 of level \"s0\" has 5 bytes instead");
  broken(Compression::zlib, "zlib", "no stream", "is no stream of zlib");
  broken(Compression::zstd, "zstd", "no frame", "is no frame of zstd");
  broken(Compression::blosc, "blosc", "no buffer of Blosc", "is no buffer of Blosc");
  broken(Compression::blosc, "blosc", "", "is no buffer of Blosc");
  broken(Compression::zstd, "zstd", std::string(200000, 'x'), "more than packing makes of");
  // One that unpacks to more than a chunk holds.
  const std::string much(1 << 20, 'a');
  for (const auto& [compression, id] :
       {std::pair{Compression::zlib, "zlib"}, std::pair{Compression::zstd, "zstd"},
        std::pair{Compression::blosc, "blosc"}}) {
    const image::Bytes packed = image::pack(reinterpret_cast<const unsigned char*>(much.data()),
                                            much.size(), compression, 2);
    broken(compression, id, std::string(packed.begin(), packed.end()), "unpacks to");
  }
  const std::string image = write({});
  on_root([&] { write_bytes(image + "/.zattrs", "{\"multiscales\": [{"); });
  expect_refused(image, "its .zattrs is no JSON object");
  on_root([&] {
    const std::string open(100000, '['), close(100000, ']');
    write_bytes(image + "/.zattrs", R"({"multiscales": {"a": )" + open + close + "}}");
  });
  expect_refused(image, "says multiscales");
  on_root([&] {
    fs::remove_all(image);
    fs::create_directories(image);
    write_bytes(image + "/.zgroup", "{\"zarr_format\": 2}");
  });
  expect_refused(image, "holds no image");
  on_root([&] { write_bytes(image + "/zarr.json", "{\"zarr_format\": 3}"); });
  expect_refused(image, "is Zarr of format 3; admissible: format 2");
}

// As xarray writes them.
TEST(Zarr, AxesOfAnArrayByItself) {
  image::ImageParameters parameters;
  parameters.file = write({}) + "/s0";
  const auto size_with = [&](const std::string& attributes, const char* note) {
    on_root([&] { write_bytes(*parameters.file + "/.zattrs", attributes); });
    image::ImageSummary summary;
    const Size size = read_back(parameters, summary).size;
    EXPECT_TRUE(has_note(summary, note)) << attributes;
    return size;
  };
  EXPECT_EQ(
      size_with(R"({"_ARRAY_DIMENSIONS": ["time", "x", "y", "channel", "z"], "add_offset": 3})",
                "its attribute add_offset is not applied"),
      (Size{3, 7, 6}));
  EXPECT_EQ(size_with(R"({"_ARRAY_DIMENSIONS": ["time", "lon", "lat", "channel", "z"]})",
                      "its axes are not stated; read as tczyx"),
            (Size{6, 5, 7}));
}

TEST(Zarr, OtherFilesAreNoChunks) {
  image::ImageParameters parameters;
  parameters.file = write({});
  on_root([&] {
    for (const char* name : {"0/0/0/0/0.part", "0/0/0/0/9", "README"})
      write_bytes(*parameters.file + "/s0/" + name, "no chunk");
  });
  image::ImageSummary summary;
  read_back(parameters, summary);
  EXPECT_TRUE(has_note(summary, "4 of the 48 chunks were never written"));
}

TEST(Zarr, ChunksPartedOtherwiseThanStatedAreFound) {
  image::ImageParameters parameters;
  parameters.file = write({});
  Json header = array_of({});
  header.erase("dimension_separator");
  on_root([&] { write_bytes(*parameters.file + "/s0/.zarray", header.dump()); });
  image::ImageSummary summary;
  const auto volume = read_back(parameters, summary);
  expect_pattern(volume, {6, 5, 7}, [&](auto x, auto y, auto z, auto) {
    return z == 6 ? 7.0 : value_at(x, y, z, 0, 0);
  });
  EXPECT_TRUE(has_note(summary, "parted by '/', not by '.' as its header has it"));
}

// The standard puts the finest first; where it is not, the image is not a coarser one in silence.
TEST(Zarr, LevelsInAnotherOrder) {
  image::ImageParameters parameters;
  parameters.file = write({});
  Json attributes = attributes_of({});
  Json& levels = attributes["multiscales"][0]["datasets"];
  std::swap(levels[0], levels[1]);
  levels[0]["coordinateTransformations"] =
      Json::parse(R"([{"type": "scale", "scale": [1, 1, 4, 1000, 500]}])");
  Json coarse = array_of({});
  coarse["shape"] = {2, 3, 4, 3, 3};
  on_root([&] {
    write_bytes(*parameters.file + "/.zattrs", attributes.dump());
    fs::create_directories(*parameters.file + "/s1");
    write_bytes(*parameters.file + "/s1/.zarray", coarse.dump());
  });
  image::ImageSummary summary;
  EXPECT_EQ(read_back(parameters, summary).size, (Size{6, 5, 7}));
  EXPECT_EQ(summary.dataset, "s0");
  EXPECT_NEAR(summary.voxel_size.um[0], 0.5, 1e-15);
  EXPECT_TRUE(has_note(summary, "\"s0\" has more values than the first, \"s1\", and is read"));
}

TEST(Zarr, ChunksThatAreNoFilesAreRefused) {
  const std::string image = write({});
  on_root([&] {
    fs::remove(image + "/s0/0/0/0/0/0");
    fs::create_directories(image + "/s0/0/0/0/0/0");
  });
  expect_refused(image, "is no file");
}

}  // namespace
}  // namespace stroma::test
