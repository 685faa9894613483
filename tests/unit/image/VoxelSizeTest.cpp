// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Where the size of a voxel is found, which place wins, and that it is never a silent 1.

#include <gtest/gtest.h>

#include "WriteFiles.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/image/ReadVolume.hpp"
#include "stroma/image/formats/LengthUnit.hpp"

namespace stroma::test {
namespace {

const ValueType u8{Kind::unsigned_integer, 1};

image::ImageSummary summary_of(const std::string& path,
                               std::optional<std::array<double, 3>> deck = {}) {
  image::ImageParameters parameters;
  parameters.file = path;
  parameters.voxel_size = deck;
  image::ImageSummary summary;
  image::read_volume(base::Communicator::world(), parameters, "", summary);
  base::Communicator::world().barrier();
  return summary;
}

image::ImageSummary summary_of_tiff(const TiffOptions& options,
                                    std::optional<std::array<double, 3>> deck = {}) {
  const std::string path = folder() + "/calibrated.tif";
  on_root([&] { write_tiff_file(path, options, pattern_for(u8)); });
  return summary_of(path, deck);
}

TiffOptions imagej(const std::string& calibration, double pixels_per_unit) {
  TiffOptions options;
  options.description = "ImageJ=1.53t\nimages=3\nslices=3\n" + calibration;
  options.resolution_x = options.resolution_y = pixels_per_unit;
  return options;
}

TEST(VoxelSize, UnitsOfLength) {
  EXPECT_EQ(image::micrometres_per("micron"), 1.0);
  EXPECT_FALSE(image::micrometres_per("Pm") || image::micrometres_per("Mm"));
  EXPECT_EQ(image::micrometres_per("\\u00B5m"), 1.0);
  EXPECT_EQ(image::micrometres_per("\xC2\xB5m"), 1.0);
  EXPECT_EQ(image::micrometres_per("\xB5m"), 1.0);
  EXPECT_EQ(image::micrometres_per("nm"), 1e-3);
  EXPECT_EQ(image::micrometres_per("mm"), 1e3);
  EXPECT_EQ(image::micrometres_per("inch"), 25400.0);
  EXPECT_FALSE(image::micrometres_per("pixel"));
  EXPECT_FALSE(image::micrometres_per(""));
  EXPECT_FALSE(image::micrometres_per("Mm"));
  EXPECT_EQ(image::shortest_decimal(1.05f), 1.05);
}

TEST(VoxelSize, ImageJTagsInTheirUnit) {
  const image::ImageSummary micron = summary_of_tiff(imagej("unit=micron\nspacing=2.5\n", 4.0));
  EXPECT_EQ(micron.voxel_size.um, (std::array<double, 3>{0.25, 0.25, 2.5}));
  EXPECT_EQ(micron.voxel_size.source(), "ImageJ tags");
  const image::ImageSummary nanometre = summary_of_tiff(imagej("unit=nm\nspacing=250.0\n", 0.002));
  EXPECT_NEAR(nanometre.voxel_size.um[0], 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(nanometre.voxel_size.um[2], 0.25);
  const image::ImageSummary escaped = summary_of_tiff(imagej("unit=\\u00B5m\nspacing=2.0\n", 2.0));
  EXPECT_EQ(escaped.voxel_size.um, (std::array<double, 3>{0.5, 0.5, 2.0}));
}

TEST(VoxelSize, APixelIsNoLength) {
  const image::ImageSummary summary = summary_of_tiff(imagej("unit=pixel\nspacing=1.0\n", 1.0));
  for (int axis = 0; axis < 3; ++axis) EXPECT_FALSE(summary.voxel_size.known(axis));
  EXPECT_EQ(summary.voxel_size.source(), "nowhere");
}

TEST(VoxelSize, ResolutionTagsGiveTheirPlaneOnly) {
  TiffOptions options;
  options.resolution_x = 20000.0;  // per cm: 0.5 um
  options.resolution_y = 10000.0;
  options.resolution_unit = 3;
  const image::ImageSummary summary = summary_of_tiff(options);
  EXPECT_NEAR(summary.voxel_size.um[0], 0.5, 1e-9);
  EXPECT_NEAR(summary.voxel_size.um[1], 1.0, 1e-9);
  EXPECT_FALSE(summary.voxel_size.known(2));
  EXPECT_EQ(summary.voxel_size.source(), "TIFF resolution tags (x, y), nowhere (z)");
}

TEST(VoxelSize, APrintersResolutionIsNoCalibration) {
  TiffOptions options;
  options.resolution_x = options.resolution_y = 72.0;
  options.resolution_unit = 2;
  const image::ImageSummary summary = summary_of_tiff(options);
  EXPECT_FALSE(summary.voxel_size.known(0));
  ASSERT_EQ(summary.notes.size(), 1u);
  EXPECT_NE(summary.notes[0].find("72 pixels per inch"), std::string::npos) << summary.notes[0];
}

TEST(VoxelSize, TheDeckWinsAndSaysSo) {
  const image::ImageSummary summary = summary_of_tiff(imagej("unit=micron\nspacing=2.5\n", 4.0),
                                                      std::array<double, 3>{0.25, 0.3, 2.5});
  EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.25, 0.3, 2.5}));
  EXPECT_EQ(summary.voxel_size.source(), "deck");
  ASSERT_EQ(summary.notes.size(), 1u);  // x and z agree
  EXPECT_NE(summary.notes[0].find("0.3 um from the deck is used, not 0.25 um"), std::string::npos)
      << summary.notes[0];
}

