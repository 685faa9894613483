// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Image stacks of runs: layouts, regions, resets, steps, restarts, and what the program says of
/// them. Claim V-STACK-3, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "stroma/image/ReadVolume.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

/// A block of 8 x 12 x 10 voxels of 1 x 1 x 2 um, a third of it of label 1, which its faces put
/// into a homogeneous state.
std::string block(const std::string& gradient, const std::string& more = "") {
  return R"(Stroma:
  Image:
    Phantom:
      Kind: Shapes
      Size: [8, 12, 10]
      Voxel Size [um]: [1, 1, 2]
      Shapes:
        left:
          Kind: Box
          Center [um]: [4, 2, 10]
          Size [um]: [8, 4, 20]
          Label: 1
  Materials:
    gel:
      Label: 0
      Model: Neo-Hookean
      Shear Modulus [Pa]: 500
      Poisson Ratio: 0.3
    stiff:
      Label: 1
      Model: Neo-Hookean
      Shear Modulus [Pa]: 500
      Poisson Ratio: 0.3
  Grid:
    Element Size [um]: [2, 2, 4]
  Boundary Conditions:
    all:
      Face: all
      Components: xyz
      Displacement Gradient: )" +
         gradient + R"(
  Loading:
    Steps: 2
  Output:
    Pictures: false
    Particles Every: 0
    Grid Every: 0
    Image Stacks:
      Quantities: [displacement_y, strain_yy, label]
)" + more;
}

const std::string stretch = "[0, 0, 0, 0, 0.5, 0, 0, 0, 0]";

struct Stack {
  image::ImageSummary summary;
  voxels::IntensityVolume values;

  double at(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return values.plane(z)[y * values.size[0] + x];
  }
};

Stack stack_of(const fs::path& path, int channel) {
  image::ImageParameters parameters;
  parameters.file = path.string();
  parameters.channel = channel;
  Stack stack;
  stack.values = image::read_volume(base::Communicator::self(), parameters, "", stack.summary);
  return stack;
}

void run(const TemporaryFolder& folder, const std::string& deck, int ranks = 1,
         const std::string& options = "") {
  folder.write("deck.yaml", deck);
  const Outcome outcome =
      run_stroma(folder.path(), "run deck.yaml -o out --quiet" + options, ranks);
  EXPECT_EQ(outcome.status, 0) << deck << outcome.standard_error;
}

/// u_y = Y / 2 at the voxels' middles, whatever the particles that they are made of.
void expect_undeformed(const fs::path& path, double tolerance) {
  const Stack u = stack_of(path, 0), strain = stack_of(path, 1), label = stack_of(path, 2);
  EXPECT_EQ(u.values.size, (std::array<std::int64_t, 3>{8, 12, 10}));
  EXPECT_EQ(u.summary.voxel_size.um, (std::array<double, 3>{1.0, 1.0, 2.0}));
  for (std::int64_t z = 0; z < 10; ++z)
    for (std::int64_t y = 0; y < 12; ++y)
      for (std::int64_t x = 0; x < 8; ++x) {
        EXPECT_NEAR(u.at(x, y, z), 0.5 * (static_cast<double>(y) + 0.5), tolerance);
        EXPECT_NEAR(strain.at(x, y, z), 0.5 * (1.5 * 1.5 - 1.0), 1e-6);
        EXPECT_EQ(label.at(x, y, z), y < 4 ? 1.0 : 0.0);
      }
}

TEST(ImageStacks, AreMeansWhateverTheLayoutOfParticles) {
  struct Case {
    const char* layout;
    double tolerance;  // half of what u changes by within a particle's share
  };
  for (const auto& [layout, tolerance] :
       {Case{"Layout: Voxel Centers", 1e-6}, Case{"{Layout: Voxel Centers, Per Voxel: 2}", 1e-6},
        Case{"{Layout: Gauss}", 0.25}, Case{"{Layout: Per Element, Per Element: 2}", 1e-6},
        Case{"{Layout: Per Element, Per Element: 3}", 0.2}}) {
    const TemporaryFolder folder;
    const std::string words = layout;
    run(folder,
        block(stretch) + "  Particles: " + (words[0] == '{' ? words : "{" + words + "}") + "\n");
    SCOPED_TRACE(layout);
    expect_undeformed(folder / "out/image_undeformed.ome.tif", tolerance);
  }
}

TEST(ImageStacks, OfElementsThatCutVoxelsAreMeansOverTheParts) {
  const TemporaryFolder folder;
  std::string deck = block(stretch);
  const std::string size = "[2, 2, 4]";
  deck.replace(deck.find(size), size.size(), "[1.6, 1.5, 5]");
  run(folder, deck);
  expect_undeformed(folder / "out/image_undeformed.ome.tif", 1e-6);
}

