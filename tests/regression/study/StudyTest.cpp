// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// `stroma study` as a user runs it: the table holds what its members' history.csv hold, a second
/// call runs nothing again, a failing member stops no other, and a wrong study runs nothing.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

/// A uniform block between clamped grips: the force depends on the size of the elements.
const char* const base_deck = R"(Stroma:
  Title: A block
  Image:
    Phantom:
      Kind: Uniform
      Size: [8, 8, 8]
      Voxel Size [um]: [1.0, 1.0, 1.0]
  Materials:
    gel:
      Label: 0
      Shear Modulus [Pa]: 500.0
      Poisson Ratio: 0.4
  Grid:
    Element Size [um]: [2.0, 2.0, 2.0]
  Boundary Conditions:
    bottom:
      Face: y-
      Components: xyz
    top:
      Face: y+
      Components: xyz
      Strain: 0.05
  Loading:
    Steps: 2
)";

const char* const study_deck = R"(Study:
  Base Deck: base.yaml
  Also Tabulate: [bottom.reaction_y]
  Cases:
    grid:
      4 um: {"Grid|Element Size [um]": [4.0, 4.0, 4.0]}
      2 um: {"Grid|Element Size [um]": [2.0, 2.0, 2.0]}
  Vary:
    Materials|gel|Shear Modulus [Pa]: [500, 1000.0]
)";

const std::vector<std::string> folders{
    "4_um__Shear_Modulus_500_Pa", "4_um__Shear_Modulus_1000.0_Pa", "2_um__Shear_Modulus_500_Pa",
    "2_um__Shear_Modulus_1000.0_Pa"};

/// A table of texts without quotes: the fields of each row by the header's names.
std::vector<std::map<std::string, std::string>> rows_of(const fs::path& path) {
  const auto fields_of = [](const std::string& line) {
    std::vector<std::string> fields(1);
    for (const char c : line) {
      if (c == ',')
        fields.emplace_back();
      else
        fields.back() += c;
    }
    return fields;
  };
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const auto names = fields_of(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(file, line)) {
    const auto fields = fields_of(line);
    EXPECT_EQ(fields.size(), names.size()) << line;
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = fields.at(i);
  }
  return rows;
}

bool is_png(const fs::path& path) { return content_of(path).rfind("\x89PNG\r\n\x1a\n", 0) == 0; }

std::vector<fs::file_time_type> times_of(const fs::path& study) {
  std::vector<fs::file_time_type> times;
  for (const std::string& folder : folders)
    times.push_back(fs::last_write_time(study / folder / "history.csv"));
  return times;
}

double sum(const std::vector<double>& values) {
  double total = 0.0;
  for (const double value : values) total += value;
  return total;
}

void expect_table_of_histories(const fs::path& study) {
  const auto rows = rows_of(study / "study.csv");
  ASSERT_EQ(rows.size(), folders.size());
  for (std::size_t m = 0; m < rows.size(); ++m) {
    auto row = rows[m];
    const History history(study / folders[m] / "history.csv");
    EXPECT_EQ(row["member"], folders[m]);
    EXPECT_EQ(row["grid"], m < 2 ? "4 um" : "2 um");
    EXPECT_EQ(row["Materials|gel|Shear Modulus [Pa]"], m % 2 == 0 ? "500" : "1000.0");
    EXPECT_EQ(row["status"], "done");
    const auto number = [&](const std::string& name) { return std::stod(row[name]); };
    EXPECT_EQ(number("load"), 1.0);
    EXPECT_EQ(number("top.force"), history["top.reaction_y"].back());
    EXPECT_EQ(number("strain_energy"), history["strain_energy"].back());
    EXPECT_EQ(number("gel.von_mises_mean"), history["gel.von_mises_mean"].back());
    EXPECT_EQ(number("newton_iterations"), sum(history["newton_iterations"]));
    EXPECT_EQ(number("linear_iterations"), sum(history["linear_iterations"]));
    EXPECT_EQ(number("wall_seconds"), history["wall_seconds"].back());
    EXPECT_EQ(number("bottom.reaction_y"), history["bottom.reaction_y"].back());
  }
  // Neo-Hookean at a given Poisson ratio: the force is proportional to the shear modulus.
  const auto force = [&](std::size_t m) { return std::stod(rows[m].at("top.force")); };
  EXPECT_GT(force(0), 0.0);
  EXPECT_NEAR(force(1) / force(0), 2.0, 1e-7);
  EXPECT_NEAR(force(3) / force(2), 2.0, 1e-7);
  EXPECT_GT(std::abs(force(0) / force(2) - 1.0), 1e-4);  // clamped: the size matters
}

