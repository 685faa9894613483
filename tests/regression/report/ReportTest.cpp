// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// report.html of runs and studies, as a browser shows it (browse.py): what it holds against the
/// files beside it, its sliders, its layout; and `stroma report` as a user calls it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "stroma/base/Log.hpp"
#include "stroma/output/files/ParticleReader.hpp"
#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

const fs::path clone = clone_folder();

/// A part of a stack of capillaries, as an image.
std::string capillaries(const std::string& more = "") {
  return "Stroma:\n  Title: Capillaries, <b>&amp;\n  Image:\n    File: " +
         (clone / "tests/data/images/endo_block.tif").string() +
         R"(
    Region: [76, 12, 44, 20, 24, 10]
    Voxel Size [um]: [0.93, 0.93, 0.93]
    Segmentation: {Method: Threshold, Threshold: 128}
  Materials:
    matrix: {Label: 0, "Shear Modulus [Pa]": 520.8, Poisson Ratio: 0.4}
    capillary: {Label: 1, "Shear Modulus [Pa]": 1041.6, Poisson Ratio: 0.4}
  Grid: {Elements: [10, 12, 5]}
  Boundary Conditions:
    bottom: {Face: y-, Components: xyz}
    top: {Face: y+, Components: xyz, Strain: -0.05}
  Loading: {Steps: 3}
)" + more;
}

/// Whether there is a browser, and what drives it.
bool has_browser() {
  static const bool found =
      std::system(
          "command -v chromium >/dev/null && command -v chromedriver >/dev/null && "
          "/usr/bin/python3 -c 'import selenium' 2>/dev/null") == 0;
  return found;
}
#define SKIP_WITHOUT_BROWSER()                                         \
  if (!has_browser())                                                  \
  GTEST_SKIP() << "no Chromium, no chromedriver or no Selenium: bash " \
                  "cmake/install_dependencies.sh test"

/// What browse.py finds wrong.
std::string wrong(const TemporaryFolder& folder, const std::string& arguments) {
  const Outcome outcome =
      run_program("/usr/bin/python3", folder.path(),
                  quoted(clone / "tests/regression/report/browse.py") + " " + arguments, 1, 1);
  return outcome.standard_output + (outcome.status == 0 ? "" : outcome.standard_error + "(failed)");
}

/// "X Y Z VALUE": the place and the value of the largest von Mises stress of the last step.
std::string place_of_most(const fs::path& particles) {
  const output::ParticleReader reader(particles.string());
  std::array<double, 4> most{};
  reader.for_pieces(reader.steps() - 1, {"von_mises"}, [&](const output::ParticlePiece& piece) {
    for (std::size_t p = 0; p < piece.count; ++p)
      if (piece.values[0][p] > most[3])
        most = {piece.position[0][p], piece.position[1][p], piece.position[2][p],
                piece.values[0][p]};
  });
  return base::format("%.17g %.17g %.17g %.17g", most[0], most[1], most[2], most[3]);
}

// V-REPORT
TEST(Report, OfARunShowsWhatItsFilesHold) {
  SKIP_WITHOUT_BROWSER();
  for (const int ranks : {1, 2}) {
    const TemporaryFolder folder;
    run_deck(folder, "run", capillaries(), ranks);
    EXPECT_EQ(wrong(folder, "run run " + place_of_most(folder / "run/particles.e")), "") << ranks;
  }
}

// V-REPORT
TEST(Report, OfAViscousRunIsAgainstTime) {
  SKIP_WITHOUT_BROWSER();
  const TemporaryFolder folder;
  const std::string deck = content_of(clone / "input_decks/10_ramp_and_hold/deck.yaml");
  folder.write("run.yaml", deck);
  const Outcome outcome = run_stroma(
      folder.path(), "run run.yaml -o run --quiet --set 'Loading|Times [s]=[0.5, 1, 5]'");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  EXPECT_EQ(wrong(folder, "run run " + place_of_most(folder / "run/particles.e")), "");
}

