// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Numbers of any law by the intensity of an image, from the deck to the files, as a user runs it.
/// Claims V-FIELD-4, V-FIELD-5, docs/verification.md.

#include <cmath>

#include "support/ExodusReader.hpp"
#include "support/WriteStack.hpp"

namespace stroma::test {
namespace {

constexpr std::array<int, 3> size{12, 16, 8};
/// A bar of 200, and 40 beside it.
int bar(int i, int /*j*/, int k) { return i >= 3 && i < 9 && k >= 2 && k < 6 ? 200 : 40; }

/// A material without label and indentation; "@" stands where a number varies.
struct Varying {
  std::string parameter, low, high;
  std::string material;
};

std::string with(std::string text, const std::string& number) {
  return text.replace(text.find('@'), 1, number);
}

const std::string mooney_rivlin = R"(
      Model: Mooney-Rivlin
      C1 [Pa]: 200
      C2 [Pa]: 60.4
      Poisson Ratio: 0.4
)";

const std::vector<Varying> varying{
    {"C1 [Pa]", "200", "417.3", R"(
      Model: Mooney-Rivlin
      C1 [Pa]: @
      C2 [Pa]: 60.4
      Poisson Ratio: 0.4
)"},
    {"Poisson Ratio", "0.3", "0.45", R"(
      Model: Mooney-Rivlin
      C1 [Pa]: 200
      C2 [Pa]: 60.4
      Poisson Ratio: @
)"},
    {"C [Pa]|2", "120.1", "311.7", R"(
      Model: Ogden
      C [Pa]: [700, @]
      M: [2, 6]
      Poisson Ratio: 0.4
)"},
    {"Fibers|collagen|Xi [Pa]", "100", "733.1", mooney_rivlin + R"(      Fibers:
        collagen:
          Law: Exponential-Power
          Xi [Pa]: @
          Alpha: 2
          Beta: 2.5
          Direction: [1, 3, 1]
)"},
    {"Fibers|collagen|D0", "0.3", "0.7", mooney_rivlin + R"(      Fibers:
        collagen:
          Law: Buckling-Stiffening
          K [Pa]: 144.9
          D0: @
          Lambda S: 0.032
          DS: 0.055
          Distribution: Spherical
          Quadrature: 4
)"},
    {"Viscosity|Moduli|1", "0.6", "1.3", mooney_rivlin + R"(      Viscosity:
        Moduli: [@, 0.3]
        Relaxation Times [s]: [0.5, 5]
)"},
    {"Active Stress|T0 [Pa]", "10", "120.7", mooney_rivlin + R"(      Active Stress:
        T0 [Pa]: @
)"},
    {"Growth|Ratio", "1.05", "1.31", mooney_rivlin + R"(      Growth:
        Ratio: @
)"}};

/// \param image  the section
std::string deck(const std::string& image, const std::string& materials) {
  return "Stroma:\n  Image:\n" + image + "  Materials:\n" + materials + R"(  Grid:
    Element Size [um]: [2.1, 2.1, 2.0]
  Boundary Conditions:
    bottom:
      Face: y-
      Components: xyz
    top:
      Face: y+
      Components: xyz
      Displacement [um]: [0.6, 1.3, 0.4]
  Loading:
    Duration [s]: 1
    Steps: 2
  Output:
    Pictures: false
)";
}

std::string thresholded(int threshold) {
  return R"(    File: gel.mhd
    Voxel Size [um]: [1.05, 1.05, 1.0]
    Segmentation:
      Method: Threshold
      Threshold: )" +
         std::to_string(threshold) + "\n";
}

std::string material(const std::string& name, int label, const std::string& text) {
  return "    " + name + ":\n      Label: " + std::to_string(label) + text;
}

/// \param source  of the field, lines of the deck or empty
std::string field(const Varying& number, const std::string& source = "") {
  return with(number.material, number.low) +
         "      Fields:\n        one:\n          Parameter: " + number.parameter + "\n" + source +
         "          Intensities: [40, 200]\n          Values: [" + number.low + ", " + number.high +
         "]\n";
}