// V-STUDY.
TEST(Study, TabulatesItsMembersAndRunsThemOnce) {
  const TemporaryFolder folder;
  folder.write("base.yaml", base_deck);
  folder.write("study.yaml", study_deck);
  const Outcome first = run_stroma(folder.path(), "study study.yaml");
  ASSERT_EQ(first.status, 0) << first.standard_error;
  EXPECT_TRUE(first.standard_error.empty()) << first.standard_error;
  const fs::path study = folder / "study";
  expect_table_of_histories(study);
  EXPECT_TRUE(is_png(study / "force_strain.png"));
  EXPECT_TRUE(is_png(study / "force_element_size.png"));
  for (const char* script : {"force_strain.gp", "force_strain.dat", "force_element_size.gp"})
    EXPECT_TRUE(fs::exists(study / "pictures" / script)) << script;
  const std::string convergence = content_of(study / "convergence.csv");
  EXPECT_NE(convergence.find("Shear Modulus 500 Pa,2,2,"), std::string::npos) << convergence;
  EXPECT_NE(convergence.find("it takes three sizes"), std::string::npos) << convergence;

  const std::string table = content_of(study / "study.csv");
  const auto times = times_of(study);
  const Outcome second = run_stroma(folder.path(), "study study.yaml");
  ASSERT_EQ(second.status, 0) << second.standard_error;
  EXPECT_EQ(times_of(study), times);
  EXPECT_EQ(content_of(study / "study.csv"), table);

  // A changed member and one cut short are run again; the others are not.
  std::string longer = study_deck;
  longer.replace(longer.find("1000.0"), 6, "2000.0");
  folder.write("study.yaml", longer);
  const fs::path cut = study / folders[0] / "history.csv";
  const std::string rows = content_of(cut);
  std::ofstream(cut) << rows.substr(0, rows.rfind('\n', rows.size() - 2) + 1);
  // As the run would have left its list of files when it was killed.
  const fs::path list = study / folders[0] / ".stroma_files";
  std::string files = content_of(list);
  const std::size_t entry = files.find("\nhistory.csv\t") + 1;
  files.replace(entry, files.find('\n', entry) - entry, "history.csv\tbeing written");
  std::ofstream(list) << files;
  const auto before = times_of(study);
  const Outcome third = run_stroma(folder.path(), "study study.yaml --quiet");
  ASSERT_EQ(third.status, 0) << third.standard_error;
  EXPECT_TRUE(third.standard_output.empty());
  const auto after = times_of(study);
  EXPECT_NE(after[0], before[0]);
  EXPECT_EQ(after[2], before[2]);
  EXPECT_EQ(after[1], before[1]);  // left from the earlier study
  const auto third_table = rows_of(study / "study.csv");
  ASSERT_EQ(third_table.size(), 4u);
  EXPECT_EQ(third_table[1].at("member"), "4_um__Shear_Modulus_2000.0_Pa");
  EXPECT_EQ(third_table[0].at("status"), "done");
}