/// What browse.py finds wrong with the report of a run of one of the input decks.
std::string wrong_with_deck(const std::string& deck, const std::string& settings) {
  const TemporaryFolder folder;
  const Outcome outcome = run_stroma(
      folder.path(), "run " + quoted(clone / "input_decks" / deck) + " -o run --quiet" + settings);
  return outcome.status == 0 ? wrong(folder, "run run") : outcome.standard_error;
}

// V-REPORT
TEST(Report, OfABodyInMotionShowsItsEnergies) {
  SKIP_WITHOUT_BROWSER();
  EXPECT_EQ(wrong_with_deck("17_swing/deck.yaml",
                            " --set 'Loading|Duration [s]=8e-5' --set 'Loading|Steps=8'"),
            "");
}

// V-REPORT
TEST(Report, OfATurnedFaceShowsItsTorque) {
  SKIP_WITHOUT_BROWSER();
  EXPECT_EQ(wrong_with_deck("15_rigs/torsion.yaml", ""), "");
}

// V-REPORT. The bounds of a body are those of the modulus that its rig asks for, and a shear is one.
TEST(Report, OfARigKnowsWhatItAsksFor) {
  SKIP_WITHOUT_BROWSER();
  struct Case {
    const char *rig, *says;
  };
  for (const Case& one : {Case{"confined_compression",
                               "'for K + 4/3 mu, of a body that cannot widen.' 'between Reuss'"},
                          Case{"unconfined_compression", "\"for Young's E.\" 'between Reuss'"},
                          Case{"biaxial", "'!Bounds: force'"},
                          Case{"simple_shear", "'Force against shear strain'"}}) {
    const TemporaryFolder folder;
    const Outcome outcome = run_stroma(
        folder.path(),
        "run " + quoted(clone / "input_decks/15_rigs" / (one.rig + std::string(".yaml"))) +
            " -o run --quiet --set 'Grid|Elements={8, 8, 8}'");
    ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
    EXPECT_EQ(wrong(folder, std::string("says run ") + one.says), "") << one.rig;
    if (one.rig == std::string("simple_shear")) {
      EXPECT_EQ(wrong(folder, "run run"), "");
    }
  }
}

// V-REPORT. The strain of a body that both of its ends pull is theirs together, one that is given by a
// displacement is found, and one that is pulled by a force is not compared with bounds.
TEST(Report, BoundsAreForTheStrainBetweenTheFaces) {
  SKIP_WITHOUT_BROWSER();
  const struct {
    std::string bottom, top, more, says;
  } cases[] = {
      {", Strain: -0.02", "Strain: -0.03", "", "'between Reuss' 'Force against strain'"},
      {"", "'Displacement [um]': [0, -0.6, 0]", "", "'between Reuss' 'Force against displacement'"},
      {"", "Strain: -0.05", "  External Forces: {wind: {Face: x+, 'Traction [Pa]': [0, 5, 0]}}\n",
       "'!Bounds: force'"}};
  for (const auto& one : cases) {
    const TemporaryFolder folder;
    std::string deck = capillaries(one.more);
    const auto put = [&](const std::string& old, const std::string& text) {
      deck.replace(deck.find(old), old.size(), text);
    };
    put("Components: xyz}", "Components: y" + one.bottom + "}");
    put("Components: xyz, Strain: -0.05", "Components: y, " + std::string(one.top));
    folder.write("deck.yaml", deck);
    const Outcome outcome = run_stroma(folder.path(), "run deck.yaml -o run --quiet");
    ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
    EXPECT_EQ(wrong(folder, "says run " + one.says), "") << one.top;
  }
}

// V-REPORT
TEST(Report, OfAPressureShowsItAgainstTheVolume) {
  SKIP_WITHOUT_BROWSER();
  EXPECT_EQ(
      wrong_with_deck("18_pressed_vessel/deck.yaml",
                      " --set 'Loading|Steps=10' --set 'Boundary Conditions|back|Components=xyz'"),
      "");
}

