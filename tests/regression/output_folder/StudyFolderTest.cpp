// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The folders of a study and of its members: as those of runs.

#include <gtest/gtest.h>

#include "support/SmallDeck.hpp"

namespace stroma::test {
namespace {

class StudyFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("base.yaml", small_deck());
    folder_.write("study.yaml", R"(Study:
  Base Deck: base.yaml
  Vary:
    Loading|Steps: [1, 2]
)");
  }
  Outcome study(const std::string& out) const {
    return run_stroma(folder_.path(), "study study.yaml -o " + out + " --quiet");
  }
  void expect_refused(const Outcome& outcome, const std::string& told) const {
    EXPECT_EQ(outcome.status, 2) << outcome.standard_error;
    EXPECT_NE(outcome.standard_error.find(told), std::string::npos) << outcome.standard_error;
  }

  const TemporaryFolder folder_;
};

TEST_F(StudyFolder, TheUsersFilesStay) {
  fs::create_directories(folder_ / "out");
  folder_.write("out/study.csv", "mine");
  expect_refused(study("out"), "holds 'study.csv'");
  EXPECT_EQ(content_of(folder_ / "out/study.csv"), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), {}), 1);
}

TEST_F(StudyFolder, AMembersFolderIsLookedAtBeforeTheFirstOneIsRun) {
  fs::create_directories(folder_ / "out/Steps_2");
  folder_.write("out/Steps_2/history.csv", "mine");
  expect_refused(study("out"), "holds 'history.csv'");
  EXPECT_EQ(content_of(folder_ / "out/Steps_2/history.csv"), "mine");
  EXPECT_FALSE(fs::exists(folder_ / "out/Steps_1"));
}

TEST_F(StudyFolder, IsWrittenAgain) {
  for (int time = 0; time < 2; ++time) {
    const Outcome outcome = study("out");
    ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
    EXPECT_TRUE(fs::exists(folder_ / "out/study.csv"));
  }
  EXPECT_NE(content_of(folder_ / "out/log.txt").find("files of an earlier run"), std::string::npos);
}

}  // namespace
}  // namespace stroma::test
