// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Figures of FEBio's own test suite (tests/data/reference/laws.md), of unit cubes in a homogeneous
/// state: decks of 1 or 2 x 2 x 2 elements through the program, to the digits that are given. Claims
/// V-FEBIO-1 to V-FEBIO-3, docs/verification.md.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "support/ExodusReader.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

/// A cube of 1 um of one material, on rollers at x-, y- and z-. Its voxels are Gauss points'.
/// \param rest  further sections; conditions beside the rollers may stand first
std::string deck(int elements, const std::string& material, const std::string& rest) {
  const std::string n = std::to_string(elements), voxels = std::to_string(2 * elements),
                    edge = std::to_string(0.5 / elements);
  return "Stroma:\n"
         "  Image:\n"
         "    Phantom:\n"
         "      Kind: Uniform\n"
         "      Size: [" +
         voxels + ", " + voxels + ", " + voxels +
         "]\n"
         "      Voxel Size [um]: [" +
         edge + ", " + edge + ", " + edge +
         "]\n"
         "  Materials:\n"
         "    tissue:\n"
         "      Label: 0\n" +
         material +
         "  Grid:\n"
         "    Elements: [" +
         n + ", " + n + ", " + n +
         "]\n"
         "  Solver: {Newton Tolerance: 1e-12, Preconditioner: Direct}\n"
         "  Output: {Pictures: false, Particles Every: 0}\n"
         "  Boundary Conditions:\n"
         "    left: {Face: x-, Components: x, Imposed By: Nodes}\n"
         "    bottom: {Face: y-, Components: y, Imposed By: Nodes}\n"
         "    back: {Face: z-, Components: z, Imposed By: Nodes}\n" +
         rest;
}

/// Where the nodes were, and how they have moved in the end.
struct Nodes {
  std::array<std::vector<double>, 3> place, moved;
};

Nodes run(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("deck.yaml", text);
  const Outcome outcome = run_stroma(folder.path(), "run deck.yaml --quiet -o out");
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
  const ExodusReader grid((folder.path() / "out" / "grid.e").string());
  Nodes nodes;
  nodes.place = grid.coordinates();
  const char* names[] = {"displacement_x", "displacement_y", "displacement_z"};
  for (std::size_t c = 0; c < 3; ++c)
    nodes.moved[c] = grid.variable(grid.steps(), EX_NODAL, names[c], 1, grid.counts.num_nodes);
  return nodes;
}

/// Stretch along an axis, of the cube's far corner.
double stretch(const Nodes& nodes, std::size_t axis) {
  for (std::size_t n = 0; n < nodes.place[0].size(); ++n)
    if (nodes.place[0][n] > 0.99 && nodes.place[1][n] > 0.99 && nodes.place[2][n] > 0.99)
      return 1.0 + nodes.moved[axis][n];
  ADD_FAILURE() << "no corner";
  return 0.0;
}

/// The 2-norm of nodal displacements, without those of a face whose motion along y is imposed.
double norm_of_free(const Nodes& nodes, bool is_pulled_at_y) {
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t n = 0; n < nodes.place[0].size(); ++n)
      if (!is_pulled_at_y || c != 1 || nodes.place[1][n] < 0.99)
        sum += nodes.moved[c][n] * nodes.moved[c][n];
  return std::sqrt(sum);
}

const std::string coupled =  // Young's modulus 1, Poisson's ratio 0.3
    "      Model: Coupled Neo-Hookean\n"
    "      Shear Modulus [Pa]: 0.38461538461538464\n"
    "      Poisson Ratio: 0.3\n";
const std::string nearly_incompressible =
    "      Model: Mooney-Rivlin\n"
    "      C1 [Pa]: 1\n"
    "      C2 [Pa]: 0\n"
    "      Bulk Modulus [Pa]: ";
const std::string all_around = "      Active Stress: {Kind: Isotropic, 'T0 [Pa]': 0.5}\n";
const std::string along_x =
    "      Active Stress: {Kind: Fiber, 'T0 [Pa]': 0.5, Direction: [1, 0, 0]}\n";

// V-FEBIO-1. Free cubes that contract.
TEST(FebioFigures, OfActiveStress) {
  struct Case {
    const char* name;
    std::string material;
    double along, across;
  };
  const Case cases[] = {
      {"ma20", coupled + all_around, 0.85756517162, 0.85756517162},
      {"ma24", coupled + along_x, 0.72382914741, 1.09774125352},
      {"ma21", nearly_incompressible + "5000\n" + all_around, 0.99996666944, 0.99996666944},
      {"ma25", nearly_incompressible + "1000\n" + along_x, 0.92827925197, 1.03783781834}};
  double worst = 0.0;
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const Nodes nodes = run(deck(1, one.material, "  Loading: {Steps: 5}\n"));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double expected = axis == 0 ? one.along : one.across;
      EXPECT_NEAR(stretch(nodes, axis), expected, 1e-11);
      worst = std::max(worst, std::abs(stretch(nodes, axis) - expected));
    }
  }
  std::printf("  stretches within %.1e\n", worst);
}

// V-FEBIO-2. ma05: a dead traction of 0.002 Pa, held for 99 times the relaxation time. What is left
// is the elastic stretch, l - 1/l = 0.004.
TEST(FebioFigures, OfACubeThatCreeps) {
  const Nodes nodes =
      run(deck(1,
               "      Model: Coupled Neo-Hookean\n"
               "      Shear Modulus [Pa]: 0.5\n"
               "      Poisson Ratio: 0\n"
               "      Viscosity: {Moduli: [0.95], 'Relaxation Times [s]': [0.01]}\n",
               "  External Forces:\n"
               "    pull: {'Traction [Pa]': [0, 0.002, 0], Face: y+, Load Curve: ramp}\n"
               "  Load Curves:\n"
               "    ramp: {'Times [s]': [0, 0.01], Values: [0, 1]}\n"
               "  Loading: {'Duration [s]': 1, Steps: 100}\n"));
  EXPECT_NEAR(stretch(nodes, 1), 1.002002, 5e-7);
  EXPECT_NEAR(norm_of_free(nodes, false), 0.004003999996, 1e-12);
  std::printf("  norm %.12f\n", norm_of_free(nodes, false));
}

// V-FEBIO-3. ma61: Yeoh's solid at a stretch of 3. Of 2 x 2 x 2 elements, free nodes of an
// incompressible cube move by the norm 3.608218; the laws' page gives that and 3.608240.
TEST(FebioFigures, OfYeohsSolid) {
  const Nodes nodes = run(deck(2,
                               "      Model: Yeoh\n"
                               "      C [Pa]: [0.57382, -0.074744, 0.011321]\n"
                               "      Bulk Modulus [Pa]: 1e8\n",
                               "    top: {Face: y+, Components: y, Imposed By: Nodes, Strain: 2}\n"
                               "  Loading: {Steps: 20}\n"));
  EXPECT_NEAR(stretch(nodes, 1), 3.0, 1e-12);
  EXPECT_GT(norm_of_free(nodes, true), 3.6082175);
  EXPECT_LT(norm_of_free(nodes, true), 3.6082405);
  std::printf("  norm %.9f, incompressible %.9f\n", norm_of_free(nodes, true),
              std::sqrt(9.0 + 22.5 * std::pow(1.0 - 1.0 / std::sqrt(3.0), 2)));
}

}  // namespace
}  // namespace stroma::test