// V-REPORT
TEST(Report, OfAFitShowsMeasurementsAndHowSureTheNumbersAre) {
  SKIP_WITHOUT_BROWSER();
  const TemporaryFolder folder;
  const fs::path deck = clone / "input_decks/14_fit_vessel_modulus";
  std::string fit = content_of(deck / "fit.yaml");
  const std::string base = "Base Deck: ", table = "File: ", start = "Start: 700";
  fit.insert(fit.find(base) + base.size(), deck.string() + "/");
  fit.insert(fit.find(table) + table.size(), deck.string() + "/");
  fit.replace(fit.find(start), start.size(), "Start: 950");
  fit.insert(fit.find("  Measurements:"),
             "    strain: {Path: Boundary Conditions|top|Strain, Start: 0.1}\n");
  folder.write("fit.yaml", fit);
  const Outcome outcome = run_stroma(folder.path(), "fit fit.yaml -o out --quiet");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  EXPECT_EQ(wrong(folder, "fit out"), "");
  fs::remove(folder / "out/estimates.csv");  // as of a fit that was interrupted
  fs::remove(folder / "out/fitted.csv");
  const Outcome again = run_stroma(folder.path(), "report out");
  EXPECT_EQ(again.status, 0) << again.standard_error;
  EXPECT_EQ(wrong(folder, "layout out"), "");
}

// V-REPORT
TEST(Report, OfAStiffnessShowsItsTensors) {
  SKIP_WITHOUT_BROWSER();
  const TemporaryFolder folder;
  for (const auto& [deck, ranks] : {std::pair{"scaffold", 1}, std::pair{"vessels", 2}}) {
    const fs::path path =
        clone / "input_decks/19_scaffold_stiffness" / (deck + std::string(".yaml"));
    const std::string smaller = deck == std::string("vessels")
                                    ? " --set 'Image|Phantom|Size={10, 10, 10}'"
                                    : " --set 'Output|Origin=Bottom'";
    const Outcome outcome = run_stroma(
        folder.path(), "run " + quoted(path) + " -o " + deck + " --quiet" + smaller, ranks);
    ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
    EXPECT_EQ(wrong(folder, std::string("stiffness ") + deck), "");
  }
}

TEST(Report, OfAStiffnessIsMadeAgain) {
  const TemporaryFolder folder;
  folder.write("run.yaml", capillaries().substr(0, capillaries().find("  Boundary Conditions")) +
                               "  Rig: {Kind: Stiffness, Boundary: [Mixed]}\n");
  Outcome outcome =
      run_stroma(folder.path(), "run run.yaml -o run --quiet --set 'Grid|Elements={4, 4, 2}'");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  const std::string at_end = content_of(folder / "run/report.html");
  EXPECT_NE(at_end.find("id=\"image\""), std::string::npos);
  for (const int ranks : {1, 2}) {
    fs::remove(folder / "run/report.html");
    outcome = run_stroma(folder.path(), "report run", ranks);
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    // all but the log, which tells by now of the report
    const std::string page = content_of(folder / "run/report.html");
    EXPECT_EQ(page.substr(page.find("\"made_by\":")), at_end.substr(at_end.find("\"made_by\":")));
  }
  folder.write("run/stiffness.json", "{}");
  outcome = run_stroma(folder.path(), "report run");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.standard_error.find("is no stiffness.json of Stroma"), std::string::npos)
      << outcome.standard_error;
}

/// A block whose force depends on the size of its elements.
const char* const block = R"(Stroma:
  Title: A block
  Image:
    Phantom: {Kind: Uniform, Size: [8, 8, 8], "Voxel Size [um]": [1.0, 1.0, 1.0]}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500.0, Poisson Ratio: 0.4}
  Grid: {"Element Size [um]": [4.0, 4.0, 4.0]}
  Boundary Conditions:
    bottom: {Face: y-, Components: xyz}
    top: {Face: y+, Components: xyz, Strain: 0.05}
  Loading: {Steps: 1}
)";

/// Runs a study of it into the folder out.
void study_block(const TemporaryFolder& folder, const std::string& study) {
  folder.write("base.yaml", block);
  folder.write("study.yaml", study);
  const Outcome outcome = run_stroma(folder.path(), "study study.yaml -o out --quiet");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
}

