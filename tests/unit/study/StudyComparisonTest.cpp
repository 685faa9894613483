// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Which member is held against which, and what stands in the columns.

#include <gtest/gtest.h>

#include "study/StudyComparison.hpp"
#include "support/Program.hpp"

namespace stroma {
namespace {

/// 2 grids x (reset, no reset) x 2 strengths: members 0 to 7, the last thing changes fastest.
Study study_of(const std::string& more) {
  const test::TemporaryFolder folder;
  return read_study(folder
                        .write("study.yaml", R"(Study:
  Base Deck: deck.xml
  Cases:
    grid: {coarse: {}, fine: {Loading|Steps: 4}}
    mode: {reset: {Grid|Reset: true}, no reset: {}}
  Vary:
    Materials|vessel|Shear Modulus [Pa]: [520.8, 1041.6]
)" + more)
                        .string());
}

const char* const both = R"(  Compare: {Thing: mode, Reference: no reset}
  Gain: {Thing: "Materials|vessel|Shear Modulus [Pa]", Reference: 520.8}
)";

// V-STUDY-COMPARE.
TEST(StudyComparison, PairsMembersThatDifferInOneThing) {
  const Study study = study_of(both);
  const auto members = members_of(study.variations);
  ASSERT_TRUE(study.compare && study.gain);
  const std::vector<int> mode{2, 3, -1, -1, 6, 7, -1, -1}, strength{-1, 0, -1, 2, -1, 4, -1, 6};
  for (std::size_t m = 0; m < members.size(); ++m) {
    const auto one = reference_of(*study.compare, members, m);
    const auto other = reference_of(*study.gain, members, m);
    EXPECT_EQ(one ? static_cast<int>(*one) : -1, mode[m]) << members[m].name;
    EXPECT_EQ(other ? static_cast<int>(*other) : -1, strength[m]) << members[m].name;
  }
}

TEST(StudyComparison, FillsWhatHasBothRuns) {
  const Study study = study_of(both);
  const auto members = members_of(study.variations);
  std::vector<std::optional<ForceRecord>> records(8);
  records[0] = ForceRecord{{0.0, 0.5, 1.0}, {0.0, 6.0, 10.0}};  // coarse, reset, 520.8
  records[1] = ForceRecord{{0.0, 0.5, 1.0}, {0.0, 6.0, 12.0}};  // coarse, reset, 1041.6
  records[2] = ForceRecord{{0.0, 1.0}, {0.0, 8.0}};             // coarse, no reset, 520.8
  const ComparisonTable table = compare(study, members, records);
  EXPECT_EQ(table.columns, (std::vector<std::string>{"gain", "force_departure_rms",
                                                     "force_departure_end", "secant_departure"}));
  ASSERT_EQ(table.rows.size(), 8u);
  EXPECT_EQ(table.rows[0][0], std::nullopt);  // it is a reference
  EXPECT_DOUBLE_EQ(*table.rows[0][1], 2.0 / 8.0);
  EXPECT_DOUBLE_EQ(*table.rows[0][2], 0.25);
  EXPECT_DOUBLE_EQ(*table.rows[0][3], 0.1);
  EXPECT_DOUBLE_EQ(*table.rows[1][0], 0.2);
  EXPECT_EQ(table.rows[1][1], std::nullopt);  // its reference, member 3, was not run
  EXPECT_EQ(table.rows[1][3], 0.0);
  EXPECT_EQ(table.rows[2][1], std::nullopt);
  EXPECT_EQ(table.rows[3], (std::vector<std::optional<double>>(4)));
}

TEST(StudyComparison, HasTheColumnsThatWereAskedFor) {
  const auto columns = [](const std::string& more) {
    const Study study = study_of(more);
    const auto members = members_of(study.variations);
    return compare(study, members, std::vector<std::optional<ForceRecord>>(8)).columns;
  };
  EXPECT_EQ(columns(""), (std::vector<std::string>{"secant_departure"}));
  EXPECT_EQ(columns("  Gain: {Thing: mode, Reference: reset}\n"),
            (std::vector<std::string>{"gain", "secant_departure"}));
}

}  // namespace
}  // namespace stroma
