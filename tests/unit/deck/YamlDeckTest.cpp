// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What is special about decks in YAML.

#include "SampleDeck.hpp"

namespace stroma::deck::sample {
namespace {

std::string one(const std::string& from, const std::string& to) {
  return only_complaint(with(yaml, from, to), Format::yaml);
}

TEST(YamlDeck, NotWellFormedNamesTheLine) {
  const auto of = [](const std::string& text) { return only_complaint(text, Format::yaml); };
  EXPECT_EQ(of("Stroma:\n  Grid: [1, 2\n  Title: x\n"),
            "line 3: not well-formed YAML: end of sequence flow not found");
  EXPECT_EQ(of("Stroma:\n  Title: x\n Grid: 3\n"),
            "line 3: not well-formed YAML: end of map not found");
  EXPECT_EQ(
      of("Stroma:\n\tTitle: x\n"),
      "line 2: not well-formed YAML: illegal map value; line 2 is indented by a tab; YAML takes blanks");
  EXPECT_EQ(of("Stroma:\n  gel: {Label: 0, Shear Modulus [Pa]: 500}\n"),
            "line 2: not well-formed YAML: end of map flow not found; within { }, names with [ ] "
            "stand in quotes");
  EXPECT_EQ(
      of("Stroma:\n  Label:0\n  Title: x\n"),
      "line 3: not well-formed YAML: illegal map value; \"name: value\" has a blank behind its "
      "colon, here and in the line before");
  EXPECT_EQ(
      of("Stroma:\n  Title: x\n  Grid: [1, 2\n"),
      "line 3: a map inside a list: \"Grid\" can only hold values (or is its bracket not closed?)");
}

TEST(YamlDeck, AQuoteThatIsNeverClosed) {
  const auto of = [](const std::string& text) { return only_complaint(text, Format::yaml); };
  const std::string told = "line 2: the quote that opens here is never closed";
  EXPECT_EQ(of("Stroma:\n  Title: \"x\n"), told);
  EXPECT_EQ(of("Stroma:\n  Title: 'x''\n  Grid: {}\n"), told);
  EXPECT_EQ(of("Stroma:\n  Title: \"x\\\"\n"), told);
  for (const char* title :
       {"\"it's \\\\\"", "'it''s \"'", "\"\"", "''", "|\n    it's", "\"\xC2\xB5\" # it's"}) {
    EXPECT_EQ(
        complaint(with(yaml, "\"gel & vessels, 10 %\"", title), Format::yaml).find("never closed"),
        std::string::npos)
        << title;
  }
}

TEST(YamlDeck, OneOuterKeyIsTheName) {
  for (const char* wrong : {"", "# nothing\n"}) {
    EXPECT_EQ(only_complaint(wrong, Format::yaml), "line 1: the deck is empty");
  }
  for (const char* wrong : {"Title: x\n", "Stroma: {}\nGrid: {}\n", "{}\n"}) {
    EXPECT_EQ(only_complaint(wrong, Format::yaml),
              "line 1: a YAML deck is one outer key, the deck's name, with everything else "
              "indented under it")
        << wrong;
  }
  EXPECT_EQ(only_complaint("Stroma\n", Format::yaml),
            "line 1: a YAML deck is a map: name, colon, content");
  EXPECT_EQ(only_complaint("- Stroma\n", Format::yaml),
            "line 1: a YAML deck is a map: name, colon, content");
  EXPECT_EQ(one("Stroma:", "Storma:"),
            "line 2: the outer list is named \"Storma\"; its name must be \"Stroma\"");
  EXPECT_EQ(complaint(std::string("%YAML 1.1\n---\n") + yaml + "...\n", Format::yaml), "");
  EXPECT_EQ(only_complaint(std::string(yaml) + "---\nStroma: {}\n", Format::yaml),
            "line 1: several YAML documents in one file");
}

TEST(YamlDeck, MistakesNameTheirLines) {
  EXPECT_EQ(one("520.8", "soft"),
            "line 7, Materials|collagen|Shear Modulus [Pa]: \"soft\" is not a number; admissible: "
            "a number > 0");
  EXPECT_EQ(one("Poisson Ratio", "Poison Ratio").find("not one mistake"), std::string::npos);
  EXPECT_EQ(one("      Label: 1\n", ""),
            "line 9, Materials|a vessel|Label: required, but missing; admissible: an integer >= 0");
  EXPECT_EQ(one("Label: 1", "Label: 1\n      Label: 2"),
            "line 11, Materials|a vessel|Label: given twice; first on line 10");
  EXPECT_EQ(one("a vessel", "collagen"),
            "line 9, Materials|collagen: given twice; first on line 5");
  EXPECT_EQ(one("Reset: true", "Reset: yes"),
            "line 15, Grid|Reset: \"yes\" is not true or false; admissible: true or false");
}

TEST(YamlDeck, QuotesMakeAString) {
  EXPECT_EQ(
      one("520.8", "'520.8'"),
      "line 7, Materials|collagen|Shear Modulus [Pa]: \"520.8\" is quoted: a string, not a number; "
      "admissible: a number > 0");
  EXPECT_EQ(one("Label: 0", "Label: \"0\""),
            "line 6, Materials|collagen|Label: \"0\" is quoted: a string, not an integer; "
            "admissible: an integer >= 0");
  EXPECT_EQ(one("Reset: true", "Reset: 'true'"),
            "line 15, Grid|Reset: \"true\" is quoted: a string, not true or false; admissible: "
            "true or false");
  EXPECT_EQ(read_text(with(yaml, "\"gel & vessels, 10 %\"", "2024"), Format::yaml).title, "2024");
}

TEST(YamlDeck, ListsAndScalarsAreNotInterchangeable) {
  EXPECT_EQ(
      one("[2.1, 2.1, 2]", "2.1"),
      "line 14, Grid|Element Size [um]: \"2.1\" is not a list; write [a, b, c]; admissible: 3 "
      "numbers, each > 0");
  EXPECT_EQ(one("[2.1, 2.1, 2]", "\"{2.1, 2.1, 2}\""),
            "line 14, Grid|Element Size [um]: \"{2.1, 2.1, 2}\" is not a list; write [a, b, c]; "
            "admissible: 3 numbers, each > 0");
  EXPECT_EQ(one("[2.1, 2.1, 2]", "{2, 1, 3}"),
            "line 14, Grid|Element Size [um]: is a parameter, not a section (in YAML a list is "
            "written [a, b]); admissible: 3 numbers, each > 0");
  EXPECT_EQ(
      one("520.8", "[520.8]"),
      "line 7, Materials|collagen|Shear Modulus [Pa]: is a list of 1; admissible: a number > 0");
  EXPECT_EQ(one("[2.1, 2.1, 2]", "[2.1, [2.1], 2]"),
            "line 14: a list inside a list: \"Element Size [um]\" can only hold values");
  EXPECT_EQ(one("[2.1, 2.1, 2]", "[2.1, {a: 1}, 2]"),
            "line 14: a map inside a list: \"Element Size [um]\" can only hold values "
            "(or is its bracket not closed?)");
}

TEST(YamlDeck, NoValue) {
  EXPECT_EQ(one("Label: 1", "Label:"),
            "line 10, Materials|a vessel|Label: has no value; admissible: an integer >= 0");
  EXPECT_EQ(one("Label: 1", "Label: ~"),
            "line 10, Materials|a vessel|Label: has no value; admissible: an integer >= 0");
  EXPECT_EQ(one("Reset: true", "Reset:"),
            "line 15, Grid|Reset: has no value; admissible: true or false");
  const std::string small =
      "Stroma:\n  Solver:\n  Grid: {\"Element Size [um]\": [1, 1, 1]}\n"
      "  Materials: {gel: {Label: 0, \"Shear Modulus [Pa]\": 1, Poisson Ratio: 0}}\n";
  EXPECT_EQ(only_complaint(small, Format::yaml),
            "line 2, Solver: is a section, not a parameter; an empty one is written {}");
  EXPECT_EQ(complaint(with(small, "Solver:", "Solver: {}"), Format::yaml), "");
}

TEST(YamlDeck, AnchorsTagsAndOddKeysAreRefused) {
  EXPECT_NE(one("Label: 0", "Label: &zero 0").find("line 6: anchors and aliases"),
            std::string::npos);
  EXPECT_NE(one("Label: 0", "Label: *zero").find("line 6"), std::string::npos);
  EXPECT_EQ(one("520.8", "!!float 520.8"),
            "line 7: YAML tags (!!type) have no place in a deck: the parameter has a type");
  EXPECT_EQ(one("Label: 0", "[a, b]: 0"), "line 6: a name can only be a plain text");
}

TEST(YamlDeck, ABottomlessDeckIsRefused) {
  std::string deep = "Stroma: ";
  for (int i = 0; i < 100000; ++i) deep += "{a: ";
  EXPECT_NE(complaint(deep, Format::yaml).find("1 mistake in gel.xml\nline 1: "),
            std::string::npos);
}

}  // namespace
}  // namespace stroma::deck::sample
