// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The deck as a whole: values arrive, defaults hold, and every mistake is found in one go.

#include "SampleDeck.hpp"
#include "support/TemporaryFolder.hpp"

namespace stroma::deck::sample {
namespace {

TEST(DeckRead, XmlFillsEveryMember) { expect_sample_values(read_text(xml)); }

TEST(DeckRead, YamlSaysTheSame) { expect_sample_values(read_text(yaml, Format::yaml)); }

TEST(DeckRead, WhatIsLeftOutKeepsTheDefaultOfTheStruct) {
  const Sample deck = read_text(small_xml());
  EXPECT_EQ(deck.title, "untitled");
  EXPECT_FALSE(deck.grid.reset);
  EXPECT_EQ(deck.grid.shape, Shape::linear);
  EXPECT_FALSE(deck.phantom.has_value());
  EXPECT_EQ(deck.solver.tolerance, 1e-8);
  EXPECT_EQ(deck.solver.seed, 5'000'000'000);
  EXPECT_TRUE(Teuchos::is_null(deck.solver.belos));
}

TEST(DeckRead, AllMistakesInOneGoInTheOrderOfTheLines) {
  const std::string deck = R"deck(<ParameterList name="Stroma">
  <ParameterList name="Grid">
    <Parameter name="Element Sise [um]" type="Array(double)" value="{2, 2, 2}"/>
    <Parameter name="Reset" type="string" value="true"/>
    <Parameter name="Reset" type="bool" value="true" unit="none"/>
    <Parameter name="Shape Functions" type="string" value="Liner"/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="gel">
      <Parameter name="Label" type="int" value="-2"/>
      <Parameter name="Shear Modulus [Pa]" type="double" value="soft"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Slover"/>
</ParameterList>)deck";
  EXPECT_EQ(complaint(deck),
            R"deck(9 mistakes in gel.xml
line 2, Grid|Element Size [um]: required, but missing; admissible: 3 numbers, each > 0
line 3, Grid|Element Sise [um]: no such parameter; did you mean "Element Size [um]"?
line 4, Grid|Reset: type="string" is the wrong type; write type="bool"; admissible: true or false
line 5, Grid|Reset: no such XML attribute: unit; known here: "name", "type", "value"
line 5, Grid|Reset: given twice; first on line 4
line 6, Grid|Shape Functions: found "Liner"; admissible: "Linear" or "GIMP"; did you mean "Linear"?
line 10, Materials|gel|Label: found -2; admissible: an integer >= 0
line 11, Materials|gel|Shear Modulus [Pa]: "soft" is not a number; admissible: a number > 0
line 14, Slover: no such section; did you mean "Solver"?)deck");
}

TEST(DeckRead, TheExampleOfTheInterface) {
  const std::string deck = with(xml, "value=\"520.8\"", "value=\"soft\"");
  EXPECT_EQ(complaint(with(deck, "Element Size [um]", "Element Sise [um]")),
            R"deck(3 mistakes in gel.xml
line 8, Materials|collagen|Shear Modulus [Pa]: "soft" is not a number; admissible: a number > 0
line 17, Grid|Element Size [um]: required, but missing; admissible: 3 numbers, each > 0
line 18, Grid|Element Sise [um]: no such parameter; did you mean "Element Size [um]"?)deck");
}

TEST(DeckRead, AMissingParameterIsToldAtItsSectionsTag) {
  EXPECT_EQ(
      only_complaint(with(xml, R"deck(<Parameter name="Label" type="int" value="1"/>)deck", "")),
      "line 11, Materials|a vessel|Label: required, but missing; admissible: an integer >= 0");
}

TEST(DeckRead, AMissingSectionIsToldAtTheSectionAroundIt) {
  EXPECT_EQ(only_complaint(R"deck(
<ParameterList name="Stroma">
  <ParameterList name="Grid">
    <Parameter name="Element Size [um]" type="Array(double)" value="{2, 2, 2}"/>
  </ParameterList>
</ParameterList>)deck"),
            "line 2, Materials: this section is required, but missing");
}

// A section that may be left out does not excuse from what it requires.
TEST(DeckRead, AnAbsentSectionStillRequiresItsParameters) {
  const std::string grid = R"deck(<ParameterList name="Grid">
    <Parameter name="Element Size [um]" type="Array(double)" value="{2, 2, 2}"/>
  </ParameterList>)deck";
  EXPECT_EQ(
      only_complaint(with(small_xml(), grid, "")),
      "line 1, Grid|Element Size [um]: required, but missing; admissible: 3 numbers, each > 0");
}

TEST(DeckRead, TheOuterListMustHaveTheRightName) {
  EXPECT_EQ(only_complaint(with(small_xml(), "Stroma", "Storma")),
            "line 1: the outer list is named \"Storma\"; its name must be \"Stroma\"");
}

TEST(DeckRead, RulesBetweenParametersNameTheLine) {
  const std::string poisson =
      R"deck(<Parameter name="Poisson Ratio" type="double" value="0.4"/>)deck";
  const std::string bulk =
      R"deck(<Parameter name="Bulk Modulus [Pa]" type="double" value="1"/>)deck";
  EXPECT_EQ(only_complaint(with(xml, poisson, poisson + "\n" + bulk)),
            "line 10, Materials|collagen|Bulk Modulus [Pa]: give either Poisson Ratio or Bulk "
            "Modulus [Pa]");
  EXPECT_EQ(only_complaint(with(xml, poisson, "")),
            "line 6, Materials|collagen: give either Poisson Ratio or Bulk Modulus [Pa]");
}

TEST(DeckRead, RulesDoNotRunOnASectionThatCouldNotBeRead) {
  const std::string deck =
      with(xml, R"deck(type="double" value="0.4")deck", R"deck(type="double" value="0,4")deck");
  EXPECT_EQ(only_complaint(deck),
            "line 9, Materials|collagen|Poisson Ratio: \"0,4\" is not a number; "
            "admissible: a number > -1 and < 0.5");
}

TEST(DeckRead, ParametersAndSectionsAreNotInterchangeable) {
  EXPECT_EQ(only_complaint(
                small_xml(R"deck(<Parameter name="Solver" type="string" value="Newton"/>)deck")),
            "line 1, Solver: is a section, not a parameter");
  EXPECT_EQ(only_complaint(small_xml(R"deck(<ParameterList name="Title"/>)deck")),
            "line 1, Title: is a parameter, not a section; admissible: a string that is not empty");
  EXPECT_EQ(
      only_complaint(small_xml(
          R"deck(<ParameterList name="Title"/><Parameter name="Title" type="string" value="x"/>)deck")),
      "line 1, Title: given twice; first on line 1");
}

TEST(DeckRead, AParameterInTheWrongPlaceIsSentHome) {
  EXPECT_EQ(only_complaint(small_xml(
                R"deck(<Parameter name="Newton Tolerance" type="double" value="1"/>)deck")),
            "line 1, Newton Tolerance: no such parameter; it belongs in Solver");
}

TEST(DeckRead, SectionsNamedByTheUser) {
  const std::string deck = small_xml();
  EXPECT_EQ(only_complaint(with(deck, "\"gel\"", "\"gel, stiff\"")),
            "line 3, Materials: the name \"gel, stiff\" holds a comma or a '|'; it "
            "appears in tables");
  EXPECT_NE(only_complaint(with(deck, "\"gel\"", "\"gel|stiff\"")).find("a comma or a '|'"),
            std::string::npos);
  EXPECT_NE(only_complaint(with(deck, "\"gel\"", "\"gel&#10;stiff\"")).find("a line break"),
            std::string::npos);
  EXPECT_EQ(only_complaint(with(xml, "\"a vessel\"", "\"collagen\"")),
            "line 11, Materials|collagen: given twice; first on line 6");
  EXPECT_EQ(
      only_complaint(with(deck, "<ParameterList name=\"Materials\">",
                          "<ParameterList name=\"Materials\">\n<Parameter name=\"Label\" "
                          "type=\"int\" value=\"0\"/>")),
      "line 3, Materials|Label: no such parameter; this section holds sublists only, named by you");
  const std::size_t begin = deck.find("<ParameterList name=\"gel\">");
  const std::size_t end = deck.find("</ParameterList>") + 16;
  EXPECT_EQ(only_complaint(deck.substr(0, begin) + deck.substr(end)),
            "line 2, Materials: needs at least 1 sublist, named by you");
}

TEST(DeckRead, FindingsMadeAfterReadingCarryTheLine) {
  const Document document = parse(xml, Format::xml, "gel.xml");
  Findings findings(document);
  EXPECT_NO_THROW(findings.throw_if_any());
  findings.add("Grid|Element Size [um]", "does not divide the body");
  findings.add("Materials|collagen|Label", "no voxel has it");
  findings.add("Phantom|No Such Thing", "at the section around it");
  try {
    findings.throw_if_any();
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_STREQ(error.what(), R"deck(3 mistakes in gel.xml
line 7, Materials|collagen|Label: no voxel has it
line 18, Grid|Element Size [um]: does not divide the body
line 22, Phantom|No Such Thing: at the section around it)deck");
  }
  EXPECT_EQ(document.line("Grid|Reset"), 19);
  EXPECT_EQ(document.line("Grid"), 17);
}

TEST(DeckRead, DeclaringANameTwiceIsAMistakeOfTheProgrammer) {
  Section<Solver> solver("Solver", "");
  solver.optional("Seed", &Solver::seed, any(), "");
  EXPECT_THROW(solver.optional("Seed", &Solver::seed, any(), ""), std::logic_error);
  EXPECT_THROW(solver.free_list("Seed", &Solver::belos, ""), std::logic_error);
}

TEST(DeckFile, FormatFollowsTheEndingAndFoldersTheDeck) {
  const test::TemporaryFolder temporary;
  const std::filesystem::path& folder = temporary.path();
  for (const auto& [name, text] : {std::pair{"a.xml", xml}, {"b.yaml", yaml}, {"c.yml", yaml}}) {
    const std::filesystem::path path = folder / name;
    std::ofstream(path) << text;
    const Document document = load(path.string());
    expect_sample_values(read(document, declaration()));
    EXPECT_EQ(document.path(), path.string());
    EXPECT_EQ(document.folder(), folder.string());
    EXPECT_EQ(document.resolve("gel.tif"), (folder / "gel.tif").string());
    EXPECT_EQ(document.resolve("/data/gel.tif"), "/data/gel.tif");
  }
  EXPECT_EQ(parse(xml, Format::xml, "gel.xml").folder(), ".");
  EXPECT_EQ(parse(xml, Format::xml, "gel.xml").resolve("a.tif"), "a.tif");
}

TEST(DeckFile, WhatCannotBeReadIsAnInputError) {
  const auto message = [](const std::string& path) -> std::string {
    try {
      load(path);
      return "";
    } catch (const base::InputError& error) {
      return error.what();
    }
  };
  const test::TemporaryFolder folder;
  const std::string missing = folder / "missing/gel.xml";
  EXPECT_EQ(message(missing), "cannot read the deck '" + missing + "': No such file or directory");
  EXPECT_EQ(message(folder.path()),
            "cannot read the deck '" + folder.path().string() + "': it is a folder");
  EXPECT_EQ(message("/dev/null"),
            "cannot tell the format of the deck '/dev/null' by its name's ending; admissible: "
            ".xml, .yaml or .yml");
  const std::string empty = folder.write("empty.xml", "");
  EXPECT_EQ(message(empty),
            "1 mistake in " + empty + "\nline 1: not well-formed XML: no element found");
}

}  // namespace
}  // namespace stroma::deck::sample
