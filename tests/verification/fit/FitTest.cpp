// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// `stroma fit` as a user runs it (V-FIT-1, V-FIT-2, V-FIT-2B, V-FIT-4): it finds the number by which a force was
/// made, its derivatives are those of the runs, and wrong decks run nothing.

#include <gtest/gtest.h>

#include <cmath>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

/// A slice of 64 x 64 pixels with vessels, on elements of 4 x 4.
const char* const slice = R"(Stroma:
  Image:
    Phantom:
      Kind: Vessels
      Size: [64, 64, 1]
      Voxel Size [um]: [1.05, 1.05, 1.0]
      Volume Fraction: 0.194
      Seed: 25
  Materials:
    collagen: {Label: 0, "Shear Modulus [Pa]": 520.8, "Bulk Modulus [Pa]": 1041.6}
    vessel: {Label: 1, "Shear Modulus [Pa]": 1041.6, "Bulk Modulus [Pa]": 2083.2}
  Grid:
    Element Size [um]: [4.2, 4.2, 1.0]
    Plane Strain: true
  Boundary Conditions:
    bottom: {Face: y-, Components: y}
    top: {Face: y+, Components: y, Strain: 0.10}
  Loading:
    Steps: 4
  Output:
    Pictures: false
    Report: false
    Particles Every: 0
    Grid Every: 0
)";

/// A block of fibres in a gel that is nearly incompressible: mean dilatation, clamped grips.
const char* const block = R"(Stroma:
  Image:
    Phantom:
      Kind: Uniform
      Size: [6, 6, 6]
      Voxel Size [um]: [1.0, 1.0, 1.0]
  Materials:
    gel:
      Label: 0
      Model: Mooney-Rivlin
      C1 [Pa]: 200
      C2 [Pa]: 60
      Poisson Ratio: 0.48
      Fibers:
        collagen:
          Law: Exponential-Power
          Xi [Pa]: 300
          Alpha: 2
          Beta: 2.5
          Direction: [1, 3, 1]
  Grid:
    Element Size [um]: [2.0, 2.0, 2.0]
  Boundary Conditions:
    bottom: {Face: y-, Components: xyz}
    top: {Face: y+, Components: xyz, Strain: 0.15}
  Loading:
    Steps: 4
  Solver:
    Newton Tolerance: 1e-12
  Output:
    Pictures: false
    Report: false
    Particles Every: 0
    Grid Every: 0
)";

std::string number(const std::string& name, const std::string& path, const std::string& rest) {
  return "    " + name + ": {Path: \"" + path + "\", " + rest + "}\n";
}

std::string fit_of(const std::string& deck, const std::string& numbers,
                   const std::string& measurement = "Component: y", const std::string& more = "") {
  return "Fit:\n  Base Deck: " + deck + "\n  Parameters:\n" + numbers +
         "  Measurements:\n    pull: {File: force.csv, Abscissa Column: strain, Force Column: "
         "force, Condition: top, Relative Error: 0.01, " +
         measurement + "}\n" + more;
}

const std::string vessel = "Materials|vessel|Shear Modulus [Pa]";

/// force.csv from a run's history.
void write_forces(const TemporaryFolder& folder, const History& history, double strain) {
  std::string table = "strain,force\n";
  for (std::size_t s = 1; s < history.rows(); ++s) {
    char row[80];
    std::snprintf(row, sizeof row, "%.17g,%.17g\n", strain * history["load"][s],
                  history["top.reaction_y"][s]);
    table += row;
  }
  folder.write("force.csv", table);
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++n;
  return n;
}

/// The field of estimates.csv's first row.
double estimate_of(const TemporaryFolder& folder, const std::string& fit, int field) {
  std::ifstream file(folder.path() / fit / "estimates.csv");
  std::string line, text;
  std::getline(file, line);
  std::getline(file, line);
  std::stringstream row(line);
  for (int i = 0; i <= field; ++i) std::getline(row, text, ',');
  return std::stod(text);
}

