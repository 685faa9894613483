// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Names and texts that deck.xml cannot hold are mistakes, wherever they come from.

#include "SampleDeck.hpp"
#include "stroma/deck/PlainText.hpp"

namespace stroma::deck::sample {
namespace {

TEST(PlainText, IsOneLineOfUtf8AsXmlKnowsIt) {
  for (const char* text :
       {"", "gel, 10 %", "\xC2\xB5m", "\xE2\x82\xAC", "\xF0\x9F\x94\xAC", "\x7F"})
    EXPECT_EQ(unwritable(text), "") << text;
  const std::pair<const char*, const char*> bad[] = {
      {"a\x01"
       "b",
       "\"a\\x01b\" holds a control character"},
      {"a\tb", "\"a\\x09b\" holds a control character"},
      {"a\nb", "\"a\\x0ab\" holds a line break"},
      {"\xB5m", "\"\\xb5m\" holds bytes that are not UTF-8"},        // Latin-1
      {"\xC2", "\"\\xc2\" holds bytes that are not UTF-8"},          // cut short
      {"\xC0\xAF", "\"\\xc0\\xaf\" holds bytes that are not UTF-8"}  // longer than need be
      ,
      {"\xED\xA0\x80", "\"\\xed\\xa0\\x80\" holds bytes that are not UTF-8"},  // half a pair
      {"\xEF\xBF\xBF", "\"\\xef\\xbf\\xbf\" holds a character that XML does not admit"},  // U+FFFF
      {"\xF4\x90\x80\x80", "\"\\xf4\\x90\\x80\\x80\" holds bytes that are not UTF-8"}};
  for (const auto& [text, told] : bad)
    EXPECT_EQ(unwritable(text), std::string(told) + "; admissible: one line of text, in UTF-8");
}

std::string complaint(const std::string& text, Format format,
                      const std::vector<std::string>& overrides = {}) {
  try {
    read(parse(text, format, "deck", overrides), declaration());
    return "";
  } catch (const base::InputError& error) {
    return error.what();
  }
}

// V-SAME.
TEST(PlainText, IsAskedOfEveryNameAndText) {
  const std::string deck = yaml;
  EXPECT_EQ(complaint(deck, Format::yaml), "");
  EXPECT_EQ(complaint(deck, Format::yaml, {"Title=a\x01"}),
            "1 mistake in deck\n--set, Title: \"a\\x01\" holds a control character; admissible: "
            "one line of text, in UTF-8");
  EXPECT_NE(complaint(deck, Format::yaml, {"Phantom|Tags={a, \xB5}"}).find("--set, Phantom|Tags: "),
            std::string::npos);
  EXPECT_NE(complaint("Stroma:\n  \"Mat\\x07erials\": {}\n", Format::yaml)
                .find("line 2: \"Mat\\x07erials\" holds a control character"),
            std::string::npos);
  EXPECT_NE(complaint("Stroma:\n  Materials:\n    \"\\x07\":\n      Label: 0\n", Format::yaml)
                .find("line 3, Materials: \"\\x07\" holds a control character"),
            std::string::npos);
  EXPECT_NE(complaint("Stroma:\n  Solver:\n    Belos:\n      a: \"\\x1b[31m\"\n", Format::yaml)
                .find("line 4, Solver|Belos|a: \"\\x1b[31m\" holds a control character"),
            std::string::npos);
}

TEST(PlainText, NamesHaveAtMost200Bytes) {
  const auto deck_with = [](std::size_t bytes) {
    return "Stroma:\n  Grid:\n    Element Size [um]: [1, 1, 1]\n  Materials:\n    " +
           std::string(bytes, 'g') +
           ":\n      Label: 0\n      Shear Modulus [Pa]: 1\n      Poisson Ratio: 0.3\n";
  };
  EXPECT_EQ(complaint(deck_with(200), Format::yaml), "");
  EXPECT_EQ(complaint(deck_with(201), Format::yaml),
            "1 mistake in deck\nline 5, Materials: the name \"gggggggggggggggggggg...\" has 201 "
            "bytes; admissible: at most 200, for it appears in tables and result files");
}

}  // namespace
}  // namespace stroma::deck::sample
