// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A broken image ends `stroma image` and `stroma run` with exit status 2, a plain message, and
/// nothing else: no banner, no output folder. (Every format's own ways to be broken:
/// tests/unit/image.)

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

/// A sound image to break: 8 x 8 x 3 voxels, written by the program itself.
std::string sound_tiff() {
  static const std::string bytes = [] {
    const TemporaryFolder folder;
    const Outcome outcome = run_stroma(
        folder.path(), "phantom -o sound.tif --size 24,24,8 --voxel 2,2,2 --fraction 0.2");
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    return content_of(folder / "sound.tif");
  }();
  return bytes;
}

std::string meta_image(const std::string& size, const std::string& values) {
  return "ObjectType = Image\nNDims = 3\nDimSize = " + size +
         "\nElementSpacing = 1 1 1\nDistanceUnits = um\nElementType = MET_UCHAR\n"
         "ElementDataFile = LOCAL\n" +
         values;
}

std::string project_file(const std::string& name) { return content_of(clone_folder() / name); }

struct BrokenImage {
  std::string name;
  std::string file;
  std::function<std::string()> bytes;
  std::string options;  ///< of `stroma image`
  std::string says;
};

std::string deck_of(const std::string& file, const std::string& channel) {
  return "Stroma:\n  Image: {File: " + file + ", \"Voxel Size [um]\": [2.0, 2.0, 2.0]" + channel +
         "}\n"
         "  Materials:\n"
         "    gel: {Label: 0, \"Shear Modulus [Pa]\": 1.0, Poisson Ratio: 0.3}\n"
         "    vessel: {Label: 1, \"Shear Modulus [Pa]\": 2.0, Poisson Ratio: 0.3}\n"
         "  Grid: {Elements: [1, 1, 1]}\n"
         "  Boundary Conditions: {bottom: {Face: y-, Components: xyz}}\n";
}

class BrokenImages : public testing::TestWithParam<BrokenImage> {};

// Results hold NaN where the body is not, and so may images; but a specimen may not.
TEST(NotFinite, AValueThatIsNaNIsToldOfAndRefusedAsASpecimen) {
  const TemporaryFolder folder;
  folder.write("onenan.tif", project_file("tests/data/cases/nan_voxel/onenan.tif"));
  const Outcome told = run_stroma(folder.path(), "image onenan.tif");
  EXPECT_EQ(told.status, 0) << told.standard_error;
  EXPECT_NE(told.standard_output.find("not finite   1 of "), std::string::npos)
      << told.standard_output;
  folder.write("deck.yaml", deck_of("onenan.tif", ""));
  const Outcome refused = run_stroma(folder.path(), "run deck.yaml -o results");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.standard_error.find("onenan.tif: 1 of "), std::string::npos)
      << refused.standard_error;
}

TEST_P(BrokenImages, EndWithExitStatusTwoAndAPlainMessage) {
  const BrokenImage& broken = GetParam();
  const TemporaryFolder folder;
  folder.write(broken.file, broken.bytes());
  folder.write("deck.yaml", deck_of(broken.file, broken.options.empty() ? "" : ", Channel: 7"));
  for (const std::string& command :
       {"image " + broken.file + " " + broken.options, std::string("run deck.yaml -o results")}) {
    SCOPED_TRACE(command);
    const Outcome outcome = run_stroma(folder.path(), command);
    EXPECT_EQ(outcome.status, 2) << outcome.standard_error;
    EXPECT_NE(outcome.standard_error.find(broken.file), std::string::npos)
        << outcome.standard_error;
    EXPECT_NE(outcome.standard_error.find(broken.says), std::string::npos)
        << outcome.standard_error;
    EXPECT_LE(std::count(outcome.standard_error.begin(), outcome.standard_error.end(), '\n'), 4)
        << outcome.standard_error;
    EXPECT_FALSE(fs::exists(folder / "results"));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, BrokenImages,
    testing::Values(
        BrokenImage{"truncated", "cut.tif",
                    [] { return sound_tiff().substr(0, sound_tiff().size() / 2); }, "",
                    "broken or truncated TIFF"},
        BrokenImage{"wrong_magic", "magic.tif", [] { return "XX" + sound_tiff().substr(2); }, "",
                    "in no format known here"},
        BrokenImage{"zero_size", "empty.tif", [] { return std::string(); }, "",
                    "is empty (0 bytes)"},
        BrokenImage{"absurd_dimensions", "absurd.mha",
                    [] { return meta_image("1000000000 1000000000 1000", "abc"); }, "",
                    "more than any file holds"},
        BrokenImage{"values_missing", "short.mha", [] { return meta_image("8 8 8", "abc"); }, "",
                    "is truncated"},
        BrokenImage{"missing_channel", "sound.tif", sound_tiff, "--channel 7", "has no channel 7"},
        BrokenImage{"hdf5_in_half", "half.h5",
                    [] { return project_file("tests/fuzz/images/plain.h5").substr(0, 1900); }, "",
                    "broken or truncated HDF5"},
        BrokenImage{"unknown_format", "image.xyz", [] { return std::string("hello"); }, "",
                    "admissible: TIFF"}),
    [](const auto& image) { return image.param.name; });

// Each rank opens HDF5 files itself: none waits for one that has given up.
TEST(BrokenHdf5, EndsAlikeOnTwoRanks) {
  const std::string sound = project_file("tests/fuzz/images/chunked.h5");
  ASSERT_GT(sound.size(), 4000U);
  const TemporaryFolder folder;
  folder.write("sound.h5", sound);
  EXPECT_EQ(run_stroma(folder.path(), "image sound.h5", 2).status, 0);
  std::string damaged = sound;
  for (std::size_t at = 2100; at < damaged.size(); at += 40)
    damaged[at] = static_cast<char>(~damaged[at]);
  for (const std::string& bytes : {sound.substr(0, 3000), damaged}) {
    folder.write("broken.h5", bytes);
    const Outcome outcome = run_stroma(folder.path(), "image broken.h5", 2);
    EXPECT_EQ(outcome.status, 2) << outcome.standard_error;
    EXPECT_NE(outcome.standard_error.find("broken.h5: "), std::string::npos)
        << outcome.standard_error;
  }
}

}  // namespace
}  // namespace stroma::test