TEST(Study, IsTheSameOnTwoRanks) {
  const TemporaryFolder folder;
  folder.write("base.yaml", base_deck);
  folder.write("study.yaml", study_deck);
  ASSERT_EQ(run_stroma(folder.path(), "study study.yaml -o one --quiet").status, 0);
  const Outcome two = run_stroma(folder.path(), "study study.yaml -o two --quiet", 2);
  ASSERT_EQ(two.status, 0) << two.standard_error;
  const auto one_rank = rows_of(folder / "one/study.csv");
  const auto two_ranks = rows_of(folder / "two/study.csv");
  ASSERT_EQ(one_rank.size(), 4u);
  ASSERT_EQ(two_ranks.size(), 4u);
  for (std::size_t m = 0; m < 4; ++m) {
    const double force = std::stod(one_rank[m].at("top.force"));
    EXPECT_NEAR(std::stod(two_ranks[m].at("top.force")), force, 1e-7 * force);
  }
  EXPECT_TRUE(is_png(folder / "two/force_strain.png"));
}

TEST(Study, ExtrapolatesFromThreeSizes) {
  const TemporaryFolder folder;
  folder.write("base.yaml", base_deck);
  folder.write("study.yaml", R"(Study:
  Base Deck: base.yaml
  Cases:
    grid:
      4 um: {"Grid|Element Size [um]": [4.0, 4.0, 4.0]}
      2 um: {"Grid|Element Size [um]": [2.0, 2.0, 2.0]}
      1 um: {"Grid|Element Size [um]": [1.0, 1.0, 1.0]}
)");
  const Outcome outcome = run_stroma(folder.path(), "study study.yaml");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  const auto members = rows_of(folder / "study/study.csv");
  const auto limit = rows_of(folder / "study/convergence.csv");
  ASSERT_EQ(limit.size(), 1u);
  const auto force = [&](std::size_t m) { return std::stod(members[m].at("top.force")); };
  const double first = force(0) - force(1), second = force(1) - force(2);
  EXPECT_GT(second, 0.0);  // a finer grid is softer
  EXPECT_NEAR(std::stod(limit[0].at("order")), std::log2(first / second), 1e-9);
  EXPECT_NEAR(std::stod(limit[0].at("extrapolated_force")),
              force(2) - second / (first / second - 1.0), 1e-9 * force(2));
  EXPECT_NE(outcome.standard_output.find("observed order"), std::string::npos);
}

TEST(Study, GoesOnAfterAMemberThatFails) {
  const TemporaryFolder folder;
  folder.write("base.yaml", base_deck);
  folder.write("study.yaml", R"(Study:
  Base Deck: base.yaml
  Cases:
    way:
      crushed: {Boundary Conditions|top|Strain: -0.99, Loading|Smallest Step: 0.2}
      pulled: {Boundary Conditions|top|Strain: 0.05}
)");
  for (const int ranks : {1, 2}) {
    const Outcome outcome = run_stroma(folder.path(), "study study.yaml --quiet", ranks);
    EXPECT_EQ(outcome.status, 1);
    for (const char* text :
         {"1 of 2 members failed", "member \"crushed\": the load step", "forbids smaller ones"})
      EXPECT_NE(outcome.standard_error.find(text), std::string::npos) << outcome.standard_error;
    const auto rows = rows_of(folder / "study/study.csv");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].at("status"), "failed");
    EXPECT_EQ(rows[0].at("top.force"), "");
    EXPECT_LT(std::stod(rows[0].at("load")), 1.0);
    EXPECT_EQ(rows[1].at("status"), "done");
    EXPECT_GT(std::stod(rows[1].at("top.force")), 0.0);
  }
}

/// The uniform block of base_deck as a layer in plane strain, with a second, stiffer material in
/// it.
const char* const slice_deck = R"(Stroma:
  Title: A slice
  Image:
    Phantom:
      Kind: Vessels
      Size: [32, 32, 1]
      Voxel Size [um]: [1.0, 1.0, 1.0]
      Volume Fraction: 0.2
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500.0, Poisson Ratio: 0.3}
    vessel: {Label: 1, "Shear Modulus [Pa]": 1000.0, Poisson Ratio: 0.3}
  Grid:
    Element Size [um]: [4.0, 4.0, 1.0]
    Plane Strain: true
  Boundary Conditions:
    bottom: {Face: y-, Components: y}
    top: {Face: y+, Components: y, Strain: 0.1}
  Loading: {Steps: 4}
)";