void expect_that_it_finds_the_vessels(int ranks, const std::string& more, std::size_t most_runs) {
  const TemporaryFolder folder;
  write_forces(folder, run_deck(folder, "slice", slice), 0.10);
  folder.write(
      "fit.yaml",
      fit_of("slice.yaml", number("vessel", vessel, "Start: 600, Lower: 1, Logarithmic: true"),
             "Component: y", more));
  const Outcome outcome = run_stroma(folder.path(), "fit fit.yaml", ranks);
  ASSERT_EQ(outcome.status, 0) << outcome.standard_output << outcome.standard_error;
  EXPECT_NEAR(estimate_of(folder, "fit", 2), 1041.6, 1e-4 * 1041.6) << outcome.standard_output;
  EXPECT_LT(count(outcome.standard_output, "chi^2"), most_runs + 1) << outcome.standard_output;
  EXPECT_EQ(content_of(folder.path() / "fit" / "fit.png").rfind("\x89PNG", 0), 0u);

  const Outcome again = run_stroma(folder.path(), "fit fit.yaml", ranks);
  EXPECT_EQ(again.status, 0) << again.standard_error;
  EXPECT_NE(again.standard_output.find(" 0 of them new"), std::string::npos)
      << again.standard_output;
}

TEST(Fit, FindsTheModulusOfTheVessels) { expect_that_it_finds_the_vessels(1, "", 9); }
TEST(Fit, FindsItOnTwoRanks) { expect_that_it_finds_the_vessels(2, "", 9); }
TEST(Fit, FindsItByDifferences) {
  expect_that_it_finds_the_vessels(1, "  Gradient: Differences\n", 9);
}

// A run of one moving end, fitted by runs of two, each of which moves half the way.
TEST(Fit, StrainIsThatBetweenBothFaces) {
  const TemporaryFolder folder;
  write_forces(folder, run_deck(folder, "slice", slice), 0.10);
  std::string both = slice;
  const auto put = [&](const std::string& old, const std::string& text) {
    both.replace(both.find(old), old.size(), text);
  };
  put("Components: y}", "Components: y, Strain: 0.07}");
  put("Strain: 0.10", "Strain: 0.03");
  folder.write("both.yaml", both);
  folder.write("fit.yaml", fit_of("both.yaml", number("vessel", vessel, "Start: 600, Lower: 1")));
  const Outcome outcome = run_stroma(folder.path(), "fit fit.yaml");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_output << outcome.standard_error;
  EXPECT_NEAR(estimate_of(folder, "fit", 2), 1041.6, 1e-4 * 1041.6) << outcome.standard_output;

  put("Strain: 0.07", "'Displacement [um]': [0, -4.7, 0]");
  folder.write("both.yaml", both);
  const Outcome unknown = run_stroma(folder.path(), "fit fit.yaml -o unknown");
  EXPECT_EQ(unknown.status, 2) << unknown.standard_output;
  EXPECT_NE(unknown.standard_error.find("or the opposite face moves by other values"),
            std::string::npos)
      << unknown.standard_error;
}

/// Its force was made with 1041.6 Pa, and 1 % of noise.
TEST(Fit, ExampleTellsTheModulus) {
  const TemporaryFolder folder;
  const fs::path deck = clone_folder() / "input_decks" / "14_fit_vessel_modulus" / "fit.yaml";
  const Outcome outcome = run_stroma(folder.path(), "fit " + quoted(deck) + " -o fit");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_output << outcome.standard_error;
  EXPECT_NEAR(estimate_of(folder, "fit", 2), 1024.09, 0.05);
  EXPECT_NEAR(estimate_of(folder, "fit", 4), 962.93, 0.1);
  EXPECT_NEAR(estimate_of(folder, "fit", 5), 1089.14, 0.1);
}

