// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Curves of a study are told apart: no two look alike, and the legend names what they show.

#include <gtest/gtest.h>

#include <set>

#include "stroma/output/pictures/CurveStyles.hpp"

namespace stroma::output {
namespace {

/// Every combination of the things' alternatives.
std::vector<CurveName> curves_of(const std::vector<CurveThing>& things) {
  std::vector<CurveName> curves{{"", {}}};
  for (const CurveThing& thing : things) {
    std::vector<CurveName> longer;
    for (const CurveName& curve : curves)
      for (std::size_t n = 0; n < thing.alternatives.size(); ++n) {
        CurveName next = curve;
        next.name += (next.name.empty() ? "" : ", ") + thing.alternatives[n];
        next.alternative.push_back(n);
        longer.push_back(next);
      }
    curves = longer;
  }
  return curves;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) ++found;
  return found;
}

const CurveThing grid{"grid", {"8 px", "4 px", "2 px"}}, mode{"mode", {"reset", "no reset"}},
    specimen{"specimen", {"with vessels", "collagen only"}}, grip{"grip", {"clamped", "rollers"}},
    same{"same", {"always"}};

// V-STUDY-PICTURES.
TEST(CurveStyles, HaveALegendByThings) {
  const std::vector<CurveThing> things{mode, grid, same, specimen};
  const CurveStyles styles = curve_styles(things, curves_of(things));
  ASSERT_EQ(styles.style.size(), 12u);
  EXPECT_EQ(std::set<std::string>(styles.style.begin(), styles.style.end()).size(), 12u);
  for (const std::string& title : styles.title) EXPECT_EQ(title, "notitle");
  // Three columns of a heading and three lines; what has two alternatives gets a blank one.
  EXPECT_EQ(styles.key_lines, 4);
  EXPECT_EQ(count(styles.legend, "keyentry"), 12u);
  EXPECT_EQ(count(styles.legend, "keyentry title ' '"), 2u);
  EXPECT_EQ(styles.legend.find("always"), std::string::npos);
  for (const char* text : {"'mode:'", "'grid:'", "'specimen:'", "'no reset'", "'collagen only'"})
    EXPECT_NE(styles.legend.find(text), std::string::npos) << text;
  EXPECT_EQ(count(styles.legend, "lines lw 5 lc"), 3u);  // the grid has the colours
}

TEST(CurveStyles, TakeTheSmallestThingsTogether) {
  const std::vector<CurveThing> things{grid, mode, specimen, grip};
  const CurveStyles styles = curve_styles(things, curves_of(things));
  EXPECT_EQ(std::set<std::string>(styles.style.begin(), styles.style.end()).size(), 24u);
  EXPECT_NE(styles.legend.find("'mode, specimen:'"), std::string::npos) << styles.legend;
  EXPECT_NE(styles.legend.find("'no reset, collagen only'"), std::string::npos) << styles.legend;
}

TEST(CurveStyles, ListTheValuesOfOneThing) {
  CurveThing modulus{"Shear Modulus [Pa]", {}};
  for (int n = 1; n <= 24; ++n) modulus.alternatives.push_back(std::to_string(100 * n));
  const CurveStyles styles = curve_styles({modulus}, curves_of({modulus}));
  EXPECT_EQ(std::set<std::string>(styles.style.begin(), styles.style.end()).size(), 24u);
  EXPECT_EQ(styles.legend, "");
  EXPECT_EQ(styles.title[23], "title '2400'");
  EXPECT_LT(styles.key_lines, 24);  // several columns
}

TEST(CurveStyles, ListCurvesWhereDashesDoNotSuffice) {
  CurveThing strain{"Strain", {"1", "2", "3", "4", "5", "6"}};
  const std::vector<CurveThing> things{strain, {"Steps", {"a", "b", "c", "d", "e", "f"}}};
  const CurveStyles styles = curve_styles(things, curves_of(things));
  EXPECT_EQ(styles.legend, "");
  EXPECT_EQ(styles.title[7], "title '2, b'");
  EXPECT_EQ(styles.style.size(), 36u);
}

TEST(CurveStyles, OfOneCurveAndOfNone) {
  EXPECT_EQ(curve_styles({same}, curves_of({same})).style.size(), 1u);
  EXPECT_EQ(curve_styles({grid}, {}).style.size(), 0u);
}

}  // namespace
}  // namespace stroma::output
