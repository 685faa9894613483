// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// From an image file to labels: methods, region, smoothing, small objects, fractions.

#include <gtest/gtest.h>

#include <cmath>

#include "WriteFiles.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/image/ReadVolume.hpp"
#include "stroma/image/labels/Segmentation.hpp"
#include "support/Places.hpp"

namespace stroma::test {
namespace {

using Method = image::SegmentationParameters::Method;

image::ImageParameters parameters_for(const std::string& name, const ValueType& type,
                                      const Pattern& pattern,
                                      const std::array<std::int64_t, 3>& size) {
  image::ImageParameters parameters;
  parameters.file = name;
  parameters.voxel_size = std::array<double, 3>{1.0, 1.0, 2.0};
  TiffOptions options;
  options.size = size;
  options.type = type;
  on_root([&] { write_tiff_file(folder() + "/" + name, options, pattern); });
  return parameters;
}

double ramp(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t) {
  return static_cast<double>(x + 10 * y + z);
}

TEST(Segmentation, ThresholdIsStrict) {
  const base::Communicator world = base::Communicator::world();
  image::ImageParameters parameters =
      parameters_for("ramp.tif", {Kind::unsigned_integer, 1}, ramp, {10, 8, 5});
  parameters.segmentation.method = Method::threshold;
  parameters.segmentation.threshold = 40.0;
  const voxels::LabelVolume labels = image::read_labels(world, parameters, folder());
  EXPECT_EQ(labels.voxel_size, (std::array<double, 3>{1.0, 1.0, 2.0}));
  std::size_t voxel = 0;
  for (std::int64_t z = 0; z < labels.planes; ++z) {
    for (std::int64_t y = 0; y < 8; ++y) {
      for (std::int64_t x = 0; x < 10; ++x)
        ASSERT_EQ(labels.values[voxel++], ramp(x, y, z + labels.first_plane, 0) > 40.0 ? 1 : 0);
    }
  }
  // Plane z has 39 + z values above 40 of 80: x + 10 y > 40 - z.
  const std::vector<double> planes = image::plane_fractions(world, labels, 1);
  ASSERT_EQ(planes.size(), 5u);
  for (std::size_t z = 0; z < 5; ++z)
    EXPECT_DOUBLE_EQ(planes[z], (39.0 + static_cast<double>(z)) / 80.0);
  const auto fractions = image::volume_fractions(world, labels);
  EXPECT_DOUBLE_EQ(fractions.at(1), 41.0 / 80.0);
  EXPECT_DOUBLE_EQ(fractions.at(0), 39.0 / 80.0);
}

TEST(Segmentation, LabelsAreTheValuesAndMinusOneIsEmptySpace) {
  const base::Communicator world = base::Communicator::world();
  const auto labels_of = [](std::int64_t x, std::int64_t, std::int64_t z, std::int64_t) {
    return x == 2 && z == 1 ? 2147483647.0 : static_cast<double>(x % 3) - 1.0;
  };
  image::ImageParameters parameters =
      parameters_for("labels.tif", {Kind::signed_integer, 4}, labels_of, {7, 4, 3});
  parameters.segmentation.method = Method::labels;
  image::ImageSummary summary;
  const voxels::LabelVolume labels = image::read_labels(world, parameters, folder(), &summary);
  EXPECT_EQ(summary.type.name(), "32-bit signed integer");
  const auto fractions = image::volume_fractions(world, labels);
  ASSERT_EQ(fractions.size(), 4u);
  EXPECT_DOUBLE_EQ(fractions.at(-1), 3.0 / 7.0);
  EXPECT_DOUBLE_EQ(fractions.at(2147483647), 1.0 / 21.0);
}

TEST(Segmentation, AValueThatIsNoLabelIsNamedWithItsPlace) {
  const base::Communicator world = base::Communicator::world();
  for (const double bad : {0.5, -2.0}) {
    const auto values = [&](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t) {
      return x == 3 && y == 2 && z == 1 ? bad : 1.0;
    };
    image::ImageParameters parameters =
        parameters_for("bad_labels.tif", {Kind::floating, 4}, values, {7, 4, 3});
    parameters.segmentation.method = Method::labels;
    try {
      image::read_labels(world, parameters, folder());
      FAIL() << "no error";
    } catch (const base::InputError& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find("(3, 2, 1)"), std::string::npos) << said;
      EXPECT_NE(said.find("bad_labels.tif"), std::string::npos) << said;
    }
    world.barrier();
  }
}

TEST(Segmentation, RegionSmoothingAndSmallObjects) {
  const base::Communicator world = base::Communicator::world();
  // A block of 4 x 4 x 4 and a loose bright voxel in the dark.
  const auto blocks = [](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t) {
    const bool block = x >= 8 && x < 12 && y >= 8 && y < 12 && z >= 3 && z < 7;
    return block || (x == 3 && y == 3 && z == 3) ? 200.0 : 10.0;
  };
  image::ImageParameters parameters =
      parameters_for("blocks.tif", {Kind::unsigned_integer, 1}, blocks, {16, 16, 10});
  image::ImageSummary summary;
  const auto count = [&] {
    const voxels::LabelVolume labels = image::read_labels(world, parameters, folder(), &summary);
    std::int64_t ones = 0;
    for (const std::int32_t label : labels.values) ones += label;
    return world.sum(ones);
  };
  EXPECT_EQ(count(), 65);  // Otsu
  parameters.segmentation.smallest_object = 2;
  EXPECT_EQ(count(), 64);
  EXPECT_EQ(summary.notes.back(), "objects of fewer than 2 voxels removed: 1");
  parameters.segmentation.smallest_object = 0;
  parameters.segmentation.method = Method::threshold;
  parameters.segmentation.threshold = 100.0;
  parameters.segmentation.smoothing = 1.0;  // the loose voxel sinks below the threshold
  const std::int64_t smoothed = count();
  EXPECT_LE(smoothed, 64);
  EXPECT_GE(smoothed, 8);
  parameters.segmentation.smoothing = 0.0;
  parameters.region = {{10, 0, 5, 6, 16, 5}};
  EXPECT_EQ(count(), 2 * 4 * 2);
  EXPECT_EQ(summary.size, (std::array<std::int64_t, 3>{6, 16, 5}));
  EXPECT_EQ(summary.file_size, (std::array<std::int64_t, 3>{16, 16, 10}));
}

/// What read_labels() says against the parameters.
std::string refusal(const image::ImageParameters& parameters) {
  try {
    image::read_labels(base::Communicator::world(), parameters, folder());
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Segmentation, IntensitiesThatAreNotFiniteAreCountedAndTheFirstIsNamed) {
  const base::Communicator world = base::Communicator::world();
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const auto values = [&](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t) {
      return (x == 3 && y == 2 && z == 1) || (x == 1 && z == 2) ? bad
                                                                : 1.0 + static_cast<double>(x);
    };
    image::ImageParameters parameters =
        parameters_for("not_finite.tif", {Kind::floating, 4}, values, {7, 4, 3});
    for (const Method method : {Method::threshold, Method::otsu, Method::labels}) {
      for (const double smoothing : {0.0, 1.0, 1e9}) {
        if (method == Method::labels && smoothing > 0.0) continue;
        parameters.segmentation = {};
        parameters.segmentation.method = method;
        parameters.segmentation.smoothing = smoothing;
        if (method == Method::threshold) parameters.segmentation.threshold = 2.0;
        const std::string said = refusal(parameters);
        EXPECT_NE(said.find("not_finite.tif: 5 of 84 voxels are not finite"), std::string::npos)
            << said;
        EXPECT_NE(said.find("voxel (3, 2, 1)"), std::string::npos) << said;
      }
    }
    parameters.region = {{0, 1, 2, 7, 3, 1}};  // places are counted in the file
    EXPECT_NE(refusal(parameters).find("3 of 21 voxels"), std::string::npos);
    EXPECT_NE(refusal(parameters).find("voxel (1, 1, 2)"), std::string::npos);
    world.barrier();
  }
}

TEST(Segmentation, ANanOfARealFileIsNotLabelZero) {
  image::ImageParameters parameters;
  parameters.file = clone_folder().string() + "/tests/data/cases/nan_voxel/onenan.tif";
  parameters.voxel_size = std::array<double, 3>{1.0, 1.0, 1.0};
  parameters.segmentation.method = Method::threshold;
  parameters.segmentation.threshold = 0.0;
  EXPECT_NE(refusal(parameters).find(": 1 of "), std::string::npos) << refusal(parameters);
}

TEST(Segmentation, SmoothingFarBeyondTheImageLeavesTheMean) {
  const base::Communicator world = base::Communicator::world();
  image::ImageParameters parameters;
  parameters.file = clone_folder().string() + "/tests/data/cases/smoothing/im.tif";
  image::ImageSummary summary;
  const voxels::IntensityVolume whole = image::read_volume(world, parameters, "", summary);
  double sum = 0.0;
  for (const double value : whole.values) sum += value;
  const double mean = world.sum(sum) / static_cast<double>(whole.voxels());
  parameters.segmentation.method = Method::threshold;
  for (const double smoothing : {1e6, 1e9, 1e300}) {
    parameters.segmentation.smoothing = smoothing;
    for (const double beside : {-1e-6, 1e-6}) {
      parameters.segmentation.threshold = mean + beside;
      const auto labels = image::read_labels(world, parameters, "", &summary);
      const auto fractions = image::volume_fractions(world, labels);
      EXPECT_EQ(fractions.count(1), beside < 0.0 ? 1u : 0u);
      EXPECT_EQ(fractions.count(0), beside < 0.0 ? 0u : 1u);
    }
    EXPECT_NE(summary.notes.back().find("along x, y, z"), std::string::npos)
        << summary.notes.back();
  }
}

TEST(Segmentation, EmptyLabelsBecomeEmptySpace) {
  const base::Communicator world = base::Communicator::world();
  const auto blocks = [](std::int64_t x, std::int64_t y, std::int64_t, std::int64_t) {
    return x < 3 ? 0.0 : y < 2 ? 240.0 : 255.0;
  };
  image::ImageParameters parameters =
      parameters_for("empty.tif", {Kind::unsigned_integer, 1}, blocks, {8, 4, 5});
  image::ImageSummary summary;
  const auto fractions = [&] {
    return image::volume_fractions(world,
                                   image::read_labels(world, parameters, folder(), &summary));
  };
  using Fractions = std::map<std::int32_t, double>;
  parameters.segmentation.method = Method::labels;
  parameters.segmentation.empty_labels = std::vector<int>{0, 255, 7};
  EXPECT_EQ(fractions(), (Fractions{{-1, 110.0 / 160.0}, {240, 50.0 / 160.0}}));
  const auto count = summary.notes.size();
  ASSERT_GE(count, 3u);
  EXPECT_EQ(summary.notes[count - 3], "Empty Labels: label 0, 60 of 160 voxels, is empty space");
  EXPECT_EQ(summary.notes[count - 1], "Empty Labels: label 7, 0 of 160 voxels, is empty space");
  for (const Method method : {Method::threshold, Method::otsu}) {
    parameters.segmentation.method = method;
    if (method == Method::threshold) parameters.segmentation.threshold = 50.0;
    if (method == Method::otsu) parameters.segmentation.threshold.reset();
    parameters.segmentation.empty_labels = "Dark";
    EXPECT_EQ(fractions(), (Fractions{{-1, 60.0 / 160.0}, {1, 100.0 / 160.0}}));
    parameters.segmentation.empty_labels = "Bright";
    EXPECT_EQ(fractions(), (Fractions{{-1, 100.0 / 160.0}, {0, 60.0 / 160.0}}));
  }
}

TEST(Segmentation, ASpeckInEmptySpaceThatIsRemovedBecomesEmpty) {
  const base::Communicator world = base::Communicator::world();
  // Layers of empty space, label 0 and label 4 along z; a speck in each, and one between the first
  // two.
  const auto layers = [](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t) {
    if (x == 5 && y == 5 && (z == 2 || z == 8 || z == 13)) return 3.0;
    if (x == 9 && y == 5 && z == 4) return 2.0;  // 17 neighbours of label 0, 9 of empty space
    return z < 4 ? 255.0 : z < 11 ? 0.0 : 4.0;
  };
  image::ImageParameters parameters =
      parameters_for("specks.tif", {Kind::unsigned_integer, 1}, layers, {12, 11, 16});
  parameters.segmentation.method = Method::labels;
  parameters.segmentation.empty_labels = std::vector<int>{255};
  parameters.segmentation.smallest_object = 5;
  image::ImageSummary summary;
  const auto labels = image::read_labels(world, parameters, folder(), &summary);
  EXPECT_EQ(summary.notes.back(), "objects of fewer than 5 voxels removed: 4");
  std::size_t voxel = 0;
  for (std::int64_t k = 0; k < labels.planes; ++k) {
    for (std::int64_t v = 0; v < labels.plane_voxels(); ++v, ++voxel) {
      const std::int64_t z = labels.first_plane + k;
      const bool inside_four = z == 13 && v == 5 + 12 * 5;  // touches no background: label 0
      ASSERT_EQ(labels.values[voxel], z < 4                   ? -1
                                      : z < 11 || inside_four ? 0
                                                              : 4)
          << "voxel " << v << " of plane " << z;
    }
  }
}

}  // namespace
}  // namespace stroma::test
