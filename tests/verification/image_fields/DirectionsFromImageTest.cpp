// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Directions of fibres from images, from the deck to the files, as a user runs it. Claims V-DIR-2,
/// V-DIR-3, docs/verification.md.

#include <cmath>
#include <cstdio>

#include "support/ExodusReader.hpp"
#include "support/FiberPhantom.hpp"
#include "support/WriteStack.hpp"

namespace stroma::test {
namespace {

std::string joined(const std::array<double, 3>& v) {
  char text[100];
  std::snprintf(text, sizeof text, "[%.17g, %.17g, %.17g]", v[0], v[1], v[2]);
  return text;
}

/// A gel with a family of fibres.
/// \param file       of the specimen; all of it is gel
/// \param voxel      its voxel size
/// \param element    likewise
/// \param model      lines of the material
/// \param direction  lines of the family
/// \param pulled     the axis along which it is pulled, sides free
std::string deck(const std::string& file, const std::string& voxel, const std::string& element,
                 const std::string& model, const std::string& direction, char pulled) {
  std::string text = "Stroma:\n  Image:\n    File: " + file + "\n    Voxel Size [um]: " + voxel +
                     "\n    Segmentation:\n      Method: Threshold\n      Threshold: 1e6\n" +
                     "  Materials:\n    gel:\n      Label: 0\n" + model + direction +
                     "  Grid:\n    Element Size [um]: " + element + "\n  Boundary Conditions:\n";
  for (const char axis : {'x', 'y', 'z'}) {
    text += std::string("    ") + axis + ":\n      Face: " + axis + "-\n      Components: " + axis +
            "\n";
    if (axis == pulled)
      text += std::string("    pulled:\n      Face: ") + axis + "+\n      Components: " + axis +
              "\n      Strain: 0.05\n";
  }
  return text + "  Loading:\n    Steps: 1\n  Output:\n    Pictures: false\n";
}

const std::string collagen = R"(      Model: Coupled Neo-Hookean
      Shear Modulus [Pa]: 100
      Poisson Ratio: 0.3
      Fibers:
        collagen:
          Law: Exponential-Power
          Xi [Pa]: 800
          Alpha: 0
          Beta: 2
)";

// V-DIR-2. A blurred and noisy picture of fibres at 37 degrees to y: the gel's stiffness along y and
// across, along x.
TEST(DirectionsFromImage, GiveTheStiffnessOfTheExactOnes) {
  const TemporaryFolder folder;
  std::array<double, 3> n{2.0, 3.0, 1.0};
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& component : n) component /= length;
  const FiberPhantom phantom({48, 48, 24}, {0.5, 0.5, 1.0}, n);
  write_stack<float>(folder, "gel", {48, 48, 24}, phantom);
  for (const char pulled : {'x', 'y'}) {
    const auto force = [&](const std::string& name, const std::string& direction, int ranks) {
      return run_deck(folder, name,
                      deck("gel.mhd", "[0.5, 0.5, 1.0]", "[2, 2, 2]", collagen, direction, pulled),
                      ranks)[std::string("pulled.reaction_") + pulled]
          .at(1);
    };
    const double exact = force("exact", "          Direction: " + joined(n) + "\n", 1);
    const std::string tensor =
        "          Direction From: Structure Tensor\n          Gradient Scale [um]: 1\n"
        "          Window Scale [um]: 4\n";
    const double by_image = force("image", tensor, 1);
    EXPECT_NEAR(by_image / exact, 1.0, 0.02) << pulled;
    std::printf("  %c: %.2f %% from the exact one\n", pulled, 100.0 * (by_image / exact - 1.0));
    EXPECT_NE(by_image, exact);
    EXPECT_NEAR(force("image", tensor, 2) / by_image, 1.0, 1e-6);
  }
  // What particles.e shows are unit vectors, within 2 degrees for most.
  const ExodusReader file(folder.path() / "image" / "particles.e.2.0");
  const auto at = [&](const char* name) {
    return file.variable(file.steps(), EX_ELEM_BLOCK, name, 1, file.counts.num_elem);
  };
  const auto x = at("collagen_direction_x"), y = at("collagen_direction_y"),
             z = at("collagen_direction_z");
  std::size_t close = 0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    EXPECT_NEAR(std::hypot(x[p], y[p], z[p]), 1.0, 1e-12);
    if (std::abs(x[p] * n[0] + y[p] * n[1] + z[p] * n[2]) > std::cos(2.0 * M_PI / 180.0)) ++close;
  }
  EXPECT_GT(close, x.size() / 2);
}

/// Along (3, 4, 0) everywhere, in files of components.
void write_components(const TemporaryFolder& folder) {
  const std::array<int, 3> size{6, 6, 4};
  write_stack<std::uint8_t>(folder, "gel", size, [](int, int, int) { return 1; });
  write_stack<float>(folder, "nx", size,
                     [](int i, int j, int) { return (i + j) % 2 ? 3.0 : -6.0; });
  write_stack<float>(folder, "ny", size,
                     [](int i, int j, int) { return (i + j) % 2 ? 4.0 : -8.0; });
  write_stack<float>(folder, "nz", size, [](int, int, int) { return 0.0; });
}

