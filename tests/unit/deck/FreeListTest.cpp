// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Lists passed on to Trilinos packages: types, nesting, and names held against the package's own
/// list.

#include <Teuchos_StandardParameterEntryValidators.hpp>

#include "SampleDeck.hpp"
#include "stroma/deck/FreeList.hpp"

namespace stroma::deck::sample {
namespace {

struct Passing {
  Teuchos::RCP<Teuchos::ParameterList> content;
};

/// As a solver would say what it understands.
Teuchos::ParameterList understood() {
  Teuchos::ParameterList valid;
  valid.set("Tolerance", 1e-6);
  valid.set("Iterations", 100);
  valid.set("Verbose", false);
  valid.set("Output", "none");
  valid.set("Method", "CG", "which",
            Teuchos::rcp(new Teuchos::StringToIntegralParameterEntryValidator<int>(
                Teuchos::tuple<std::string>("CG", "GMRES"), "Method")));
  valid.set("Blocks", 1, "how many",
            Teuchos::rcp(new Teuchos::EnhancedNumberValidator<int>(1, 10)));
  valid.sublist("Line Search").set("Steps", 5);
  valid.sublist("Anything");
  return valid;
}

Section<Passing> passing() {
  Section<Passing> section("Deck", "");
  section.free_list("Solver", &Passing::content, "",
                    [](const Teuchos::ParameterList& list, Findings& findings) {
                      refuse_unknown(list, understood(), findings);
                    });
  return section;
}

Passing read_yaml(const std::string& inside) {
  return read(parse("Deck:\n  Solver:\n" + inside, Format::yaml, "s.yaml"), passing());
}

std::string complaint_about(const std::string& inside) {
  try {
    read_yaml(inside);
    return "";
  } catch (const base::InputError& error) {
    return error.what();
  }
}

TEST(DeckFreeList, WhatIsUnderstoodPasses) {
  const Passing read = read_yaml(
      "    Tolerance: 1e-9\n    Iterations: 5\n    Verbose: true\n    Output: all\n    Method: "
      "GMRES\n    Blocks: 10\n"
      "    Line Search: {Steps: 3}\n    Anything: {at: {all: [1.5, 2]}}\n");
  EXPECT_EQ(read.content->get<double>("Tolerance"), 1e-9);
  EXPECT_EQ(read.content->get<std::string>("Method"), "GMRES");
  EXPECT_EQ(entries<double>(read.content->sublist("Anything").sublist("at"), "all"),
            (std::vector<double>{1.5, 2.0}));
}

TEST(DeckFreeList, WhatIsNotUnderstoodIsNamedWithItsLine) {
  EXPECT_EQ(complaint_about("    Tolerence: 1e-9\n"
                            "    Iterations: 5.5\n"
                            "    Method: CGS\n"
                            "    Blocks: 11\n"
                            "    Line Search:\n"
                            "      Stepps: 3\n"
                            "    Direction: {}\n"
                            "    Verbose: {}\n"),
            R"deck(7 mistakes in s.yaml
line 3, Solver|Tolerence: no such parameter; did you mean "Tolerance"?
line 4, Solver|Iterations: is of type double; admissible: int
line 5, Solver|Method: found "CGS"; did you mean "CG"?
line 6, Solver|Blocks: found 11; this value is not admissible
line 8, Solver|Line Search|Stepps: no such parameter; did you mean "Steps"?
line 9, Solver|Direction: no such section; known here: "Tolerance", "Iterations", "Verbose", "Output", "Method", "Blocks", "Line Search", "Anything"
line 10, Solver|Verbose: is of type a section; admissible: bool)deck");
}

TEST(DeckFreeList, TypesInXml) {
  const std::string begin =
      "<ParameterList name=\"Deck\"><ParameterList name=\"Solver\"><ParameterList "
      "name=\"Anything\">";
  const std::string end = "</ParameterList></ParameterList></ParameterList>";
  const Document good =
      parse(begin +
                "<Parameter name=\"i\" type=\"int\" value=\"3\"/>"
                "<Parameter name=\"d\" type=\"double\" value=\"3\"/>"
                "<Parameter name=\"l\" type=\"long long\" value=\"3000000000\"/>"
                "<Parameter name=\"s\" type=\"string\" value=\"3\"/>"
                "<Parameter name=\"b\" type=\"Array(bool)\" value=\"{true, false}\"/>"
                "<Parameter name=\"a\" type=\"Array(string)\" value=\"{x, y}\"/>" +
                end,
            Format::xml, "s.xml");
  const Teuchos::ParameterList list = read(good, passing()).content->sublist("Anything");
  EXPECT_EQ(list.get<int>("i"), 3);
  EXPECT_EQ(list.get<double>("d"), 3.0);
  EXPECT_EQ(list.get<long long>("l"), 3'000'000'000);
  EXPECT_EQ(list.get<std::string>("s"), "3");
  EXPECT_EQ(entries<std::string>(list, "a"), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(entries<std::string>(list, "b"), (std::vector<std::string>{"true", "false"}));

  const Document bad =
      parse(begin +
                "<Parameter name=\"i\" type=\"int\" value=\"3.5\"/>\n"
                "<Parameter name=\"f\" type=\"real\" value=\"3\"/>\n"
                "<Parameter name=\"i\" type=\"int\" value=\"4\"/>\n"
                "<Parameter name=\"b\" type=\"Array(bool)\" value=\"{true, 1}\"/>" +
                end,
            Format::xml, "s.xml");
  try {
    read(bad, passing());
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_STREQ(error.what(), R"deck(4 mistakes in s.xml
line 1, Solver|Anything|i: "3.5" is not an integer
line 2, Solver|Anything|f: type="real" is no type of a deck; write type="string"
line 3, Solver|Anything|i: given twice; first on line 1
line 4, Solver|Anything|b: entry 2: "1" is not true or false)deck");
  }
}

TEST(DeckFreeList, YamlShowsTheType) {
  const Teuchos::ParameterList list =
      read_yaml(
          "    Anything: {i: 3, d: 3.0, e: 1e3, b: false, s: '3', l: 3000000000, w: word, ai: [1, "
          "2], ad: [1, 2.5], as: [1, x], ab: [true, "
          "false]}\n")
          .content->sublist("Anything");
  EXPECT_EQ(list.get<int>("i"), 3);
  EXPECT_EQ(list.get<double>("d"), 3.0);
  EXPECT_EQ(list.get<double>("e"), 1000.0);
  EXPECT_EQ(list.get<bool>("b"), false);
  EXPECT_EQ(list.get<std::string>("s"), "3");
  EXPECT_EQ(list.get<long long>("l"), 3'000'000'000);
  EXPECT_EQ(list.get<std::string>("w"), "word");
  EXPECT_EQ(entries<int>(list, "ai"), (std::vector<int>{1, 2}));
  EXPECT_EQ(entries<double>(list, "ad"), (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(entries<std::string>(list, "as"), (std::vector<std::string>{"1", "x"}));
  EXPECT_EQ(entries<std::string>(list, "ab"), (std::vector<std::string>{"true", "false"}));
}

}  // namespace
}  // namespace stroma::deck::sample