std::string two_materials(const Varying& number) {
  return material("gel", 0, with(number.material, number.low)) +
         material("bar", 1, with(number.material, number.high));
}

void expect_same_bits(const History& one, const History& other) {
  for (const char* column : {"strain_energy", "bottom.reaction_x", "bottom.reaction_y",
                             "top.reaction_x", "top.reaction_y", "top.reaction_z"})
    for (std::size_t step = 0; step < 3; ++step)
      EXPECT_EQ(one[column].at(step), other[column].at(step)) << column << " " << step;
}

// V-FIELD-4. A law with a number by intensity, and two materials with the two numbers: the same
// bits.
TEST(NumbersFromImage, AreTwoMaterials) {
  const TemporaryFolder folder;
  write_stack<std::uint8_t>(folder, "gel", size, bar);
  for (const Varying& number : varying) {
    SCOPED_TRACE(number.parameter);
    const History field_run =
        run_deck(folder, "field", deck(thresholded(1000), material("gel", 0, field(number))));
    expect_same_bits(field_run,
                     run_deck(folder, "labels", deck(thresholded(100), two_materials(number))));
    EXPECT_NE(field_run["top.reaction_y"].at(2), 0.0);
  }
}

// V-FIELD-5. The intensities of another file, beside an image of labels, and on two ranks.
TEST(NumbersFromImage, MayComeFromAnotherImage) {
  const TemporaryFolder folder;
  write_stack<std::uint8_t>(folder, "gel", size, bar);
  write_stack<std::uint8_t>(folder, "labels", size, [](int, int, int) { return 7; });
  const std::string of_labels = R"(    File: labels.mhd
    Voxel Size [um]: [1.05, 1.05, 1.0]
    Segmentation:
      Method: Labels
)";
  const std::string expected = deck(thresholded(100), two_materials(varying[3]));
  for (const int ranks : {1, 2})
    expect_same_bits(
        run_deck(
            folder, "other",
            deck(of_labels, material("gel", 7, field(varying[3], "          Image: gel.mhd\n"))),
            ranks),
        run_deck(folder, "expected", expected, ranks));
}

TEST(NumbersFromImage, AreShownAndChecked) {
  const TemporaryFolder folder;
  write_stack<std::uint8_t>(folder, "gel", size, bar);
  run_deck(folder, "field", deck(thresholded(1000), material("gel", 0, field(varying[3]))));
  const ExodusReader file(folder.path() / "field" / "particles.e");
  const auto xi =
      file.variable(file.steps(), EX_ELEM_BLOCK, "collagen_xi", 1, file.counts.num_elem);
  const auto at = file.coordinates();
  for (std::size_t p = 0; p < xi.size(); ++p)
    EXPECT_EQ(xi[p], bar(static_cast<int>(at[0][p] / 1.05), 0, static_cast<int>(at[2][p])) == 200
                         ? 733.1
                         : 100.0);

  const Outcome outcome = run_stroma(folder.path(), "check field.yaml");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(
      outcome.standard_output.find("gel|one, Fibers|collagen|Xi [Pa]: 100 to 733.1, mean 258.3"),
      std::string::npos)
      << outcome.standard_output;
  EXPECT_EQ(outcome.standard_output.find("beyond the Intensities"), std::string::npos);

  folder.write("clipped.yaml", deck(thresholded(1000), material("gel", 0, [] {
                                      std::string text = field(varying[3]);
                                      return text.replace(text.find("[40, 200]"), 9, "[50, 200]");
                                    }())));
  const Outcome clipped = run_stroma(folder.path(), "check clipped.yaml");
  EXPECT_NE(clipped.standard_output.find("in 75 % of the material the intensity lies beyond"),
            std::string::npos)
      << clipped.standard_output;
}

}  // namespace
}  // namespace stroma::test
