// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Every kind of broken image is one clear InputError on all ranks, and no library says a word
/// beside it.

#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>

#include "ReadBack.hpp"

namespace stroma::test {
namespace {

const ValueType u8{Kind::unsigned_integer, 1};
const std::array<std::int64_t, 3> size{5, 4, 3};

/// The bytes of a file that `write` makes.
std::string made(const std::string& file, const std::function<void(const std::string&)>& write) {
  const std::string path = folder() + "/" + file;
  on_root([&] { write(path); });
  const std::string bytes = read_bytes(path);
  base::Communicator::world().barrier();
  return bytes;
}

std::string tiff_bytes(const TiffOptions& options) {
  return made("good.tif", [&](const std::string& path) {
    write_tiff_file(path, options, pattern_for(options.type));
  });
}

TEST(BrokenFiles, NotAnImageFile) {
  expect_refused("missing.tif", "no such file");
  expect_refused(".", "is a folder");
  expect_refused("empty.tif", "", "is empty");
  expect_refused("text.tif", "This is not an image at all, whatever its name says.",
                 "is in no format known here");
  expect_refused("wrong_magic.tif", std::string("II\x2B\x2A") + std::string(100, 'x'),
                 "is in no format known here");
}

TEST(BrokenFiles, TiffTruncated) {
  TiffOptions options;
  options.size = {64, 64, 3};
  const std::string good = tiff_bytes(options);
  expect_refused("header_only.tif", good.substr(0, 8), "broken");
  expect_refused("cut.tif", good.substr(0, good.size() / 2), "truncated");
  expect_refused("cut_by_little.tif", good.substr(0, good.size() - 5), "truncated");
}

// ImageJ writes directories first, so that a truncated file still lists its pages.
TEST(BrokenFiles, TiffWhoseValuesAreCutOff) {
  const std::string good = tiff_head(64, 64, 400, "", true) + std::string(64 * 64, 'v');
  expect_refused("beyond.tif", good.substr(0, good.size() - 1),
                 "is truncated: page 0 reaches to byte 4496, the file has 4495");
  const std::string stack = tiff_head(64, 64, 400, "ImageJ=1.53t\nimages=3\nslices=3\n", true);
  expect_refused("stack.tif", stack + std::string(2 * 64 * 64, 'v'), "cannot hold them");
}

TEST(BrokenFiles, TiffWithDamagedCompression) {
  TiffOptions options;
  options.size = {64, 64, 1};
  options.compression = 8;
  std::string bytes = tiff_bytes(options);
  for (std::size_t i = 8; i < 60; ++i) bytes[i] = static_cast<char>(bytes[i] ^ 0x5A);
  expect_refused("damaged.tif", bytes, "cannot be decoded");
}

TEST(BrokenFiles, TiffOfAbsurdSize) {
  for (const bool big_endian : {false, true}) {
    expect_refused("absurd.tif", tiff_head(1000000000, 1000000000, 400, "", big_endian) + "v",
                   "1000000000 x 1000000000 x 1 voxels");
  }
  expect_refused("zero.tif", tiff_head(0, 4, 400, "", false) + "vvvv", "zero.tif");
}

TEST(BrokenFiles, TiffOfWrongKind) {
  TiffOptions one_bit_like;
  one_bit_like.description = "ImageJ=1.53t\nimages=6\nslices=6\n";
  expect_refused("fewer_pages.tif", tiff_bytes(one_bit_like),
                 "speak of 6 images, but it holds 3 pages (truncated?)");
  TiffOptions more_pages;
  more_pages.description = "ImageJ=1.53t\nimages=2\nslices=2\n";
  expect_refused("more_pages.tif", tiff_bytes(more_pages),
                 "speak of 2 images, but it holds 3 pages, which is more");
  TiffOptions frames;
  frames.description = "ImageJ=1.53t\nimages=3\nframes=3\nslices=1\n";
  tiff_bytes(frames);
  image::ImageParameters fourth;
  fourth.file = "good.tif";
  fourth.frame = 3;
  expect_refused(fourth, "has no frame 3 (Image|Frame); admissible: 0 to 2");
  TiffOptions ome;
  ome.description =
      "<OME><Image><Pixels SizeX=\"5\" SizeY=\"4\" SizeZ=\"9\" SizeC=\"1\" "
      "SizeT=\"1\"/></Image></OME>";
  expect_refused("ome.tif", tiff_bytes(ome), "says 9 planes, but it holds 3 pages");
}

TEST(BrokenFiles, ChannelRegionAndDatasetThatAreNotThere) {
  tiff_bytes({});
  image::ImageParameters parameters;
  parameters.file = "good.tif";
  parameters.channel = 1;
  expect_refused(parameters, "has no channel 1 (Image|Channel); admissible: 0 to 0");
  parameters.channel = 0;
  parameters.region = {{0, 0, 1, 5, 4, 3}};
  expect_refused(parameters,
                 "Image|Region takes the voxels 1 to 3 along z; admissible: within 0 to 2");
  parameters.region.reset();
  parameters.dataset = "raw";
  expect_refused(parameters, "is not an HDF5 file");
}

TEST(BrokenFiles, Pic) {
  const std::string good = made("good.pic", [](const std::string& path) {
    write_pic(path, size, 2, pattern_for({Kind::unsigned_integer, 2}), {});
  });
  expect_refused("cut.pic", good.substr(0, good.size() - 1), "cannot hold them");
  expect_refused("header.pic", good.substr(0, 70), "within the header");
  std::string zero = good;
  zero.replace(4, 2, std::string(2, '\0'));
  expect_refused("zero.pic", zero, "5 x 4 x 0 voxels; admissible: at least 1");
}

TEST(BrokenFiles, NrrdMetaImageNifti) {
  const std::string nrrd = made("good.nrrd", [](const std::string& path) {
    write_nrrd(path, size, "uint8", u8, false, pattern_for(u8), "");
  });
  expect_refused("cut.nrrd", nrrd.substr(0, nrrd.size() - 7), "is truncated: its header announces");
  expect_refused(
      "absurd.nrrd",
      "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 1000000000 1000000000 1\nencoding: raw\n\nx",
      "more than any file holds");
  expect_refused("zero.nrrd",
                 "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 5 0 3\nencoding: raw\n\n",
                 "zero.nrrd");
  expect_refused("complex.nrrd",
                 "NRRD0004\ntype: float\ndimension: 3\nsizes: 2 2 2\nkinds: complex domain "
                 "domain\nencoding: raw\nendian: "
                 "little\n\n" +
                     std::string(32, '\0'),
                 "admissible: real values");
  const std::string meta = made("good.mha", [](const std::string& path) {
    write_metaimage(path, size, "MET_UCHAR", u8, false, pattern_for(u8), "");
  });
  expect_refused("cut.mha", meta.substr(0, meta.size() - 7), "is truncated: its header announces");
  expect_refused("absurd.mha",
                 "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 1000000000 "
                 "1000000000 1\nElementType = "
                 "MET_UCHAR\nElementDataFile = LOCAL\nx",
                 "more than any file holds");
  const std::string nifti = made("good.nii", [](const std::string& path) {
    write_nifti(path, size, 2, u8, pattern_for(u8), {1, 1, 1}, 3);
  });
  expect_refused("cut.nii", nifti.substr(0, nifti.size() - 7),
                 "is truncated: its header announces");
  expect_refused("header.nii", nifti.substr(0, 348), "is truncated: its header announces");
  on_root([&] {
    const std::string path = folder() + "/cut.nii.gz";
    const gzFile file = gzopen(path.c_str(), "wb");
    gzwrite(file, nifti.data(), static_cast<unsigned>(nifti.size() - 7));
    gzclose(file);
  });
  expect_refused("cut.nii.gz", "is truncated: its header announces");
}

TEST(BrokenFiles, Hdf5) {
  Hdf5Dataset raw;
  raw.name = "raw";
  Hdf5Dataset label = raw;
  label.name = "label";
  const std::string good = made("good.h5", [&](const std::string& path) {
    write_hdf5(path, {raw, label});
  });
  expect_refused("good.h5", "holds several datasets; name one by Image|Dataset: label, raw");
  image::ImageParameters parameters;
  parameters.file = "good.h5";
  parameters.dataset = "rav";
  expect_refused(parameters, "holds no dataset \"rav\" (Image|Dataset); admissible: label, raw");
  parameters.dataset = "raw";
  parameters.channel = 2;
  expect_refused(parameters, "has no channel 2");
  expect_refused("cut.h5", good.substr(0, good.size() / 2), "broken or truncated HDF5");
  expect_refused("magic.h5", good.substr(0, 16), "broken or truncated HDF5");
  Hdf5Dataset absent = raw;
  absent.size = {5, 4, 3};
  made("none.h5", [&](const std::string& path) { write_hdf5(path, {}); });
  expect_refused("none.h5", "holds no dataset");
}

}  // namespace
}  // namespace stroma::test