/// dR/dp of sensitivity.csv against central differences of runs, whose error h^2 is extrapolated away.
TEST(Fit, AdjointIsTheDerivativeOfTheRuns) {
  const TemporaryFolder folder;
  const struct {
    std::string name, deck;
    double strain;
    std::vector<std::pair<std::string, double>> numbers;
  } cases[] = {{"slice",
                std::string(slice) + "  Solver: {Newton Tolerance: 1e-12}\n",
                0.10,
                {{vessel, 1041.6}, {"Materials|collagen|Bulk Modulus [Pa]", 1041.6}}},
               {"block",
                block,
                0.15,
                {{"Materials|gel|C2 [Pa]", 60.0},
                 {"Materials|gel|Poisson Ratio", 0.48},
                 {"Materials|gel|Fibers|collagen|Xi [Pa]", 300.0},
                 {"Materials|gel|Fibers|collagen|Beta", 2.5}}}};
  for (const auto& one : cases) {
    const History history = run_deck(folder, one.name, one.deck);
    write_forces(folder, history, one.strain);
    std::string numbers;
    for (std::size_t j = 0; j < one.numbers.size(); ++j)
      numbers += number("p" + std::to_string(j), one.numbers[j].first,
                        "Start: " + std::to_string(one.numbers[j].second));
    folder.write(one.name + "_fit.yaml", fit_of(one.name + ".yaml", numbers));
    for (const int ranks : {1, 2}) {
      const Outcome outcome = run_stroma(
          folder.path(), "fit " + one.name + "_fit.yaml -o fit" + std::to_string(ranks) + one.name,
          ranks);
      ASSERT_EQ(outcome.status, 0) << outcome.standard_output << outcome.standard_error;
    }
    const auto first_run = [&](const std::string& fit) {
      std::ifstream file(folder.path() / fit / "fit.csv");
      std::string line;
      std::getline(file, line);
      std::getline(file, line);
      const std::size_t comma = line.find(',');
      return History(folder.path() / fit /
                     line.substr(comma + 1, line.find(',', comma + 1) - comma - 1) /
                     "sensitivity.csv");
    };
    const History adjoint = first_run("fit1" + one.name), on_two = first_run("fit2" + one.name);
    for (const auto& [path, value] : one.numbers) {
      const std::string column = "top.reaction_y by " + path;
      const auto force = [&, &path = path](double p) {
        char text[64];
        std::snprintf(text, sizeof text, "=%.17g", p);
        const Outcome outcome =
            run_stroma(folder.path(),
                       "run " + one.name + ".yaml -o beside --quiet --set '" + path + text + "'");
        EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
        return History(folder.path() / "beside" / "history.csv")["top.reaction_y"];
      };
      // The force of a nearly incompressible body turns within 0.5 - nu.
      const double h = (path.find("Poisson") == std::string::npos ? 2e-2 : 1e-3) * value;
      const auto above = force(value + h), below = force(value - h);
      const auto near_above = force(value + 0.5 * h), near_below = force(value - 0.5 * h);
      ASSERT_EQ(adjoint.rows() + 1, history.rows());
      for (std::size_t s = 0; s < adjoint.rows(); ++s) {
        const double wide = (above[s + 1] - below[s + 1]) / (2.0 * h);
        const double narrow = (near_above[s + 1] - near_below[s + 1]) / h;
        const double exact = (4.0 * narrow - wide) / 3.0;
        EXPECT_NEAR(adjoint[column][s] / exact, 1.0, 1e-6) << path << ", step " << s + 1;
        EXPECT_NEAR(on_two[column][s] / exact, 1.0, 1e-6) << path << ", step " << s + 1;
      }
    }
  }
}

/// One curve that is nearly straight cannot tell three moduli.
TEST(Fit, SaysWhatTheMeasurementsDoNotTell) {
  const TemporaryFolder folder;
  write_forces(folder, run_deck(folder, "slice", slice), 0.10);
  folder.write(
      "fit.yaml",
      fit_of("slice.yaml",
             number("vessel", vessel, "Start: 1000") +
                 number("collagen", "Materials|collagen|Shear Modulus [Pa]", "Start: 530") +
                 number("bulk", "Materials|vessel|Bulk Modulus [Pa]", "Start: 2000")));
  const Outcome outcome = run_stroma(folder.path(), "fit fit.yaml");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_output << outcome.standard_error;
  EXPECT_NE(outcome.standard_output.find("do not determine this combination"), std::string::npos)
      << outcome.standard_output;
}

/// A bar that swings: each step rests on those before it, which the adjoint of one step knows nothing of.
const char* const swinging = R"(Stroma:
  Image:
    Phantom: {Kind: Uniform, Size: [2, 4, 2], "Voxel Size [um]": [1.0, 1.0, 1.0]}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 550.0, Poisson Ratio: 0.3, "Density [kg/m^3]": 1000}
  Grid: {"Element Size [um]": [1.0, 1.0, 1.0]}
  Boundary Conditions:
    bottom: {Face: y-, Components: xyz, "Displacement [um]": [0, 0, 0]}
  Initial Conditions:
    pulled: {"Velocity Gradient [1/s]": [0, 0, 0, 0, 5000, 0, 0, 0, 0], "Center [um]": [0, 0, 0]}
  Loading: {Steps: 12, "Duration [s]": 2.4e-5, Inertia: true}
  Solver: {Newton Tolerance: 1.0e-12, Linear Tolerance: 1.0e-8}
  Output: {Pictures: false, Report: false, Particles Every: 0, Grid Every: 0}
)";