TEST(ImageStacks, ShowTheBodyWhereItHasGone) {
  for (const int ranks : {1, 2}) {
    const TemporaryFolder folder;
    // 12 voxels become 18, and have moved on by none: u_y = y - y / 1.5.
    run(folder, block(stretch, "      Frame: Both\n      Format: OME-Zarr\n"), ranks);
    const fs::path path = folder / "out/image_deformed.ome.zarr";
    const Stack u = stack_of(path, 0), label = stack_of(path, 2);
    EXPECT_EQ(u.values.size, (std::array<std::int64_t, 3>{8, 18, 10}));
    for (std::int64_t y = 0; y < 18; ++y) {
      const double middle = static_cast<double>(y) + 0.5;
      EXPECT_NEAR(u.at(3, y, 5), middle / 3.0, 0.25);
      EXPECT_EQ(label.at(3, y, 5), y < 6 ? 1.0 : 0.0);
    }
    expect_undeformed(folder / "out/image_undeformed.ome.zarr", 1e-6);
  }
}

TEST(ImageStacks, TurnWithTheBody) {
  // A quarter turn about z, by a displacement gradient R - I: 8 x 12 voxels become 12 x 8.
  const TemporaryFolder folder;
  std::string deck = block("[-1, -1, 0, 1, -1, 0, 0, 0, 0]", "      Frame: Deformed\n");
  deck.replace(deck.find("Steps: 2"), 8, "Steps: 8");
  run(folder, deck);
  const Stack label = stack_of(folder / "out/image_deformed.ome.tif", 2);
  EXPECT_EQ(label.values.size, (std::array<std::int64_t, 3>{12, 8, 10}));
  for (std::int64_t x = 0; x < 12; ++x)  // x = -Y: label 1 lies at the upper end
    for (std::int64_t y = 0; y < 8; ++y) EXPECT_EQ(label.at(x, y, 4), x < 8 ? 0.0 : 1.0);
}

TEST(ImageStacks, OfARegionLieInTheWholeImage) {
  const TemporaryFolder folder;
  std::string deck = block(stretch);
  const std::string phantom = "    Phantom:";
  deck.insert(deck.find(phantom), "    Region: [2, 2, 4, 4, 6, 6]\n");
  run(folder, deck);
  const Stack u = stack_of(folder / "out/image_undeformed.ome.tif", 0);
  EXPECT_EQ(u.values.size, (std::array<std::int64_t, 3>{4, 6, 6}));
  const std::string head = content_of(folder / "out/image_undeformed.ome.tif").substr(0, 1 << 20);
  EXPECT_NE(head.find("PositionX=\"2\""), std::string::npos);
  EXPECT_NE(head.find("PositionZ=\"8\""), std::string::npos);
}

TEST(ImageStacks, OnAGridThatIsResetFollowTheParticles) {
  // The body moves on by 2, 3 and 2 voxels, from element to element and from rank to rank.
  const TemporaryFolder folder;
  std::string deck = block("", "      Frame: Both\n");
  const std::string gradient = "Displacement Gradient: ", size = "[2, 2, 4]\n";
  deck.replace(deck.find(gradient), gradient.size(), "Displacement [um]: [2, 3, 4]");
  deck.insert(deck.find(size) + size.size(), "    Reset: true\n");
  run(folder, deck, 2);
  for (const char* frame : {"undeformed", "deformed"}) {
    const fs::path path = folder / ("out/image_" + std::string(frame) + ".ome.tif");
    const Stack u = stack_of(path, 0), strain = stack_of(path, 1), label = stack_of(path, 2);
    EXPECT_EQ(u.values.size, (std::array<std::int64_t, 3>{8, 12, 10}));
    for (std::int64_t z = 0; z < 10; ++z)
      for (std::int64_t y = 0; y < 12; ++y)
        for (std::int64_t x = 0; x < 8; ++x) {
          EXPECT_NEAR(u.at(x, y, z), 3.0, 1e-6);
          EXPECT_NEAR(strain.at(x, y, z), 0.0, 1e-9);
          EXPECT_EQ(label.at(x, y, z), y < 4 ? 1.0 : 0.0);
        }
  }
  const std::string head = content_of(folder / "out/image_deformed.ome.tif").substr(0, 1 << 20);
  for (const char* place : {"PositionX=\"2\"", "PositionY=\"3\"", "PositionZ=\"4\""})
    EXPECT_NE(head.find(place), std::string::npos) << place;
}

