// SPDX-License-Identifier: BSD-3-Clause

#include "SampleDeck.hpp"

namespace stroma::deck::sample {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(DeckReference, OneSectionInFull) {
  EXPECT_EQ(reference(declaration(), "Grid"), R"deck(## Grid

The background grid.

- `Element Size [um]`: Array(double); 3 numbers, each > 0; required
  Sides of an element.
- `Reset`: bool; true or false; default false
  Back to the Cartesian grid after a step.
- `Shape Functions`: string; "Linear" or "GIMP"; default "Linear"
  Which.
- `Fallback`: string; "Linear" or "GIMP"; absent by default
  Else.

)deck");
}

TEST(DeckReference, TheWholeDeck) {
  const std::string all = reference(declaration());
  EXPECT_EQ(all, reference(declaration(), "Stroma"));
  for (const char* part :
       {"## Stroma\n\nA simulation.",
        "- `Title`: string; a string that is not empty; default \"untitled\"",
        "## Materials (required)", "## Materials|NAME (named by you, at least 1)",
        "- `Poisson Ratio`: double; a number > -1 and < 0.5; absent by default",
        "## Phantom (may be absent)",
        "- `Size`: Array(int); 3 integers, each > 0; default {4, 4, 4}",
        "- `Radii [um]`: Array(double); a list of numbers, each >= 0; default {1.5, 0.1}",
        "- `Tags`: Array(string); a list of strings; default {}",
        "- `Seed`: long long; an integer; default 5000000000",
        "- `Newton Tolerance`: double; a number from 1e-14 to 0.1; default 1e-08",
        "## Solver|Belos (may be absent; passed on as it is)\n\nPassed on to Belos."}) {
    EXPECT_TRUE(has(all, part)) << part << "\n" << all;
  }
}

TEST(DeckReference, ASectionBringsWhatIsInside) {
  const std::string solver = reference(declaration(), "Solver");
  EXPECT_TRUE(has(solver, "## Solver|Belos"));
  EXPECT_FALSE(has(solver, "## Grid"));
  EXPECT_TRUE(has(reference(declaration(), "Materials|NAME"), "Shear Modulus [Pa]"));
}

TEST(DeckReference, UnknownSection) {
  try {
    reference(declaration(), "Gird");
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_STREQ(error.what(), "no such section of the deck: \"Gird\"; did you mean \"Grid\"?");
  }
}

// A default is what the struct around says, not what the section's own struct says.
TEST(DeckReference, DefaultsComeFromTheStructAround) {
  struct Inner {
    double x = 1;
  };
  struct Outer {
    Inner inner{2};
  };
  Section<Inner> inner("Inner", "");
  inner.optional("X", &Inner::x, any(), "");
  Section<Outer> outer("Outer", "");
  outer.section(inner, &Outer::inner);
  EXPECT_TRUE(has(reference(outer), "default 2"));
  EXPECT_EQ(
      read(parse("<ParameterList name=\"Outer\"><ParameterList name=\"Inner\"/></ParameterList>",
                 Format::xml),
           outer)
          .inner.x,
      2);
}

}  // namespace
}  // namespace stroma::deck::sample
