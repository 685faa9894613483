// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// From a study deck to its members: products, names, and what is refused.

#include <gtest/gtest.h>

#include <set>

#include "stroma/base/Error.hpp"
#include "study/StudyDeck.hpp"
#include "study/StudyMembers.hpp"
#include "support/Program.hpp"

namespace stroma {
namespace {

std::vector<Member> members_in(const std::string& deck, const std::string& name = "study.yaml") {
  const test::TemporaryFolder folder;
  return members_of(read_study(folder.write(name, deck).string()).variations);
}

std::string mistakes_in(const std::string& deck) {
  try {
    members_in("Study:\n  Base Deck: deck.xml\n" + deck);
  } catch (const base::InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "accepted:\n" << deck;
  return "";
}

void expect_told(const std::string& deck, const std::string& text) {
  const std::string mistakes = mistakes_in(deck);
  EXPECT_NE(mistakes.find(text), std::string::npos) << mistakes;
  EXPECT_EQ(mistakes.rfind("1 mistake in ", 0), 0u) << mistakes;
}

using Texts = std::vector<std::string>;

TEST(StudyDeck, MakesEveryCombination) {
  const auto members = members_in(R"(Study:
  Base Deck: deck.xml
  Vary:
    Loading|Steps: [5, 10]
    Materials|vessel|Shear Modulus [Pa]: [520.8, 1e3]
  Cases:
    grid:
      8 px: {"Grid|Element Size [um]": [8.4, 8.4, 1.0]}
      4 px: {"Grid|Element Size [um]": [4.2, 4.2, 1.0], "Particles|Per Voxel": 2}
    specimen:
      as it is: {}
)");
  ASSERT_EQ(members.size(), 8u);
  EXPECT_EQ(members[0].name, "8 px, as it is, Steps 5, Shear Modulus 520.8 Pa");
  EXPECT_EQ(members[0].folder, "8_px__as_it_is__Steps_5__Shear_Modulus_520.8_Pa");
  EXPECT_EQ(members[0].values, (Texts{"8 px", "as it is", "5", "520.8"}));
  EXPECT_EQ(members[0].overrides,
            (Texts{"Grid|Element Size [um]={8.4, 8.4, 1.0}", "Loading|Steps=5",
                   "Materials|vessel|Shear Modulus [Pa]=520.8"}));
  // The last list changes fastest; values stand as they were written.
  EXPECT_EQ(members[1].name, "8 px, as it is, Steps 5, Shear Modulus 1e3 Pa");
  EXPECT_EQ(members[2].name, "8 px, as it is, Steps 10, Shear Modulus 520.8 Pa");
  EXPECT_EQ(members[7].overrides,
            (Texts{"Grid|Element Size [um]={4.2, 4.2, 1.0}", "Particles|Per Voxel=2",
                   "Loading|Steps=10", "Materials|vessel|Shear Modulus [Pa]=1e3"}));
  std::set<std::string> folders;
  for (const Member& member : members) folders.insert(member.folder);
  EXPECT_EQ(folders.size(), 8u);
}

TEST(StudyDeck, ReadsXmlAlike) {
  const auto members = members_in(R"xml(<ParameterList name="Study">
  <Parameter name="Base Deck" type="string" value="deck.xml"/>
  <ParameterList name="Cases"><ParameterList name="grid"><ParameterList name="8 px">
    <Parameter name="Grid|Element Size [um]" type="Array(double)" value="{8.4, 8.4, 1.0}"/>
  </ParameterList></ParameterList></ParameterList>
  <ParameterList name="Vary">
    <Parameter name="Solver|Preconditioner" type="Array(string)" value="{Jacobi, Direct}"/>
  </ParameterList>
</ParameterList>)xml",
                                  "study.xml");
  ASSERT_EQ(members.size(), 2u);
  EXPECT_EQ(members[1].overrides,
            (Texts{"Grid|Element Size [um]={8.4, 8.4, 1.0}", "Solver|Preconditioner=Direct"}));
  EXPECT_EQ(members[1].folder, "8_px__Preconditioner_Direct");
}

// V-STUDY.
TEST(StudyDeck, VariesTrueAndFalse) {
  const auto yaml =
      members_in("Study:\n  Base Deck: deck.xml\n  Vary: {Grid|Reset: [true, false]}\n");
  const auto xml = members_in(R"xml(<ParameterList name="Study">
  <Parameter name="Base Deck" type="string" value="deck.xml"/>
  <ParameterList name="Vary">
    <Parameter name="Grid|Reset" type="Array(bool)" value="{true, false}"/>
  </ParameterList>
</ParameterList>)xml",
                              "study.xml");
  for (const auto& members : {yaml, xml}) {
    ASSERT_EQ(members.size(), 2u);
    EXPECT_EQ(members[0].name, "Reset true");
    EXPECT_EQ(members[0].folder, "Reset_true");
    EXPECT_EQ(members[0].overrides, (Texts{"Grid|Reset=true"}));
    EXPECT_EQ(members[1].overrides, (Texts{"Grid|Reset=false"}));
  }
}

TEST(StudyDeck, FindsWhatComparisonsAndPicturesReferTo) {
  const test::TemporaryFolder folder;
  const Study study = read_study(folder
                                     .write("study.yaml", R"(Study:
  Base Deck: deck.xml
  Cases:
    grid: {8 px: {}, 4 px: {}}
  Vary: {Loading|Steps: [5, 10]}
  Compare: {Thing: Loading|Steps, Reference: 10}
  Gain: {Thing: grid, Reference: 8 px}
  Plot: {Von Mises Members: [4_px__Steps_10, 8_px__Steps_5]}
)")
                                     .string());
  ASSERT_TRUE(study.compare && study.gain);
  EXPECT_EQ(study.compare->variation, 1u);
  EXPECT_EQ(study.compare->label, "Steps 10");
  EXPECT_EQ(study.gain->variation, 0u);
  EXPECT_EQ(study.gain->label, "8 px");
  EXPECT_EQ(study.von_mises_members, (std::vector<std::size_t>{3, 0}));
}

TEST(StudyDeck, RefusesReferencesToNothing) {
  const std::string varied = "  Cases: {mode: {reset: {}, no reset: {}}}\n";
  expect_told(varied + "  Compare: {Thing: modes, Reference: reset}\n",
              "line 4, Compare|Thing: \"modes\" does not vary; did you mean \"mode\"?");
  expect_told(varied + "  Gain: {Thing: mode, Reference: no rest}\n",
              "line 4, Gain|Reference: \"no rest\" is none of what mode may be; did you mean "
              "\"no reset\"?");
  expect_told(varied + "  Compare: {Thing: mode}\n", "Compare|Reference: required, but missing");
  expect_told(varied + "  Plot: {Von Mises Members: [no_rest]}\n",
              "line 4, Plot|Von Mises Members: \"no_rest\" is no member; did you mean "
              "\"no_reset\"?");
  expect_told(varied + "  Plot: {Von Mises Members: [reset, reset]}\n", "is there twice");
  expect_told(
      "  Vary: {Loading|Steps: [1, 2, 3, 4, 5, 6, 7]}\n"
      "  Plot: {Von Mises Members: [nothing]}\n",
      "there are 7, such as \"Steps_1\" and \"Steps_7\"");
  expect_told("  Cases: {gain: {a: {}}}\n", "the table has a column of this name");
}

TEST(StudyDeck, TellsParametersOfTheSameNameApart) {
  const auto members = members_in(R"(Study:
  Base Deck: deck.xml
  Vary:
    Materials|vessel|Shear Modulus [Pa]: [1]
    Materials|collagen|Shear Modulus [Pa]: [2]
    Loading|Steps: [3]
)");
  ASSERT_EQ(members.size(), 1u);
  EXPECT_EQ(members[0].name, "vessel Shear Modulus 1 Pa, collagen Shear Modulus 2 Pa, Steps 3");
}

TEST(StudyDeck, NamesFoldersThatNeedNoQuotes) {
  EXPECT_EQ(folder_name({"../up", "a b/c"}), "_._up__a_b_c");
  EXPECT_EQ(folder_name({"Strain -0.1"}), "Strain_-0.1");
  EXPECT_EQ(folder_name({"-rf"}), "_rf");
  EXPECT_TRUE(is_reserved("pictures"));
  EXPECT_FALSE(is_reserved("8_px"));
}

TEST(StudyDeck, RefusesWhatIsNoStudy) {
  expect_told("", "nothing is varied; give Cases, or Vary, or both");
  expect_told("  Vary: {Loading|Steps: 5}\n", "line 3, Vary|Loading|Steps: \"5\" is one value");
  expect_told("  Vary: {Loading|Steps: []}\n", "an empty list");
  expect_told("  Vary: {Loading|Steps: [5, 5]}\n", "the same folder, Steps_5");
  expect_told("  Vary: {Loading: {Steps: [5]}}\n", "named by its whole path");
  expect_told("  Cases: {Loading|Steps: 5}\n",
              "Cases|Loading|Steps: is a parameter, not a sublist");
  expect_told("  Cases: {grid: {Loading|Steps: 5}}\n", "is a parameter, not a sublist");
  expect_told("  Cases: {grid: {fine: {Loading: {Steps: 5}}}}\n", "named by its whole path");
  expect_told("  Cases: {grid: {a b: {}, a_b: {}}}\n", "the same folder, a_b");
  expect_told("  Cases: {status: {a: {}}}\n", "the table has a column of this name");
  expect_told("  Cases: {a: {pictures: {}}}\n", "something that the study itself writes");
  expect_told("  Cases: {a: {b: {Loading|Steps: 5}}}\n  Vary: {Loading|Steps: [5]}\n",
              "line 4, Vary|Loading|Steps: sets Loading|Steps, which Cases|a sets too");
  expect_told("  Cases: {a: {b: {}}}\n  Very: {Loading|Steps: [5]}\n", "did you mean \"Vary\"?");
}

TEST(StudyDeck, TellsAllMistakesAtOnce) {
  const std::string mistakes = mistakes_in("  Vary: {Loading|Steps: 5, Title: []}\n");
  EXPECT_EQ(mistakes.rfind("2 mistakes in ", 0), 0u) << mistakes;
}

}  // namespace
}  // namespace stroma