const char* const compared_study = R"(Study:
  Base Deck: slice.yaml
  Cases:
    grid:
      coarse: {}
      fine: {"Grid|Element Size [um]": [2.0, 2.0, 1.0], Loading|Steps: 3}
    specimen:
      with vessels: {}
      gel only: {"Materials|vessel|Shear Modulus [Pa]": 500.0}
  Vary:
    Output|Pictures: [true, false]
  Compare: {Thing: grid, Reference: fine}
  Gain: {Thing: specimen, Reference: gel only}
  Plot:
    Von Mises Members:
      - coarse__with_vessels__Pictures_true
      - fine__with_vessels__Pictures_true
)";

// V-STUDY-COMPARE.
TEST(Study, ComparesItsMembers) {
  const TemporaryFolder folder;
  folder.write("slice.yaml", slice_deck);
  folder.write("study.yaml", compared_study);
  const Outcome outcome = run_stroma(folder.path(), "study study.yaml", 2);
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  const auto rows = rows_of(folder / "study/study.csv");
  ASSERT_EQ(rows.size(), 8u);  // the last list changes fastest: Pictures, specimen, grid
  std::vector<History> histories;
  for (const auto& row : rows)
    histories.emplace_back(folder / ("study/" + row.at("member") + "/history.csv"));
  const auto force = [&](std::size_t m) { return histories[m]["top.reaction_y"]; };
  for (std::size_t m = 0; m < 8; ++m) {
    EXPECT_EQ(rows[m].at("Output|Pictures"), m % 2 == 0 ? "true" : "false");
    const bool is_gel = m % 4 >= 2, is_fine = m >= 4;
    EXPECT_EQ(rows[m].at("gain").empty(), is_gel) << m;
    EXPECT_EQ(rows[m].at("force_departure_rms").empty(), is_fine) << m;
    EXPECT_EQ(rows[m].at("force_departure_end").empty(), is_fine) << m;
    if (!is_gel) {
      const double gain = force(m).back() / force(m + 2).back() - 1.0;
      EXPECT_NEAR(std::stod(rows[m].at("gain")), gain, 1e-12);
      EXPECT_GT(gain, 0.1);
      EXPECT_LT(gain, 0.2);
    }
    // The law itself is not linear: 3 % at 10 % extension.
    double secant = 0.0;
    for (std::size_t s = 0; s < histories[m].rows(); ++s)
      secant = std::max(secant, std::abs(force(m)[s] - histories[m]["load"][s] * force(m).back()));
    EXPECT_NEAR(std::stod(rows[m].at("secant_departure")), secant / force(m).back(), 1e-12);
    EXPECT_NEAR(secant / force(m).back(), 0.03, 0.01);
  }
  // Four steps against three, whose forces are read in between: at 1/4, 1/2 and 3/4 the load is at
  // 3/4 of step 1, half-way between 1 and 2, and at 1/4 from 2 to 3.
  const auto coarse = force(0), fine = force(4);
  ASSERT_EQ(coarse.size(), 5u);
  ASSERT_EQ(fine.size(), 4u);
  const double at_steps[] = {0.75 * fine[1], 0.5 * (fine[1] + fine[2]),
                             0.75 * fine[2] + 0.25 * fine[3], fine[3]};
  double sum = 0.0;
  for (std::size_t s = 0; s < 4; ++s) sum += std::pow(coarse[s + 1] - at_steps[s], 2);
  EXPECT_NEAR(std::stod(rows[0].at("force_departure_rms")), std::sqrt(sum / 4.0) / fine[3], 1e-9);
  EXPECT_NEAR(std::stod(rows[0].at("force_departure_end")), coarse[4] / fine[3] - 1.0, 1e-12);
  for (const char* text : {"gain", "force_departure_rms", "secant_departure", " %"})
    EXPECT_NE(outcome.standard_output.find(text), std::string::npos) << text;
}

