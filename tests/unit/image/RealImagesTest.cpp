// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The real images of tests/data/images, against the figures in the text beside each, which were
/// computed with other software.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "WriteFiles.hpp"
#include "commands/ImageCommand.hpp"
#include "stroma/image/ReadVolume.hpp"
#include "stroma/image/labels/Histogram.hpp"
#include "stroma/image/labels/Objects.hpp"
#include "stroma/image/labels/Segmentation.hpp"
#include "support/Places.hpp"

namespace stroma::test {
namespace {

const base::Communicator& world() {
  static const base::Communicator instance = base::Communicator::world();
  return instance;
}

struct Figures {
  std::array<std::int64_t, 3> size;
  double min, max, mean, deviation, zeros;
  std::vector<double> percentiles;  // 1, 5, 25, 50, 75, 95, 99, 99.9
  double otsu, otsu_256;
  std::int64_t above;
  double fraction_256;
  std::array<std::int64_t, 3> faces, corners;  // objects, of at least 27 voxels, largest
};

void expect_objects(const voxels::LabelVolume& labels, image::Connectivity connectivity,
                    const std::array<std::int64_t, 3>& expected) {
  const image::Objects objects(world(), labels, connectivity);
  EXPECT_EQ(objects.count(), expected[0]);
  EXPECT_EQ(objects.count(27), expected[1]);
  EXPECT_EQ(objects.largest(), expected[2]);
}

/// Tolerances: the figures are printed with 6 digits.
void expect_figures(const voxels::IntensityVolume& volume, const image::ValueType& type,
                    const Figures& f) {
  EXPECT_EQ(volume.size, f.size);
  const image::Statistics statistics = image::statistics(world(), volume);
  EXPECT_EQ(statistics.min, f.min);
  EXPECT_EQ(statistics.max, f.max);
  EXPECT_NEAR(statistics.mean, f.mean, 5e-6 * f.mean);
  EXPECT_NEAR(statistics.deviation, f.deviation, 5e-6 * f.deviation);
  if (f.min == 0.0) {
    EXPECT_NEAR(1.0 - image::fraction_above(world(), volume, 0.0), f.zeros, 1e-6);
  }
  const image::Histogram levels = image::histogram(world(), volume, type);
  const double percents[] = {1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0, 99.9};
  for (std::size_t i = 0; i < f.percentiles.size(); ++i)
    EXPECT_NEAR(image::percentile(levels, percents[i]), f.percentiles[i], 5e-6 * f.percentiles[i])
        << percents[i] << " %";
  const double threshold = image::otsu_threshold(levels);
  EXPECT_EQ(threshold, f.otsu);
  const double fraction = image::fraction_above(world(), volume, threshold);
  EXPECT_EQ(std::llround(fraction * static_cast<double>(volume.voxels())), f.above);
  const double equal = image::otsu_threshold(image::histogram_with_extremes(world(), volume, 256));
  EXPECT_NEAR(equal, f.otsu_256, 6e-6 * f.otsu_256 + 5e-4);
  EXPECT_NEAR(image::fraction_above(world(), volume, equal), f.fraction_256, 6e-7);
  const voxels::LabelVolume labels = image::threshold_labels(volume, threshold);
  expect_objects(labels, image::Connectivity::faces, f.faces);
  expect_objects(labels, image::Connectivity::corners, f.corners);
}

class RealImages : public ::testing::Test {
 protected:
  voxels::IntensityVolume read(const std::string& file, int channel = 0,
                               const std::string& dataset = "") {
    image::ImageParameters parameters;
    parameters.file = file;
    parameters.channel = channel;
    if (!dataset.empty()) parameters.dataset = dataset;
    return image::read_volume(world(), parameters, folder_, summary_);
  }