// V-REPORT
TEST(Report, OfAStudyShowsAllMembersAndTheLimit) {
  SKIP_WITHOUT_BROWSER();
  const TemporaryFolder folder;
  study_block(folder, R"(Study:
  Base Deck: base.yaml
  Cases:
    grid:
      4 um: {"Grid|Element Size [um]": [4.0, 4.0, 4.0]}
      2 um: {"Grid|Element Size [um]": [2.0, 2.0, 2.0]}
      1 um: {"Grid|Element Size [um]": [1.0, 1.0, 1.0]}
  Vary:
    Materials|gel|Shear Modulus [Pa]: [500.0, 600.0, 700.0, 800.0, 1000.0]
)");
  EXPECT_EQ(wrong(folder, "study out"), "");
  EXPECT_TRUE(fs::exists(folder / "out/4_um__Shear_Modulus_500.0_Pa/report.html"));
}

// V-REPORT
TEST(Report, OfDrawsShowsTheBandOfTheForce) {
  SKIP_WITHOUT_BROWSER();
  const TemporaryFolder folder;
  study_block(folder, R"(Study:
  Base Deck: base.yaml
  Uncertainty:
    Draws: 6
    Inputs:
      modulus: {Path: "Materials|gel|Shear Modulus [Pa]", Distribution: Uniform, Range: [400, 600]}
)");
  EXPECT_TRUE(fs::exists(folder / "out/bands.csv"));
  EXPECT_EQ(wrong(folder, "study out"), "");
}

TEST(Report, IsMadeAgainOfAFolderAndRemovedByTheNextRun) {
  const TemporaryFolder folder;
  run_deck(folder, "run", capillaries());
  const std::string at_end = content_of(folder / "run/report.html");
  fs::remove(folder / "run/report.html");
  for (const int ranks : {1, 2}) {
    const Outcome again = run_stroma(folder.path(), "report run", ranks);
    EXPECT_EQ(again.status, 0) << again.standard_error;
    EXPECT_NE(again.standard_output.find("run/report.html, "), std::string::npos);
    const std::string page = content_of(folder / "run/report.html");
    // all but the log, which tells by now of the report
    const std::size_t log = page.find("\"log\":"), end = page.find("\"made_by\":"),
                      then = at_end.find("\"made_by\":");
    EXPECT_EQ(page.substr(0, log), at_end.substr(0, log));
    EXPECT_EQ(page.substr(end), at_end.substr(then));
  }
  const Outcome next =
      run_stroma(folder.path(), "run run.yaml -o run --quiet --set 'Output|Report=false'");
  EXPECT_EQ(next.status, 0) << next.standard_error;
  EXPECT_FALSE(fs::exists(folder / "run/report.html"));
}

TEST(Report, DoesWithoutWhatIsGone) {
  const TemporaryFolder folder;
  run_deck(folder, "run", capillaries());
  fs::remove(folder / "run/particles.e");
  fs::remove(folder / "run/log.txt");
  const Outcome outcome = run_stroma(folder.path(), "report run");
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
  if (has_browser()) {
    EXPECT_EQ(wrong(folder, "layout run"), "");
  }
}

TEST(Report, OfARunThatFailedTellsHowFarItCame) {
  const TemporaryFolder folder;
  folder.write("run.yaml", capillaries());
  const Outcome outcome =
      run_stroma(folder.path(), "run run.yaml -o run --set 'Boundary Conditions|top|Strain=-0.99'");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(fs::exists(folder / "run/report.html")) << outcome.standard_output;
}

TEST(Report, RefusesWhatIsNoFolderOfResults) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "empty");
  const auto refused = [&](const std::string& arguments, const std::string& text) {
    const Outcome outcome = run_stroma(folder.path(), arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.standard_error.find(text), std::string::npos) << outcome.standard_error;
  };
  refused("report nowhere", "'nowhere' is no folder");
  refused(
      "report empty",
      "it has neither deck.xml, which a run leaves, nor study.csv, which a study leaves, nor fit.csv");
  folder.write("empty/deck.xml", "<ParameterList/>");
  refused("report empty", "it has no history.csv");
  run_deck(folder, "run", capillaries());
  folder.write("run/report.html", "my own");
  refused("report run", "'run/report.html' is no report of Stroma");
  EXPECT_EQ(content_of(folder / "run/report.html"), "my own");
}

}  // namespace
}  // namespace stroma::test
