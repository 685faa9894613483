// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A parameter that is a list or, in its place, a word: declared once, read from XML and YAML, as
/// strict as any other.

#include <gtest/gtest.h>

#include <Teuchos_XMLParameterListHelpers.hpp>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "stroma/base/Error.hpp"
#include "stroma/deck/Document.hpp"
#include "stroma/deck/Section.hpp"

namespace stroma::deck {
namespace {

using List = std::vector<int>;

struct Sample {
  std::variant<List, std::string> which = List{1, 2};
};

Section<Sample> declaration() {
  Section<Sample> section("Stroma", "A sample.");
  section.optional("Which", &Sample::which, or_one_of(not_negative(), {"Dark", "Bright"}), "Some.");
  return section;
}

Sample from_yaml(const std::string& value) {
  return read(parse("Stroma:\n  Which: " + value + "\n", Format::yaml, "deck.yaml"), declaration());
}

Sample from_xml(const std::string& type, const std::string& value) {
  return read(parse("<ParameterList name=\"Stroma\"><Parameter name=\"Which\" type=\"" + type +
                        "\" value=\"" + value + "\"/></ParameterList>",
                    Format::xml, "deck.xml"),
              declaration());
}

template <class Read>
std::string refusal(Read&& read_it) {
  try {
    read_it();
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(DeckListOrWord, IsReadFromBothFormats) {
  EXPECT_EQ(std::get<List>(from_yaml("[3, 0]").which), (List{3, 0}));
  EXPECT_EQ(std::get<std::string>(from_yaml("Dark").which), "Dark");
  EXPECT_EQ(std::get<List>(from_xml("Array(int)", "{3, 0}").which), (List{3, 0}));
  EXPECT_EQ(std::get<std::string>(from_xml("string", "Bright").which), "Bright");
}

TEST(DeckListOrWord, IsStrict) {
  const std::string admissible =
      "admissible: a list of one or more integers, each >= 0, or \"Dark\" or \"Bright\"";
  for (const char* wrong : {"Dusk", "3", "[]", "[-1]", "[1.5]", "[Dark]", "{}"}) {
    const std::string said = refusal([&] { from_yaml(wrong); });
    EXPECT_NE(said, "accepted") << wrong;
    EXPECT_TRUE(said.find(admissible) != std::string::npos || std::string(wrong) == "{}") << said;
  }
  for (const char* type : {"int", "double", "Array(double)", "Array(string)", "bool"}) {
    const std::string said = refusal([&] { from_xml(type, "{1}"); });
    EXPECT_NE(said.find("write type=\"Array(int)\""), std::string::npos) << said;
  }
  EXPECT_NE(refusal([&] { from_xml("string", "dark"); }).find("did you mean \"Dark\""),
            std::string::npos);
  EXPECT_NE(refusal([&] { from_xml("Array(int)", "Dark"); }).find("is not a list"),
            std::string::npos);
}

TEST(DeckListOrWord, ReadsBackFromTheDeckThatIsWritten) {
  const std::string path =
      (std::filesystem::temp_directory_path() / "stroma_list_or_word_test.xml").string();
  for (const Sample& sample : {Sample{List{7}}, Sample{std::string("Dark")}}) {
    Teuchos::writeParameterListToXmlFile(*filled(declaration(), sample), path);
    EXPECT_EQ(read(load(path), declaration()).which, sample.which);
    std::filesystem::remove(path);
  }
}

TEST(DeckListOrWord, StandsInTheReference) {
  EXPECT_NE(reference(declaration())
                .find("- `Which`: Array(int) or string; a list of one or more "
                      "integers, each >= 0, or \"Dark\" or \"Bright\"; "
                      "default {1, 2}"),
            std::string::npos)
      << reference(declaration());
}

}  // namespace
}  // namespace stroma::deck