TEST(VoxelSize, NrrdAndMetaImageWithoutUnitSayNothing) {
  const std::string nrrd = folder() + "/unitless.nrrd", meta = folder() + "/unitless.mha";
  on_root([&] {
    write_nrrd(nrrd, {5, 4, 3}, "uint8", u8, false, pattern_for(u8), "spacings: 1.05 1.05 1\n");
    write_metaimage(meta, {5, 4, 3}, "MET_UCHAR", u8, false, pattern_for(u8),
                    "ElementSpacing = 1.05 1.05 1\n");
  });
  for (const std::string& path : {nrrd, meta}) {
    const image::ImageSummary summary = summary_of(path);
    EXPECT_FALSE(summary.voxel_size.known(0));
    ASSERT_EQ(summary.notes.size(), 1u);
    EXPECT_NE(summary.notes[0].find("no unit of length"), std::string::npos);
  }
}

TEST(VoxelSize, NrrdSpaceDirectionsAndNiftiMillimetres) {
  const std::string nrrd = folder() + "/directions.nrrd", nifti = folder() + "/millimetres.nii";
  on_root([&] {
    write_nrrd(nrrd, {5, 4, 3}, "uint8", u8, false, pattern_for(u8),
               "space dimension: 3\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,2)\nspace units: "
               "\"nm\" \"nm\" \"nm\"\n");
    write_nifti(nifti, {5, 4, 3}, 2, u8, pattern_for(u8), {0.001f, 0.001f, 0.002f}, 2);
  });
  EXPECT_NEAR(summary_of(nrrd).voxel_size.um[2], 0.002, 1e-15);
  EXPECT_NEAR(summary_of(nifti).voxel_size.um[0], 1.0, 1e-9);
}

TEST(VoxelSize, MissingEverywhereIsAnErrorThatNamesTheParameter) {
  TiffOptions options;
  const std::string path = folder() + "/uncalibrated.tif";
  on_root([&] { write_tiff_file(path, options, pattern_for(u8)); });
  image::ImageParameters parameters;
  parameters.file = path;
  try {
    image::read_labels(base::Communicator::world(), parameters, "");
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("Image|Voxel Size [um]"), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("x, y, z"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace stroma::test
