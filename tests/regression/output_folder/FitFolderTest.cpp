// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The folders of a fit and of its runs: as those of runs.

#include <gtest/gtest.h>

#include "support/SmallDeck.hpp"

namespace stroma::test {
namespace {

class FitFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("base.yaml", small_deck());
    ASSERT_EQ(run_stroma(folder_.path(), "run base.yaml -o measured --quiet").status, 0);
    write_fit("measured/history.csv");
    const Outcome first = fit();
    ASSERT_EQ(first.status, 0) << first.standard_error;
    ASSERT_TRUE(fs::exists(folder_ / "out/ball_900/history.csv"));
  }
  void write_fit(const std::string& table) const {
    folder_.write("fit.yaml", R"(Fit:
  Base Deck: base.yaml
  Parameters:
    ball: {Path: "Materials|ball|Shear Modulus [Pa]", Start: 900.0, Lower: 1.0}
  Measurements:
    pull: {Against: Time, Abscissa Column: load, Force Column: top.reaction_y, Condition: top,
           Component: y, Error: 1.0, File: )" +
                                  table + "}\n");
  }
  Outcome fit(const std::string& out = "out") const {
    return run_stroma(folder_.path(), "fit fit.yaml --quiet -o " + out);
  }
  void expect_refused(const std::string& told) const {
    const Outcome outcome = fit();
    EXPECT_EQ(outcome.status, 2) << outcome.standard_error;
    EXPECT_NE(outcome.standard_error.find(told), std::string::npos) << outcome.standard_error;
    EXPECT_TRUE(fs::exists(folder_ / "out/estimates.csv"));
  }
  /// No run is finished any more.
  void change_base_deck() const {
    folder_.write("base.yaml", std::regex_replace(small_deck(), std::regex("500.0"), "510.0"));
  }

  const TemporaryFolder folder_;
};

// V-FOLDER.
TEST_F(FitFolder, NotesUnderTheNameOfALogStay) {
  change_base_deck();
  for (const char* file : {"out/log.txt", "out/ball_900/log.txt"})
    for (const bool is_killed : {false, true}) {
      SCOPED_TRACE(file);
      const std::string log = content_of(folder_ / file);
      if (is_killed) leave_as_killed((folder_ / file).parent_path());
      folder_.write(file, "mine");
      expect_refused("holds 'log.txt', which");
      EXPECT_EQ(content_of(folder_ / file), "mine");
      folder_.write(file, log);
    }
  const Outcome again = fit();
  EXPECT_EQ(again.status, 0) << again.standard_error;
}

// V-FOLDER. A run of an earlier fit is what was measured.
TEST_F(FitFolder, ATableOfMeasurementsStays) {
  const std::string table = "out/ball_900/history.csv", forces = content_of(folder_ / table);
  write_fit(table);
  EXPECT_EQ(fit().status, 0) << "that run is finished, and is not run again";
  EXPECT_EQ(content_of(folder_ / table), forces);
  change_base_deck();
  expect_refused("holds '" + table + "' as 'history.csv', a name that the run writes to");
  EXPECT_EQ(content_of(folder_ / table), forces);
  const Outcome elsewhere = fit("elsewhere");
  EXPECT_EQ(elsewhere.status, 0) << elsewhere.standard_error;
}

}  // namespace
}  // namespace stroma::test
