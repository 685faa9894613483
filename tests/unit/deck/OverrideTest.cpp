// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// --set: values laid over the deck from the command line, or by a study.

#include "SampleDeck.hpp"

namespace stroma::deck::sample {
namespace {

std::string one(const std::string& override_text) {
  return only_complaint(xml, Format::xml, {override_text});
}

TEST(DeckOverride, ReplacesAndAdds) {
  for (const Format format : {Format::xml, Format::yaml}) {
    const Sample deck =
        read_text(format == Format::xml ? xml : yaml, format,
                  {"Title=a = b", "Materials|a vessel|Label=7", "Grid|Element Size [um]={1, 2, 3}",
                   "Phantom|Radii [um]=[0.5]", "Grid|Fallback=GIMP", "Solver|Newton Tolerance=1e-3",
                   "Solver|Belos|Deeper|Flag=true", "Solver|Belos|Maximum Iterations=7"});
    EXPECT_EQ(deck.title, "a = b");
    EXPECT_EQ(deck.materials.all[1].second.label, 7);
    EXPECT_EQ(deck.grid.element_size, (std::array<double, 3>{1, 2, 3}));
    EXPECT_EQ(deck.grid.fallback, Shape::gimp);
    EXPECT_EQ(deck.phantom->radii, std::vector<double>{0.5});
    EXPECT_EQ(deck.solver.tolerance, 1e-3);
    EXPECT_TRUE(deck.solver.belos->sublist("Deeper").get<bool>("Flag"));
    EXPECT_EQ(deck.solver.belos->get<int>("Maximum Iterations"), 7);
  }
}

TEST(DeckOverride, MakesASectionThatTheDeckLeftOut) {
  const Sample deck =
      read_text(small_xml(), Format::xml, {"Phantom|Size={2,2,2}", "Solver|Newton Tolerance=0.01"});
  ASSERT_TRUE(deck.phantom.has_value());
  EXPECT_EQ(deck.phantom->size, (std::array<int, 3>{2, 2, 2}));
  EXPECT_EQ(deck.solver.tolerance, 0.01);
}

TEST(DeckOverride, MendsAValueThatIsWrongInTheFile) {
  EXPECT_EQ(complaint(with(xml, "520.8", "soft"), Format::xml,
                      {"Materials|collagen|Shear Modulus [Pa]=500"}),
            "");
}

TEST(DeckOverride, MistakesSayWhereTheyComeFrom) {
  EXPECT_EQ(one("Grid|Reset=maybe"),
            "--set, Grid|Reset: \"maybe\" is not true or false; admissible: true or false");
  EXPECT_EQ(one("Grid|Rest=true"), "--set, Grid|Rest: no such parameter; did you mean \"Reset\"?");
  EXPECT_EQ(one("Gird|Reset=true"), "--set, Gird: no such section; did you mean \"Grid\"?");
  EXPECT_EQ(one("Materials|colagen|Label=1"),
            "--set, Materials|colagen: no such section in the deck; did you mean \"collagen\"?");
  EXPECT_EQ(one("Grid|Reset"), "--set: \"Grid|Reset\" has no '='; write Section|Parameter=value");
  EXPECT_EQ(one("Grid=true"), "--set, Grid: is a section; name a parameter in it");
  EXPECT_EQ(one("Title|Text=x"), "--set, Title|Text: \"Title\" is a parameter, not a section");
  EXPECT_EQ(one("Grid|Element Size [um]=2"),
            "--set, Grid|Element Size [um]: \"2\" is not a list; write {a, b, c}; admissible: 3 "
            "numbers, each > 0");
  for (const char* wrong : {"=1", "Grid|=1", "|Reset=1", "Grid||Reset=1"}) {
    EXPECT_NE(one(wrong).find("a part of the name is empty"), std::string::npos) << wrong;
  }
  EXPECT_EQ(only_complaint(xml, Format::xml, {"Title=a", "Title=b"}),
            "--set, Title: given twice on the command line");
}

TEST(DeckOverride, MistakesOfTheFileComeFirst) {
  EXPECT_EQ(complaint(with(xml, "520.8", "soft"), Format::xml, {"Grid|Reset=maybe"}),
            "2 mistakes in gel.xml\n"
            "line 8, Materials|collagen|Shear Modulus [Pa]: \"soft\" is not a number; admissible: "
            "a number > 0\n"
            "--set, Grid|Reset: \"maybe\" is not true or false; admissible: true or false");
}

TEST(DeckOverride, AStudyLaysValuesOverACopy) {
  const Document base = parse(xml, Format::xml, "gel.xml");
  for (const std::string modulus : {"100", "200.5"}) {
    Document varied = base;
    set_parameter(varied, "Materials|collagen|Shear Modulus [Pa]", modulus);
    EXPECT_EQ(read(varied, declaration()).materials.all[0].second.shear_modulus,
              std::stod(modulus));
  }
  expect_sample_values(read(base, declaration()));
}

}  // namespace
}  // namespace stroma::deck::sample