// V-STUDY-PICTURES.
TEST(Study, DrawsVonMisesMapsOfFinishedMembers) {
  const TemporaryFolder folder;
  folder.write("slice.yaml", slice_deck);
  std::string study = compared_study;
  folder.write("study.yaml", study.substr(0, study.find("  Plot:")));
  ASSERT_EQ(run_stroma(folder.path(), "study study.yaml --quiet").status, 0);
  EXPECT_FALSE(fs::exists(folder / "study/von_mises.png"));  // not asked for
  const fs::path history = folder / "study/coarse__with_vessels__Pictures_true/history.csv";
  const auto time = fs::last_write_time(history);

  folder.write("study.yaml", study);
  const Outcome second = run_stroma(folder.path(), "study study.yaml", 2);
  ASSERT_EQ(second.status, 0) << second.standard_error;
  EXPECT_EQ(fs::last_write_time(history), time);  // nothing is run again for a picture
  EXPECT_TRUE(is_png(folder / "study/von_mises.png"));
  const std::string script = content_of(folder / "study/pictures/von_mises.gp");
  for (const char* text : {"(a) coarse", "(b) fine", "with vessels, Pictures true"})
    EXPECT_NE(script.find(text), std::string::npos) << text << " in\n" << script;
  EXPECT_EQ(second.standard_output.find("von_mises.png"), std::string::npos);

  // A member that left no map is named; the picture has the others.
  study += "      - fine__gel_only__Pictures_false\n";
  folder.write("study.yaml", study);
  const Outcome third = run_stroma(folder.path(), "study study.yaml");
  ASSERT_EQ(third.status, 0) << third.standard_error;
  EXPECT_NE(third.standard_output.find(
                "von_mises.png is without \"fine, gel only, Pictures false\": there is no "),
            std::string::npos)
      << third.standard_output;
  EXPECT_TRUE(is_png(folder / "study/von_mises.png"));
}

struct BadStudy {
  std::string what, deck;
  std::vector<std::string> told;
};

const BadStudy bad_studies[] = {
    {"NoBaseDeck",
     "  Base Deck: nothing.yaml\n  Vary: {Loading|Steps: [1]}\n",
     {"line 2, Base Deck", "there is no file", "nothing.yaml"}},
    {"MisspeltParameter",
     "  Base Deck: base.yaml\n  Vary: {Loading|Step: [1, 2]}\n",
     {"members (all 2)", "set by the study, Loading|Step", "did you mean \"Steps\"?"}},
    {"TwoMembersWrong",
     "  Base Deck: base.yaml\n  Cases:\n    it:\n      fine: {}\n"
     "      soft: {\"Materials|gel|Shear Modulus [Pa]\": -1}\n      odd: {Loading|Steps: 0}\n",
     {"member \"soft\":", "found -1; admissible: a number > 0",
      "member \"odd\":", "Loading|Steps: found 0"}},
    {"GridThatDoesNotFit",
     "  Base Deck: base.yaml\n  Cases:\n    grid:\n      fits: {}\n"
     "      3 um: {\"Grid|Element Size [um]\": [3.0, 2.0, 2.0]}\n",
     {"member \"3 um\":", "does not divide the specimen's 8 um along x"}},
    {"UnknownColumnAndSupport",
     "  Base Deck: base.yaml\n  Vary: {Loading|Steps: [1]}\n  Also Tabulate: [top.reaction_w]\n"
     "  Plot: {Support: bottom}\n",
     {"2 mistakes in", "Also Tabulate: \"top.reaction_w\" is no column", "Plot|Support"}},
    {"UnknownReferences",
     "  Base Deck: base.yaml\n  Vary: {Output|Pictures: [true, false]}\n"
     "  Compare: {Thing: Output|Picture, Reference: true}\n"
     "  Gain: {Thing: Output|Pictures, Reference: flase}\n"
     "  Plot: {Von Mises Members: [Pictures_tru]}\n",
     {"3 mistakes in", "did you mean \"Output|Pictures\"?", "did you mean \"false\"?",
      "did you mean \"Pictures_true\"?"}},
    {"ListOfTrueAndFalseForANumber",
     "  Base Deck: base.yaml\n  Vary: {Loading|Steps: [true, false]}\n",
     {"member \"Steps true\":", "Loading|Steps: \"true\" is not an integer"}},
    {"NothingVaried", "  Base Deck: base.yaml\n", {"nothing is varied"}},
    {"AValueInsteadOfAList",
     "  Base Deck: base.yaml\n  Vary: {Loading|Steps: 4}\n",
     {"line 3, Vary|Loading|Steps", "is one value; admissible: a list"}},
};