  const std::string folder_ = clone_folder().string() + "/tests/data/images";
  image::ImageSummary summary_;
};

TEST_F(RealImages, EndoBlock) {
  const voxels::IntensityVolume volume = read("endo_block.tif");
  EXPECT_EQ(summary_.voxel_size.source(), "nowhere");
  expect_figures(volume, summary_.type,
                 {{100, 100, 99},
                  0,
                  255,
                  19.0231,
                  64.2244,
                  0.910489,
                  {0, 0, 0, 0, 0, 255, 255, 255},
                  64,
                  64.248,
                  73843,
                  0.074589,
                  {44, 32, 20085},
                  {40, 32, 20085}});
}

TEST_F(RealImages, ConfocalNucleus) {
  const voxels::IntensityVolume volume = read("xyzc_16bit__dna_conf_wf.tif", 0);
  // Not the 0.25594 um of the text that was copied along with the image.
  for (std::size_t axis = 0; axis < 2; ++axis)
    EXPECT_NEAR(summary_.voxel_size.um[axis], 0.511878, 5e-7);
  EXPECT_NEAR(summary_.voxel_size.um[2], 0.4994126, 5e-8);
  EXPECT_EQ(summary_.voxel_size.source(), "ImageJ tags");
  EXPECT_EQ(summary_.channels, 2);
  expect_figures(volume, summary_.type,
                 {{133, 130, 45},
                  0,
                  61711,
                  448.143,
                  2948.35,
                  0.212142,
                  {0, 0, 2, 26, 93, 689, 16677, 38377.9},
                  13022,
                  12896.6,
                  8904,
                  0.011480,
                  {1, 1, 8904},
                  {1, 1, 8904}});
}

TEST_F(RealImages, WideFieldNucleus) {
  const voxels::IntensityVolume volume = read("xyzc_16bit__dna_conf_wf.tif", 1);
  expect_figures(volume, summary_.type,
                 {{133, 130, 45},
                  608,
                  7480,
                  965.154,
                  772.364,
                  0.0,
                  {641, 650, 666, 682, 778, 2718, 4612, 5600},
                  2079,
                  2070.98,
                  57941,
                  0.074891,
                  {1, 1, 57941},
                  {1, 1, 57941}});
}

TEST_F(RealImages, TissueFromHdf5AndClipped) {
  voxels::IntensityVolume volume = read("sample_patch.h5", 0, "raw");
  expect_figures(volume, summary_.type,
                 {{200, 200, 64},
                  0,
                  242,
                  14.726,
                  9.7614,
                  5.8e-5,
                  {2, 5, 10, 14, 18, 25, 35, 169},
                  84,
                  83.66,
                  6242,
                  0.002466,
                  {1, 1, 6242},
                  {1, 1, 6242}});
  for (double& value : volume.values) value = std::min(value, 35.0);
  expect_figures(volume, summary_.type,
                 {{200, 200, 64},
                  0,
                  35,
                  14.3477,
                  6.1923,
                  5.8e-5,
                  {2, 5, 10, 14, 18, 25, 35, 35},
                  15,
                  14.971,
                  988777,
                  0.460762,
                  {5655, 11, 977705},
                  {853, 3, 987272}});
}

TEST_F(RealImages, LabelsFromHdf5) {
  image::ImageParameters parameters;
  parameters.file = "sample_patch.h5";
  parameters.dataset = "big_label";
  parameters.voxel_size = std::array<double, 3>{1.0, 1.0, 1.0};
  parameters.segmentation.method = image::SegmentationParameters::Method::labels;
  const voxels::LabelVolume labels = image::read_labels(world(), parameters, folder_);
  const auto fractions = image::volume_fractions(world(), labels);
  EXPECT_EQ(fractions.rbegin()->first, 36);
}

TEST_F(RealImages, ThePapersSlice) {
  const voxels::IntensityVolume volume = read("slice25_vessels.tif");
  EXPECT_EQ(volume.size, (std::array<std::int64_t, 3>{512, 512, 1}));
  EXPECT_EQ(summary_.voxel_size.um, (std::array<double, 3>{1.05, 1.05, 1.0}));
  EXPECT_EQ(summary_.voxel_size.source(), "ImageJ tags");
  const voxels::LabelVolume labels = image::threshold_labels(volume, 127.0);
  EXPECT_DOUBLE_EQ(image::volume_fractions(world(), labels).at(1), 50760.0 / 262144.0);
  const image::Objects objects(world(), labels, image::Connectivity::faces);
  EXPECT_EQ(objects.count(), 75);
  EXPECT_EQ(objects.largest(), 34601);
}

TEST_F(RealImages, TheCommandPrintsThem) {
  const std::string log_file = test::folder() + "/image_log.txt";
  ImageOptions options;
  options.file = folder_ + "/endo_block.tif";
  {
    base::Log log(world(), true);
    log.open_file(log_file);
    EXPECT_EQ(image_command(world(), options, log), 0);
  }
  world().barrier();
  const std::string said = read_bytes(log_file);
  for (const char* words :
       {"100 x 100 x 99 voxels", "found in: nowhere", "8-bit unsigned integer", "threshold 64 ",
        "above it: 0.074589", "44 with 6 neighbours", "40 with 26 neighbours", "mean 19.0231"})
    EXPECT_NE(said.find(words), std::string::npos) << words << " is not in\n" << said;
  world().barrier();
}

}  // namespace
}  // namespace stroma::test