TEST(ImageStacks, AreWrittenAsOftenAsAskedAndBelongToTheRun) {
  const TemporaryFolder folder;
  run(folder, block(stretch, "      Every: 1\n      Format: OME-Zarr\n"));
  for (const char* step : {"0000", "0001", "0002"})
    EXPECT_TRUE(
        fs::is_directory(folder / (std::string("out/image_undeformed-s") + step + ".ome.zarr")));
  const Stack half = stack_of(folder / "out/image_undeformed-s0001.ome.zarr", 1);
  EXPECT_NEAR(half.at(0, 0, 0), 0.5 * (1.25 * 1.25 - 1.0), 1e-6);

  // The next run removes what this one has left; but not what somebody has changed.
  std::ofstream(folder / "out/image_undeformed-s0001.ome.zarr/0/0/0/0/0", std::ios::app) << "x";
  fs::create_directory(folder / "out/image_deformed.ome.zarr");
  const Outcome refused = run_stroma(folder.path(), "run deck.yaml -o out --quiet");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.standard_error.find("image_undeformed-s0001.ome.zarr"), std::string::npos)
      << refused.standard_error;
  fs::remove_all(folder / "out/image_undeformed-s0001.ome.zarr");
  run(folder, block(stretch, "      Frame: Undeformed\n"));
  EXPECT_FALSE(fs::exists(folder / "out/image_undeformed-s0000.ome.zarr"));
  EXPECT_TRUE(fs::exists(folder / "out/image_undeformed.ome.tif"));
  EXPECT_TRUE(fs::exists(folder / "out/image_deformed.ome.zarr"));
}

TEST(ImageStacks, AreRewrittenByARunThatGoesOn) {
  const TemporaryFolder folder;
  run(folder, block(stretch, "      Every: 1\n"));
  const std::string last = content_of(folder / "out/image_undeformed-s0002.ome.tif");
  fs::copy(folder / "out/image_undeformed-s0002.ome.tif",
           folder / "out/image_undeformed-s0009.ome.tif");
  fs::remove(folder / "out/image_undeformed-s0002.ome.tif");
  // As if a run had been killed after its ninth step.
  std::ofstream(folder / "out/.stroma_files", std::ios::app)
      << "image_undeformed.ome.tif\tbeing written\n";
  run(folder, block(stretch, "      Every: 1\n"), 1, " --restart");
  EXPECT_TRUE(content_of(folder / "out/image_undeformed-s0002.ome.tif") == last);
  EXPECT_FALSE(fs::exists(folder / "out/image_undeformed-s0009.ome.tif"));
}

TEST(ImageStacks, AreImagesToTheProgram) {
  const TemporaryFolder folder;
  run(folder,
      block("[0, 0.5, 0, 0, 0, 0, 0, 0, 0]", "      Frame: Both\n      Format: OME-Zarr\n"));
  const Outcome undeformed =
      run_stroma(folder.path(), "image out/image_undeformed.ome.zarr --channel 2");
  EXPECT_EQ(undeformed.status, 0) << undeformed.standard_error;
  for (const char* words : {"format       OME-Zarr 0.4", "size         8 x 12 x 10 voxels",
                            "voxel size   1 x 1 x 2 um, found in: OME-Zarr scale"})
    EXPECT_NE(undeformed.standard_output.find(words), std::string::npos)
        << undeformed.standard_output;
  const Outcome deformed = run_stroma(folder.path(), "image out/image_deformed.ome.zarr");
  EXPECT_EQ(deformed.status, 0) << deformed.standard_error;
  EXPECT_NE(deformed.standard_output.find("not finite"), std::string::npos);

  // The labels of a stack are a specimen, whose file a run can be traced back to and verify.
  std::string deck = block(stretch);
  const std::size_t phantom = deck.find("    Phantom:"), materials = deck.find("  Materials:");
  deck.replace(phantom, materials - phantom, R"(    File: out/image_undeformed.ome.zarr
    Channel: 2
    Segmentation:
      Method: Labels
)");
  folder.write("again.yaml", deck);
  const Outcome again = run_stroma(folder.path(), "run again.yaml -o again --quiet", 2);
  EXPECT_EQ(again.status, 0) << again.standard_error;
  expect_undeformed(folder / "again/image_undeformed.ome.tif", 1e-6);
  EXPECT_EQ(run_stroma(folder.path(), "verify again").status, 0);

  // A field in the same file, by whatever path, has its channel.
  const std::string in_gel = "      Poisson Ratio: 0.3\n";
  deck.insert(deck.find(in_gel) + in_gel.size(), R"(      Fields:
        mu:
          Parameter: Shear Modulus [Pa]
          Image: out/../out/image_undeformed.ome.zarr
          Intensities: [0, 1]
          Values: [321, 654]
)");
  folder.write("field.yaml", deck);
  const Outcome field = run_stroma(folder.path(), "check field.yaml");
  EXPECT_NE(field.standard_output.find("gel|mu, Shear Modulus [Pa]: 321 to 321"), std::string::npos)
      << field.standard_error;
  std::ofstream(folder / "out/image_undeformed.ome.zarr/0/2/0/0/0", std::ios::app) << "x";
  EXPECT_EQ(run_stroma(folder.path(), "verify again").status, 2);
}

}  // namespace
}  // namespace stroma::test