class BadStudies : public ::testing::TestWithParam<BadStudy> {};

TEST_P(BadStudies, RunNothing) {
  const BadStudy& bad = GetParam();
  const TemporaryFolder folder;
  folder.write("base.yaml", base_deck);
  folder.write("study.yaml", "Study:\n" + bad.deck);
  const Outcome outcome = run_stroma(folder.path(), "study study.yaml");
  EXPECT_EQ(outcome.status, 2);
  for (const std::string& text : bad.told)
    EXPECT_NE(outcome.standard_error.find(text), std::string::npos) << text << "\nnot in\n"
                                                                    << outcome.standard_error;
  EXPECT_TRUE(outcome.standard_output.empty()) << outcome.standard_output;
  EXPECT_FALSE(fs::exists(folder / "study"));
}

INSTANTIATE_TEST_SUITE_P(Study, BadStudies, ::testing::ValuesIn(bad_studies),
                         [](const auto& bad) { return bad.param.what; });

TEST(Study, HasAReference) {
  const TemporaryFolder folder;
  const Outcome outcome = run_stroma(folder.path(), "reference Study");
  EXPECT_EQ(outcome.status, 0);
  for (const char* text : {"`Base Deck`", "## Cases", "## Vary", "`Also Tabulate`", "`Support`",
                           "## Compare", "## Gain", "`Von Mises Members`"})
    EXPECT_NE(outcome.standard_output.find(text), std::string::npos) << text;
}

// input_decks/06_resolution_study: the vessels make a difference that depends on the grid; collagen
// alone is in a homogeneous state, whose force no grid changes.
TEST(ResolutionStudy, OfInputDecks) {
  const TemporaryFolder folder;
  const fs::path deck = clone_folder() / "input_decks/06_resolution_study/study.yaml";
  const Outcome outcome = run_stroma(folder.path(), "study " + quoted(deck) + " -o out --quiet");
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  const auto rows = rows_of(folder / "out/study.csv");
  ASSERT_EQ(rows.size(), 6u);
  const auto force = [&](std::size_t m) { return std::stod(rows[m].at("top.force")); };
  for (std::size_t m = 0; m < 6; m += 2) {
    EXPECT_GT(force(m), force(m + 1));
    EXPECT_NEAR(force(m + 1), force(1), 1e-7 * force(1));
    if (m > 0) {
      EXPECT_LT(force(m), force(m - 2));  // a finer grid is softer
    }
  }
  const auto limits = rows_of(folder / "out/convergence.csv");
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_EQ(limits[0].at("series"), "with vessels");
  EXPECT_LT(std::stod(limits[0].at("extrapolated_force")), force(4));
  EXPECT_GT(std::stod(limits[0].at("extrapolated_force")), force(5));
  EXPECT_EQ(limits[1].at("remark"), "the figure does not depend on the size");
}

}  // namespace
}  // namespace stroma::test