const std::string from_images =
    "          Direction From: Images\n          Images: [nx.mhd, ny.mhd, nz.mhd]\n";
const std::string given = "          Direction: [3, 4, 0]\n";

// V-DIR-3. Components of one direction, of either sense and any length, and that direction in the
// deck: fibres of their own, of a law that takes directions, an axial distribution, and what
// contracts or grows along them.
TEST(DirectionsFromImage, OfComponentsAreThoseOfTheDeck) {
  const TemporaryFolder folder;
  write_components(folder);
  const std::string hgo = R"(      Model: Holzapfel-Gasser-Ogden
      C [Pa]: 200
      K1 [Pa]: 300
      K2: 2
      Kappa: 0.1
      Bulk Modulus [Pa]: 2000
      Fibers:
        collagen:
)";
  const std::string axial = "          Distribution: Axial\n          Concentration: 3\n";
  const std::string contracts =
      "      Active Stress:\n        Kind: Fiber\n        T0 [Pa]: 30\n"
      "      Growth:\n        Kind: Fiber\n        Ratio: 1.1\n";
  const struct {
    std::string name, model, more;
    double tolerance;
  } choices[] = {{"fibres", collagen, "", 1e-12},
                 {"hgo", hgo, "", 1e-12},
                 {"axial", collagen, axial, 1e-3},  // the quadrature's
                 {"contracts", collagen, contracts, 1e-12}};
  for (const auto& choice : choices) {
    SCOPED_TRACE(choice.name);
    const auto result = [&](const std::string& name, const std::string& direction) {
      return run_deck(
          folder, name,
          deck("gel.mhd", "[1, 1, 1]", "[2, 2, 2]", choice.model, direction + choice.more, 'y'));
    };
    const History by_images = result("images", from_images), expected = result("given", given);
    for (const char* column : {"pulled.reaction_y", "strain_energy", "gel.volume"}) {
      const double value = expected[column].at(1);
      EXPECT_NEAR(by_images[column].at(1), value, choice.tolerance * std::abs(value)) << column;
    }
  }
}

// What a header says is told, as of the specimen's own image.
TEST(DirectionsFromImage, OfAMirroredHeaderAreThoseOfTheArrayAndThatIsSaid) {
  const TemporaryFolder folder;
  write_components(folder);
  folder.write("deck.yaml", deck("gel.mhd", "[1, 1, 1]", "[2, 2, 2]", collagen, from_images, 'y'));
  const std::string note =
      "note: Materials|gel|Fibers|collagen: the header turns or mirrors the axes";
  EXPECT_EQ(run_stroma(folder.path(), "check deck.yaml").standard_output.find(note),
            std::string::npos);
  const std::string header = content_of(folder / "nx.mhd"), type = "ElementType";
  std::string mirrored = header;
  mirrored.insert(header.find(type), "TransformMatrix = -1 0 0 0 1 0 0 0 1\n");
  folder.write("nx.mhd", mirrored);
  const Outcome outcome = run_stroma(folder.path(), "check deck.yaml");
  EXPECT_NE(outcome.standard_output.find(note), std::string::npos)
      << outcome.standard_output << outcome.standard_error;
}

TEST(DirectionsFromImage, NameTheVoxelWithoutOne) {
  const TemporaryFolder folder;
  write_components(folder);
  write_stack<float>(folder, "nx", {6, 6, 4},
                     [](int i, int j, int k) { return i == 4 && j == 2 && k == 1 ? 0.0 : 3.0; });
  write_stack<float>(folder, "ny", {6, 6, 4}, [](int, int, int) { return 0.0; });
  folder.write("deck.yaml", deck("gel.mhd", "[1, 1, 1]", "[2, 2, 2]", collagen, from_images, 'y'));
  const Outcome components = run_stroma(folder.path(), "check deck.yaml", 2);
  EXPECT_EQ(components.status, 2);
  EXPECT_NE(
      components.standard_error.find("Materials|gel|Fibers|collagen: there is no direction at "
                                     "voxel (4, 2, 1): all three components are 0"),
      std::string::npos)
      << components.standard_error;
  // an image without anything to see
  folder.write("deck.yaml", deck("gel.mhd", "[1, 1, 1]", "[2, 2, 2]", collagen,
                                 "          Direction From: Structure Tensor\n"
                                 "          Gradient Scale [um]: 1\n"
                                 "          Window Scale [um]: 1\n",
                                 'y'));
  const Outcome constant = run_stroma(folder.path(), "check deck.yaml");
  EXPECT_EQ(constant.status, 2);
  EXPECT_NE(constant.standard_error.find("the image is constant around it"), std::string::npos)
      << constant.standard_error;
}

}  // namespace
}  // namespace stroma::test
