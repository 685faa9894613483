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

// V-FOLDER.
TEST_F(StudyFolder, NotesUnderTheNameOfALogStay) {
  ASSERT_EQ(study("out").status, 0);
  folder_.write("base.yaml", std::regex_replace(small_deck(), std::regex("500.0"), "510.0"));
  for (const char* file : {"out/log.txt", "out/Steps_2/log.txt"})
    for (const bool is_killed : {false, true}) {
      SCOPED_TRACE(file);
      const std::string log = content_of(folder_ / file);
      if (is_killed) leave_as_killed((folder_ / file).parent_path());
      folder_.write(file, "mine");
      expect_refused(study("out"), "holds 'log.txt', which");
      EXPECT_EQ(content_of(folder_ / file), "mine");
      EXPECT_TRUE(fs::exists(folder_ / "out/study.csv"));
      folder_.write(file, log);
    }
  const Outcome again = study("out");
  EXPECT_EQ(again.status, 0) << again.standard_error;
}

// V-FOLDER. What one member would remove is another one's image.
TEST_F(StudyFolder, AnImageOfAnEarlierStudyStays) {
  const std::string stacks = "  Output:\n    Image Stacks: {Quantities: [label]}\n";
  folder_.write("base.yaml", small_deck() + stacks);
  ASSERT_EQ(study("out").status, 0);
  const std::string name = "out/Steps_2/image_undeformed.ome.tif",
                    image = content_of(folder_ / name);
  ASSERT_FALSE(image.empty());
  folder_.write("base.yaml", small_deck_of_labels(name));
  expect_refused(study("out"),
                 "holds '" + name +
                     "' as 'image_undeformed.ome.tif', which an earlier run left there and this "
                     "one would remove");
  EXPECT_TRUE(content_of(folder_ / name) == image);
  EXPECT_TRUE(fs::exists(folder_ / "out/study.csv"));
  EXPECT_EQ(study("elsewhere").status, 0);
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