TEST(Fit, OfABodyInMotionGoesByDifferences) {
  const TemporaryFolder folder;
  const History truth = run_deck(folder, "swinging", swinging);
  std::string table = "time,force\n";
  for (std::size_t n = 1; n < truth.rows(); ++n) {
    char line[80];
    std::snprintf(line, sizeof line, "%.17g,%.17g\n", truth["time"][n],
                  truth["bottom.reaction_y"][n]);
    table += line;
  }
  folder.write("force.csv", table);
  const auto fit = [&](const std::string& gradient) {
    folder.write("fit.yaml",
                 "Fit:\n  Base Deck: swinging.yaml\n" + gradient + "  Parameters:\n" +
                     number("gel", "Materials|gel|Shear Modulus [Pa]", "Start: 500") +
                     "  Measurements:\n    m: {File: force.csv, Condition: bottom, Component: y, "
                     "Against: Time, Abscissa Column: time, Force Column: force, Error: 1}\n");
    return run_stroma(folder.path(), "fit fit.yaml");
  };
  const Outcome refused = fit("  Gradient: Adjoint\n");
  EXPECT_EQ(refused.status, 2) << refused.standard_output;
  EXPECT_NE(refused.standard_error.find("with Loading|Inertia, a step rests on those before it"),
            std::string::npos)
      << refused.standard_error;
  const Outcome found = fit("");
  ASSERT_EQ(found.status, 0) << found.standard_output << found.standard_error;
  EXPECT_NEAR(estimate_of(folder, "fit", 2), 550.0, 1e-2) << found.standard_output;
}

TEST(BadFits, RunNothing) {
  const TemporaryFolder folder;
  folder.write("slice.yaml", slice);
  folder.write("force.csv", "strain,force\n0.05,10000\n0.1,20000\n");
  folder.write("far.csv", "strain,force\n0.05,10000\n0.2,20000\n");
  const std::string start = number("vessel", vessel, "Start: 600");
  const struct {
    std::string deck, message;
  } cases[] = {
      {fit_of("none.yaml", start), "there is no file"},
      {fit_of("slice.yaml", number("v", "Materials|vesel|Shear Modulus [Pa]", "Start: 600")),
       "vesel"},
      {fit_of("slice.yaml", number("v", vessel, "Start: -5")), "a number > 0"},
      {fit_of("slice.yaml", number("v", vessel, "Start: 600, Lower: 700")), "from Lower to Upper"},
      {fit_of("slice.yaml", number("v", vessel, "Start: 600, Lower: 700, Upper: 500")),
       "above Lower"},
      {fit_of("slice.yaml", number("v", vessel, "Start: 600, Lower: 0, Logarithmic: true")),
       "both > 0"},
      {fit_of("slice.yaml", start + number("w", vessel, "Start: 700")), "the same parameter"},
      {fit_of("slice.yaml", start, "Component: x"), "the support bears no force along x"},
      {fit_of("slice.yaml", start, "Component: y, Against: Tame"), "Against"},
      {fit_of("slice.yaml", start, "Component: y, Error Column: sd"), "has no column \"sd\""},
      {fit_of("slice.yaml", start, "Component: y, Error: 0"), "Error"},
      {fit_of("slice.yaml", start, "Component: y, Relative Error: 0.02"), "twice"},
      {fit_of("slice.yaml", number("v", "Grid|Element Size [um]", "Start: 2")), "Element Size"},
      {fit_of("slice.yaml", number("t", "Boundary Conditions|top|Strain", "Start: 0.1"),
              "Component: y", "  Gradient: Adjoint\n"),
       "is no number of a law"},
      {fit_of("slice.yaml", start +
                                number("a", "Materials|vessel|Bulk Modulus [Pa]", "Start: 2000") +
                                number("b", "Materials|collagen|Bulk Modulus [Pa]", "Start: 2000")),
       "2 forces for 3 numbers"},
      {"Fit:\n  Base Deck: slice.yaml\n", "missing"},
  };
  for (const auto& one : cases) {
    folder.write("fit.yaml", one.deck);
    const Outcome outcome = run_stroma(folder.path(), "fit fit.yaml");
    EXPECT_EQ(outcome.status, 2) << one.deck << outcome.standard_error;
    EXPECT_NE(outcome.standard_error.find(one.message), std::string::npos)
        << one.deck << outcome.standard_error;
    EXPECT_FALSE(fs::exists(folder.path() / "fit")) << one.deck;
  }
  std::string far = fit_of("slice.yaml", start);
  far.replace(far.find("force.csv"), 9, "far.csv");
  folder.write("fit.yaml", far);
  const Outcome outcome = run_stroma(folder.path(), "fit fit.yaml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.standard_error.find("does not come to strain 0.2"), std::string::npos)
      << outcome.standard_error;
}

}  // namespace
}  // namespace stroma::test
