// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A run that would remove one of its inputs, for an earlier run left that file in the output folder, is
/// refused before anything is removed.

#include <gtest/gtest.h>

#include <map>

#include "support/SmallDeck.hpp"

namespace stroma::test {
namespace {

const std::string tiff = "image_undeformed.ome.tif", zarr = "image_undeformed.ome.zarr";

/// All files below a folder.
std::map<std::string, std::string> contents_below(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) contents[entry.path().string()] = content_of(entry.path());
  return contents;
}

class InputsStay : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("gel.yaml", small_deck());
    const std::string stacks =
        "run gel.yaml --quiet --set 'Output|Image Stacks|Quantities={label,von_mises}'";
    ASSERT_EQ(run_stroma(folder_.path(), stacks + " -o out").status, 0);
    ASSERT_EQ(
        run_stroma(folder_.path(), stacks + " -o zarr --set 'Output|Image Stacks|Format=OME-Zarr'")
            .status,
        0);
  }

  /// \param deck   of a run that asks for no stacks
  /// \param input  as the message names it
  /// \param file   in the output folder
  void expect_refused(const std::string& deck, const std::string& out, const std::string& input,
                      const std::string& file, int ranks = 1) const {
    SCOPED_TRACE(input + " in " + out);
    const auto before = contents_below(folder_ / out);
    ASSERT_GT(before.size(), 5U);
    folder_.write("deck.yaml", deck);
    const Outcome outcome = run_stroma(folder_.path(), "run deck.yaml --quiet -o " + out, ranks);
    EXPECT_EQ(outcome.status, 2) << outcome.standard_error;
    EXPECT_NE(outcome.standard_error.find("holds '" + input + "' as '" + file +
                                          "', which an "
                                          "earlier run left there and this one would remove"),
              std::string::npos)
        << outcome.standard_error;
    EXPECT_TRUE(contents_below(folder_ / out) == before);
  }
  void expect_refused(const std::string& out, const std::string& input, const std::string& file,
                      int ranks = 1) const {
    expect_refused(small_deck_of_labels(input), out, input, file, ranks);
  }

  const TemporaryFolder folder_;
};

// V-FOLDER.
TEST_F(InputsStay, ByWhateverPath) {
  expect_refused("out", "out/" + tiff, tiff);
  expect_refused("out", "out/" + tiff, tiff, 2);
  expect_refused("out", "zarr/../out/" + tiff, tiff);
  fs::create_symlink("out/" + tiff, folder_ / "soft.tif");
  expect_refused("out", "soft.tif", tiff);
  fs::create_hard_link(folder_ / "out" / tiff, folder_ / "hard.tif");
  expect_refused("out", "hard.tif", tiff);
  fs::create_directory_symlink("out", folder_ / "linked");
  expect_refused("linked", "out/" + tiff, tiff);
  expect_refused("out", "linked/" + tiff, tiff);
  // Into another folder it may run.
  folder_.write("deck.yaml", small_deck_of_labels("out/" + tiff));
  const Outcome outcome = run_stroma(folder_.path(), "run deck.yaml --quiet -o elsewhere");
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
}

// V-FOLDER.
TEST_F(InputsStay, OfZarrAndWithinIt) {
  expect_refused("zarr", "zarr/" + zarr, zarr);
  expect_refused("zarr", "zarr/" + zarr, zarr, 2);
  expect_refused("zarr", "zarr/" + zarr + "/0", zarr);
  fs::create_directory_symlink("zarr/" + zarr, folder_ / "soft.ome.zarr");
  expect_refused("zarr", "soft.ome.zarr", zarr);
}

// V-FOLDER.
TEST_F(InputsStay, WhateverTheyAreFor) {
  const std::string image = "out/" + tiff, three = "{Images: [" + image + ", " + image + ", " +
                                                   image + "], 'Voxel Size [um]': [1, 1, 1]}";
  const auto with = [](std::string text, const std::string& old, const std::string& instead) {
    return text.replace(text.find(old), old.size(), instead);
  };
  const std::string gel = "      Shear Modulus [Pa]: 500.0\n", strain = "      Strain: 0.10\n",
                    loading = "  Loading:\n";
  const auto field = [&](const std::string& file) {
    return with(small_deck(), gel,
                gel + "      Fields: {s: {Parameter: 'Shear Modulus [Pa]', Image: " + file +
                    ", Intensities: [0, 1], Values: [500, 900]}}\n");
  };
  expect_refused(field(image), "out", image, tiff);
  expect_refused(with(small_deck(), gel,
                      gel +
                          "      Fibers: {f: {Law: Exponential-Power, 'Xi [Pa]': 300, Alpha: 2, "
                          "Beta: 2.5, Direction From: Structure Tensor, Image: " +
                          image + ", 'Gradient Scale [um]': 1, 'Window Scale [um]': 2}}\n"),
                 "out", image, tiff);
  expect_refused(with(small_deck(), strain, "      Displacement Images: " + three + "\n"), "out",
                 image, tiff);
  const std::string moves =
      with(small_deck(), loading,
           "  Initial Conditions: {drift: {Velocity Images: " + three + "}}\n" + loading +
               "    Inertia: true\n    Duration [s]: 1.0\n");
  expect_refused(
      std::regex_replace(moves, std::regex("      Poisson"), "      Density [kg/m^3]: 1000.0\n$&"),
      "out", image, tiff);
  // The data beside a header, which is found when the image is read.
  folder_.write("header.mhd",
                "ObjectType = Image\nNDims = 3\nDimSize = 8 8 8\nElementSpacing = 1 1 1\n"
                "ElementType = MET_UCHAR\nHeaderSize = -1\nElementDataFile = " +
                    image + "\n");
  expect_refused(field("header.mhd"), "out", "./" + image, tiff);
}

}  // namespace
}  // namespace stroma::test
