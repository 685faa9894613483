// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The tables: a force along a displacement askew, members that failed, names with commas.

#include <gtest/gtest.h>

#include "study/StudyTable.hpp"
#include "support/Program.hpp"

namespace stroma {
namespace {

output::HistoryTable history_of(const std::string& text) {
  const test::TemporaryFolder folder;
  return output::HistoryTable(folder.write("history.csv", text).string());
}

const std::string header =
    "step,load,newton_iterations,linear_iterations,residual,wall_seconds,strain_energy,"
    "top.reaction_x,top.reaction_y,top.reaction_z,\"a \"\"b\"\", c.von_mises_mean\"\n";

TEST(StudyTable, HasARowForEachMember) {
  const std::vector<Variation> variations{{"grid, of elements", {}}};
  const std::vector<Member> members{{"8 px", "8_px", {"8 px"}, {"8 px"}, {}},
                                    {"4 px", "4_px", {"4 px"}, {"4 px"}, {}},
                                    {"2 px", "2_px", {"2 px"}, {"2 px"}, {}}};
  MemberFacts facts;
  facts.moving = {{"top", 0, {3.0, 4.0, 0.0}, {0.6, 0.8, 0.0}}};
  facts.materials = {"a \"b\", c"};
  std::vector<MemberResult> results(3);
  results[0].status = MemberStatus::done;
  results[0].history = history_of(header + "0,0,0,0,0,0,0,0,0,0,0\n1,0.5,2,10,0,1,1,1,1,0,3\n" +
                                  "2,1,3,20,0,1.5,4,10,20,99,5\n");
  results[1].status = MemberStatus::failed;
  results[1].history = history_of(header + "0,0,0,0,0,0,0,0,0,0,0\n1,0.5,2,10,0,1,1,1,1,0,3\n");
  EXPECT_EQ(force_along(facts.moving[0], results[0].history)[2], 0.6 * 10.0 + 0.8 * 20.0);
  const ComparisonTable comparison{
      {"gain", "secant_departure"},
      {{0.25, 0.5}, {std::nullopt, std::nullopt}, {std::nullopt, 0.0}}};
  EXPECT_EQ(
      study_table(variations, members, {facts, facts, facts}, results, comparison,
                  {"top.reaction_z"}),
      "member,\"grid, of elements\",status,load,top.force,gain,secant_departure,strain_energy,"
      "\"a \"\"b\"\", c.von_mises_mean\",newton_iterations,linear_iterations,wall_seconds,"
      "top.reaction_z\n"
      "8_px,8 px,done,1,22,0.25,0.5,4,5,5,30,1.5,99\n"
      "4_px,4 px,failed,0.5,,,,,,2,10,1,\n"
      "2_px,2 px,waiting,,,,0,,,,,,\n");
}

TEST(ConvergenceTable, SaysWhatIsUndefined) {
  SizeGroup group{
      "collagen, only", {{4.0, 1.5}, {2.0, 1.25}}, richardson({{4.0, 1.5}, {2.0, 1.25}})};
  EXPECT_EQ(convergence_table({group}),
            "series,sizes,finest_element_size,finest_force,extrapolated_force,order,remark\n"
            "\"collagen, only\",2,2,1.25,,,it takes three sizes\n");
  group.forces.push_back({1.0, 1.125});
  group.limit = richardson(group.forces);
  EXPECT_EQ(convergence_table({group}),
            "series,sizes,finest_element_size,finest_force,extrapolated_force,order,remark\n"
            "\"collagen, only\",3,1,1.125,1,1,\n");
}

}  // namespace
}  // namespace stroma
