// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The deck section "Image": what it reads, and the mistakes it finds.

#include <gtest/gtest.h>

#include "stroma/base/Error.hpp"
#include "stroma/deck/Document.hpp"
#include "stroma/sections/ImageSection.hpp"

namespace stroma::test {
namespace {

struct Root {
  image::ImageParameters image;
};

Root read(const std::string& image) {
  deck::Section<Root> root("Stroma", "A test.");
  root.required_section(sections::image_section(), &Root::image);
  return deck::read(deck::parse("Stroma:\n  Image:\n" + image, deck::Format::yaml, "deck.yaml"),
                    root);
}

void expect_mistake(const std::string& image, const std::string& words) {
  try {
    read(image);
    FAIL() << "no mistake found in\n" << image;
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(ImageSection, ReadsAFileAndItsSegmentation) {
  const image::ImageParameters p =
      read(
          "    File: gel.tif\n    Channel: 1\n    Frame: 2\n    Voxel Size [um]: [1.05, 1.05, "
          "1.0]\n"
          "    Region: [0, 1, 2, 3, 4, 5]\n    Segmentation:\n      Method: Threshold\n"
          "      Threshold: 90.0\n      Smoothing [um]: 0.5\n      Smallest Object: 27\n")
          .image;
  EXPECT_EQ(p.file, "gel.tif");
  EXPECT_EQ(p.channel, 1);
  EXPECT_EQ(p.frame, 2);
  EXPECT_EQ(p.voxel_size, (std::array<double, 3>{1.05, 1.05, 1.0}));
  EXPECT_EQ(p.region, (std::array<int, 6>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(p.segmentation.method, image::SegmentationParameters::Method::threshold);
  EXPECT_EQ(p.segmentation.threshold, 90.0);
  EXPECT_EQ(p.segmentation.smoothing, 0.5);
  EXPECT_EQ(p.segmentation.smallest_object, 27);
  EXPECT_FALSE(p.phantom);
}

TEST(ImageSection, EmptyLabelsAreAListOrAWord) {
  using List = std::vector<int>;
  const auto empty = [](const std::string& method, const std::string& value) {
    return read("    File: gel.tif\n    Segmentation:\n      Method: " + method +
                "\n      Empty Labels: " + value + "\n")
        .image.segmentation.empty_labels;
  };
  EXPECT_EQ(std::get<List>(empty("Labels", "[0, 255]").value()), (List{0, 255}));
  EXPECT_EQ(std::get<std::string>(empty("Otsu", "Dark").value()), "Dark");
  EXPECT_FALSE(read("    File: gel.tif\n").image.segmentation.empty_labels);
}

const std::string phantom =
    "    Phantom:\n      Size: [8, 8, 8]\n      Voxel Size [um]: [1.0, 1.0, 1.0]\n";

TEST(ImageSection, ReadsShapesInTheirOrder) {
  const image::ImageParameters p = read(phantom +
                                        "      Kind: Shapes\n      Shapes:\n        tube:\n        "
                                        "  Kind: Cylinder\n          Center [um]: [4.0, 4.0, "
                                        "4.0]\n          Radius [um]: 2.0\n          Axis: [0.0, "
                                        "1.0, 1.0]\n        hole:\n          Kind: Ball\n"
                                        "          Label: -1\n          Center [um]: [4.0, 4.0, "
                                        "4.0]\n          Radius [um]: 1.0\n")
                                       .image;
  ASSERT_TRUE(p.phantom && p.phantom->shapes);
  const auto& shapes = p.phantom->shapes->shapes;
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes[0].first, "tube");
  EXPECT_EQ(shapes[0].second.axis, (std::array<double, 3>{0.0, 1.0, 1.0}));
  EXPECT_FALSE(shapes[0].second.length);
  EXPECT_EQ(shapes[1].second.label, -1);
}

TEST(ImageSection, FindsMistakesBetweenParameters) {
  expect_mistake("    Channel: 0\n", "File, or the sublist Phantom");
  expect_mistake("    File: gel.tif\n" + phantom + "      Kind: Uniform\n", "not both");
  expect_mistake("    File: gel.tif\n    Segmentation:\n      Method: Threshold\n",
                 "required with Method = Threshold");
  expect_mistake("    File: gel.tif\n    Segmentation:\n      Method: Otsu\n      Threshold: 3.0\n",
                 "needs Method = Threshold");
  expect_mistake(
      "    File: gel.tif\n    Segmentation:\n      Method: Labels\n      Smoothing [um]: 1.0\n",
      "labels cannot be smoothed");
  const auto segmented = [](const std::string& lines) {
    return "    File: gel.tif\n    Segmentation:\n" + lines;
  };
  expect_mistake(segmented("      Method: Labels\n      Empty Labels: Dark\n"), "a list of labels");
  expect_mistake(segmented("      Empty Labels: [0]\n"), "Dark or Bright");
  expect_mistake(segmented("      Empty Labels: Drak\n"), "did you mean \"Dark\"?");
  expect_mistake(segmented("      Method: Labels\n      Empty Labels: 0\n"),
                 "a list of one or more integers, each >= 0, or \"Dark\" or \"Bright\"");
  expect_mistake(segmented("      Method: Labels\n      Empty Labels: []\n"), "one or more");
  expect_mistake(segmented("      Method: Labels\n      Empty Labels: [-1]\n"), ">= 0");
  expect_mistake(segmented("      Empty Labels: Bright\n      Smallest Object: 9\n"),
                 "leaves none");
  expect_mistake(phantom + "      Kind: Uniform\n    Segmentation:\n      Empty Labels: Dark\n",
                 "a phantom is made of labels");
  expect_mistake("    File: gel.tif\n    Region: [0, 0, 0, 4, 0, 4]\n", "at least 1 each");
  expect_mistake("    File: gel.tif\n    Voxel Size [um]: [1.0, 0.0, 1.0]\n", "Voxel Size [um]");
  expect_mistake(phantom + "      Kind: Uniform\n      Seed: 3\n", "needs Kind = Vessels");
  expect_mistake(phantom + "      Kind: Shapes\n", "required with Kind = Shapes");
  expect_mistake(phantom +
                     "      Kind: Shapes\n"
                     "      Shapes:\n"
                     "        a:\n"
                     "          Kind: Ball\n"
                     "          Center [um]: [1.0, 1.0, 1.0]\n",
                 "required for a ball");
  expect_mistake(phantom + "      Kind: Uniform\n    Dataset: raw\n", "a phantom has none");
}

}  // namespace
}  // namespace stroma::test
