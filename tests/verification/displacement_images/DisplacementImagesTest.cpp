// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Faces that move as images of displacements say. Claims V-DVC-1 and V-DVC-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support/ExodusReader.hpp"
#include "support/Program.hpp"
#include "support/WriteStack.hpp"

namespace stroma::test {
namespace {

using Vector = std::array<double, 3>;

/// A block of gel of 8 x 8 x 8 um; `conditions` and further sections by two spaces.
std::string deck(const std::string& conditions, const std::string& grid = "Elements: [4, 4, 4]") {
  return "Stroma:\n"
         "  Image: {Phantom: {Kind: Uniform, Size: [8, 8, 8], 'Voxel Size [um]': [1, 1, 1]}}\n"
         "  Materials:\n"
         "    gel: {Label: 0, 'Shear Modulus [Pa]': 520.8, Poisson Ratio: 0.4}\n"
         "  Grid: {" +
         grid +
         "}\n"
         "  Loading: {Steps: 2}\n"
         "  Solver: {Newton Tolerance: 1e-13}\n"
         "  Output: {Pictures: false, Report: false}\n"
         "  Boundary Conditions:\n" +
         conditions;
}

class DisplacementImages : public ::testing::Test {
 protected:
  Outcome stroma(const std::string& text, const std::string& out, int ranks = 1) {
    std::ofstream(folder_ / (out + ".yaml")) << text;
    return run_stroma(folder_.path(), "run " + out + ".yaml --quiet -o " + out, ranks);
  }
  History run(const std::string& text, const std::string& out, int ranks = 1) {
    const Outcome outcome = stroma(text, out, ranks);
    EXPECT_EQ(outcome.status, 0) << text << outcome.standard_error;
    return History(folder_.path() / out / "history.csv");
  }
  /// Writes u_x.mhd, u_y.mhd, u_z.mhd: a displacement of X at centres of voxels.
  template <class Displacement>
  void write_images(const std::array<int, 3>& size, const Vector& voxel, const Vector& corner,
                    const Displacement& u) {
    for (std::size_t c = 0; c < 3; ++c)
      write_stack<double>(folder_, std::string("u_") + "xyz"[c], size, [&](int i, int j, int k) {
        return u(Vector{corner[0] + (i + 0.5) * voxel[0], corner[1] + (j + 0.5) * voxel[1],
                        corner[2] + (k + 0.5) * voxel[2]})[c];
      });
  }
  TemporaryFolder folder_;
};

constexpr double gradient[3][3] = {{0.05, 0.2, -0.03}, {0.01, -0.1, 0.04}, {0.02, 0.07, 0.08}};
const std::string gradient_in_deck = "[0.05, 0.2, -0.03, 0.01, -0.1, 0.04, 0.02, 0.07, 0.08]";

Vector linear(const Vector& X) {
  Vector u{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) u[i] += gradient[i][j] * X[j];
  return u;
}

/// Both tables have the same energy, volume and stress, to a share of the largest. (The force on all
/// faces together is nothing but rounding.)
void expect_same(const History& found, const History& expected, double tolerance) {
  for (const std::string& name : expected.names()) {
    if (name != "strain_energy" && name.find("gel.") != 0) continue;
    double largest = 0.0;
    for (const double value : expected[name]) largest = std::max(largest, std::abs(value));
    for (std::size_t s = 0; s < expected.rows(); ++s)
      EXPECT_NEAR(found[name][s], expected[name][s], tolerance * largest) << name << " " << s;
  }
}

// V-DVC-1. A linear displacement on all faces, by images of the specimen's voxels, and by coarser
// ones that begin elsewhere: the homogeneous state, at nodes, by grips and by springs, on each number
// of ranks.
TEST_F(DisplacementImages, ALinearFieldMakesAHomogeneousState) {
  const std::string in_both = "    all: {Face: all, Components: xyz, ";
  for (const std::string way : {"Imposed By: Nodes", "Imposed By: Grip", "Imposed By: Penalty"}) {
    SCOPED_TRACE(way);
    const History expected = run(
        deck(in_both + way + ", Displacement Gradient: " + gradient_in_deck + "}\n"), "expected");
    write_images({8, 8, 8}, {1, 1, 1}, {0, 0, 0}, linear);
    for (const int ranks : {1, 2, 4})
      expect_same(run(deck(in_both + way +
                           ", Displacement Images: {Images: [u_x.mhd, u_y.mhd, u_z.mhd], "
                           "'Voxel Size [um]': [1, 1, 1]}}\n"),
                      "found", ranks),
                  expected, 1e-12);
    write_images({5, 4, 6}, {2, 3, 2.5}, {-1, -2, -4}, linear);
    expect_same(run(deck(in_both + way +
                         ", Displacement Images: {Images: [u_x.mhd, u_y.mhd, u_z.mhd], 'Voxel Size "
                         "[um]': [2, 3, 2.5], 'Corner [um]': [-1, -2, -4]}}\n"),
                    "coarse", 2),
                expected, 1e-12);
  }
}

// Wider functions touch nodes beside the body; on a grid that is reset particles change their rank,
// and faces leave the nodes.
TEST_F(DisplacementImages, ALinearFieldUnderWiderFunctions) {
  write_images({8, 8, 8}, {1, 1, 1}, {0, 0, 0}, linear);
  for (const std::string functions :
       {"GIMP", "Quadratic B-Spline", "GIMP, Reset: true", "Linear, Reset: true"}) {
    SCOPED_TRACE(functions);
    const std::string all =
        "    all: {Face: all, Components: xyz, Imposed By: Penalty, Penalty Factor: 2e4, ";
    const std::string grid = "Elements: [4, 4, 4], Shape Functions: " + functions;
    const History expected =
        run(deck(all + "Displacement Gradient: " + gradient_in_deck + "}\n", grid), "expected");
    expect_same(run(deck(all + "Displacement Images: {Images: [u_x.mhd, u_y.mhd, u_z.mhd], 'Voxel "
                               "Size [um]': [1, 1, 1]}}\n",
                         grid),
                    "found", 2),
                expected, functions.find("Reset") == std::string::npos ? 1e-12 : 1e-10);
  }
}

// Images follow a load curve, and only the components that are prescribed are read.
TEST_F(DisplacementImages, FollowALoadCurve) {
  write_images({8, 8, 8}, {1, 1, 1}, {0, 0, 0}, [](const Vector& X) {
    return Vector{0.0, 0.1 * X[1] + 0.01 * X[0] * X[1], 0.0};
  });
  const std::string conditions =
      "    bottom: {Face: y-, Components: xyz}\n"
      "    top: {Face: y+, Components: y, Load Curve: back, Displacement Images: {Images: [no.mhd, "
      "u_y.mhd, no.mhd], 'Voxel Size [um]': [1, 1, 1]}}\n";
  const History history = run(
      deck(conditions) + "  Load Curves: {back: {'Times [s]': [0, 0.5, 1], Values: [0, 1, 0]}}\n",
      "back");
  EXPECT_GT(history["top.reaction_y"][1], 0.0);
  EXPECT_NEAR(history["strain_energy"][2], 0.0, 1e-12 * history["strain_energy"][1]);
}

using Displacements = std::map<std::array<long, 3>, Vector>;

/// Displacements of the particles at the last step by where they were, in 1/1000 um.
Displacements displacements(const fs::path& file) {
  const ExodusReader particles(file.string());
  const auto x = particles.coordinates();
  std::array<std::vector<double>, 3> u;
  for (std::size_t c = 0; c < 3; ++c)
    u[c] = particles.variable(particles.steps(), EX_NODAL, std::string("displacement_") + "xyz"[c],
                              1, particles.counts.num_nodes);
  Displacements found;
  for (std::size_t p = 0; p < x[0].size(); ++p)
    found[{std::lround(1e3 * x[0][p]), std::lround(1e3 * x[1][p]), std::lround(1e3 * x[2][p])}] = {
        u[0][p], u[1][p], u[2][p]};
  return found;
}

// V-DVC-2. A run's own displacement, on the voxels of its image, moves the faces of a region of it:
// the interior follows, up to the error of interpolating between voxels, which is of second order.
TEST_F(DisplacementImages, OfARunReproduceItsInterior) {
  double last = 1.0;
  for (const int n : {16, 32}) {
    const std::string all = std::to_string(n), elements = std::to_string(n / 2),
                      voxel = std::to_string(16.0 / n), first = std::to_string(n / 4),
                      count = std::to_string(n / 2), inner = std::to_string(n / 4);
    const auto text = [&](const std::string& region, const std::string& count_of_elements,
                          const std::string& rest) {
      return "Stroma:\n  Image: {Phantom: {Kind: Uniform, Size: [" + all + ", " + all + ", " + all +
             "], 'Voxel Size [um]': [" + voxel + ", " + voxel + ", " + voxel + "]}" + region +
             "}\n  Materials:\n"
             "    gel: {Label: 0, 'Shear Modulus [Pa]': 520.8, Poisson Ratio: 0.4}\n"
             "  Grid: {Elements: [" +
             count_of_elements + ", " + count_of_elements + ", " + count_of_elements +
             "]}\n  Loading: {Steps: 1}\n  Solver: {Newton Tolerance: 1e-10}\n" + rest;
    };
    run(text("", elements,
             "  Rig: {Kind: Clamped Extension, Face: y+, Strain: 0.1}\n"
             "  Output: {Pictures: false, Report: false, Image Stacks: {Quantities: [von_mises, "
             "displacement_x, displacement_y, displacement_z]}}\n"),
        "whole");
    run(text(", Region: [" + first + ", " + first + ", " + first + ", " + count + ", " + count +
                 ", " + count + "]",
             inner,
             "  Boundary Conditions: {all: {Face: all, Components: xyz, Displacement Images: "
             "{Images: [whole/image_undeformed.ome.tif], Channels: [1, 2, 3]}}}\n"
             "  Output: {Pictures: false, Report: false}\n"),
        "inner");
    const Displacements whole = displacements(folder_ / "whole" / "particles.e"),
                        part = displacements(folder_ / "inner" / "particles.e");
    ASSERT_EQ(part.size(), static_cast<std::size_t>(n * n * n / 8));
    double error = 0.0;
    for (const auto& [X, u] : part) {
      const Vector& expected = whole.at(X);
      for (std::size_t c = 0; c < 3; ++c) error = std::max(error, std::abs(u[c] - expected[c]));
    }
    EXPECT_LT(error, last / 3.0);
    last = error;
  }
  EXPECT_LT(last, 1e-3 * 1.6);
}

// A run goes on with the images that it had, and with no others.
TEST_F(DisplacementImages, MustBeTheSameWhenARunGoesOn) {
  const auto pull = [](const Vector& X) { return Vector{0.0, 0.1 * X[1], 0.0}; };
  write_images({8, 8, 8}, {1, 1, 1}, {0, 0, 0}, pull);
  run(deck("    bottom: {Face: y-, Components: xyz}\n"
           "    top: {Face: y+, Components: xyz, Displacement Images: {Images: [u_x.mhd, u_y.mhd, "
           "u_z.mhd], 'Voxel Size [um]': [1, 1, 1]}}\n"),
      "pulled");
  const std::string again = "run pulled.yaml -o pulled --restart --quiet --set 'Loading|Steps=2'";
  EXPECT_EQ(run_stroma(folder_.path(), again, 2).status, 0);
  EXPECT_EQ(run_stroma(folder_.path(), "verify pulled").status, 0);
  write_images({8, 8, 8}, {1, 1, 1}, {0, 0, 0}, linear);
  const Outcome other = run_stroma(folder_.path(), again);
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.standard_error.find("checksums differ"), std::string::npos)
      << other.standard_error;
  EXPECT_NE(run_stroma(folder_.path(), "verify pulled").status, 0);
}

// What is wrong with images is told before anything is run, in the same words on each number of
// ranks.
TEST_F(DisplacementImages, ThatDoNotFitAreRefused) {
  const auto expect_refused = [&](const std::string& images, const std::string& message,
                                  const std::vector<int>& all_ranks = {1}) {
    for (const int ranks : all_ranks) {
      const Outcome outcome = stroma(
          deck("    top: {Face: y+, Components: xyz, Displacement Images: {" + images + "}}\n"),
          "refused", ranks);
      EXPECT_EQ(outcome.status, 2) << images;
      EXPECT_NE(outcome.standard_error.find("Boundary Conditions|top|Displacement Images"),
                std::string::npos)
          << outcome.standard_error;
      EXPECT_NE(outcome.standard_error.find(message), std::string::npos) << outcome.standard_error;
    }
  };
  const std::string images = "Images: [u_x.mhd, u_y.mhd, u_z.mhd]";
  const std::string of_a_micrometre = images + ", 'Voxel Size [um]': [1, 1, 1]";
  write_images({8, 8, 8}, {1, 1, 1}, {0, 0, 0}, linear);
  expect_refused(images, "Voxel Size [um]: missing");
  expect_refused(images + ", 'Voxel Size [um]': [1, 0.9, 1]",
                 "the images reach from 0 to 7.2 um along y, and the body from 0 to 8 um");
  expect_refused(of_a_micrometre + ", 'Corner [um]': [0, 0, 0.5]",
                 "the images reach from 0.5 to 8.5 um along z");
  expect_refused(of_a_micrometre + ", Channels: [0, 0, 1]", "no channel 1");
  expect_refused("Images: [u_x.mhd, u_y.mhd, nowhere.mhd], 'Voxel Size [um]': [1, 1, 1]",
                 "nowhere.mhd");
  write_stack<double>(folder_, "u_z", {8, 8, 7}, [](int, int, int) { return 0.0; });
  expect_refused(of_a_micrometre, "has other voxels", {1, 2});
  write_stack<double>(folder_, "u_z", {8, 8, 8},
                      [](int i, int j, int k) { return i == 3 && j == 7 && k == 5 ? NAN : 0.0; });
  expect_refused(of_a_micrometre, "needs voxel (3, 7, 5), which is no finite number", {1, 2});
}

}  // namespace
}  // namespace stroma::test
