// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What is wrong with the XML itself.

#include "SampleDeck.hpp"

namespace stroma::deck::sample {
namespace {

TEST(XmlDeck, NotWellFormedNamesTheLine) {
  EXPECT_EQ(
      complaint(
          "<ParameterList name=\"Stroma\">\n<ParameterList name=\"Grid\">\n</ParameterLst>\n"),
      "1 mistake in gel.xml\nline 3: not well-formed XML: mismatched tag; "
      "the section \"Grid\" of line 2 is still open");
  EXPECT_EQ(complaint("<ParameterList name=\"Stroma\">\n<ParameterList name=\"Grid\">\n"),
            "1 mistake in gel.xml\nline 3: not well-formed XML: no element found; "
            "the section \"Grid\" of line 2 is still open");
  EXPECT_EQ(complaint(""), "1 mistake in gel.xml\nline 1: not well-formed XML: no element found");
  EXPECT_NE(complaint("II*\0 a TIFF").find("line 1: not well-formed XML"), std::string::npos);
  EXPECT_NE(
      complaint(with(small_xml(), "value=\"0\"", "value=\"0")).find("line 5: not well-formed"),
      std::string::npos);
  EXPECT_NE(complaint(with(small_xml(), "value=\"0\"", "value=\"0\" value=\"1\""))
                .find("duplicate attribute"),
            std::string::npos);
  EXPECT_NE(complaint(small_xml() + "<x/>").find("junk after document element"), std::string::npos);
}

TEST(XmlDeck, UnknownElements) {
  EXPECT_EQ(only_complaint(small_xml("<Paramter name=\"Title\" type=\"string\" value=\"x\"/>")),
            "line 1: no such element: <Paramter>; did you mean \"Parameter\"?");
  EXPECT_EQ(only_complaint(with(small_xml(), "<Parameter name=\"Label\"",
                                "<Note><Parameter/>inner text</Note><Parameter name=\"Label\"")),
            "line 4, Materials|gel: no such element: <Note>; known here: \"Parameter\", "
            "\"ParameterList\"");
  EXPECT_EQ(
      only_complaint(
          small_xml("<Parameter name=\"Title\" type=\"string\" value=\"x\"><b/></Parameter>")),
      "line 1: <b> inside a <Parameter>; a parameter is written <Parameter name= type= value=/>");
  EXPECT_EQ(complaint("<Stroma/>"),
            "1 mistake in gel.xml\nline 1: the outer element is <Stroma>; "
            "a deck begins with <ParameterList name=\"Stroma\">");
  EXPECT_EQ(only_complaint(small_xml("<Validators><Validator/></Validators>")),
            "line 1: <Validators> must be empty: a deck cannot bring its own rules");
}

TEST(XmlDeck, UnknownAndMissingAttributes) {
  const std::string label = R"deck(<Parameter name="Label" type="int" value="0"/>)deck";
  const auto of_label = [&](const std::string& written) {
    return only_complaint(with(small_xml(), label, written));
  };
  EXPECT_EQ(of_label(R"deck(<Parameter name="Label" type="int" value="0" unit="1"/>)deck"),
            "line 4, Materials|gel|Label: no such XML attribute: unit; known here: \"name\", "
            "\"type\", \"value\"");
  EXPECT_EQ(of_label(R"deck(<Parameter name="Label" type="int" Value="0"/>)deck"),
            "line 4, Materials|gel|Label: no such XML attribute: Value; did you mean \"value\"?");
  EXPECT_EQ(of_label(R"deck(<Parameter name="Label" value="0"/>)deck"),
            "line 4, Materials|gel|Label: has no type; "
            "write type=\"double\", \"int\", \"bool\", \"string\" or \"Array(...)\"");
  EXPECT_EQ(of_label(R"deck(<Parameter name="Label" type="int"/>)deck"),
            "line 4, Materials|gel|Label: has no value; write value=\"...\"");
  EXPECT_EQ(of_label(R"deck(<Parameter name="Label" type="int">0</Parameter>)deck")
                .find("not one mistake: 2"),
            0u);
  EXPECT_EQ(only_complaint(small_xml(R"deck(<Parameter type="int" value="0"/>)deck")),
            "line 1: a <Parameter> without a name");
  EXPECT_EQ(only_complaint(small_xml(R"deck(<ParameterList/>)deck")),
            "line 1: a <ParameterList> without a name");
  EXPECT_EQ(only_complaint(with(small_xml(), "name=\"Grid\"", "name=\"Grid\" kind=\"x\"")),
            "line 9, Grid: no such XML attribute: kind; known here: \"name\"");
  EXPECT_EQ(only_complaint(with(small_xml(), " name=\"Stroma\"", "")),
            "line 1: the outer list is named \"\"; its name must be \"Stroma\"");
}

TEST(XmlDeck, TextBetweenTheElements) {
  EXPECT_EQ(only_complaint(small_xml("\n  Title = \n  a &amp; b\n")),
            "line 2: text between the elements: \"Title = \\x0a  a & b\"; a value is written "
            "value=\"...\"");
}

TEST(XmlDeck, WhatTeuchosWritesIsAccepted) {
  const std::string deck = with(
      small_xml("<Validators/>"), R"deck(<Parameter name="Label")deck",
      R"deck(<Parameter docString="a label" id="3" isDefault="false" isUsed="true" name="Label")deck");
  EXPECT_EQ(complaint(with(deck, "name=\"Grid\"", "id=\"4\" name=\"Grid\"")), "");
}

TEST(XmlDeck, CommentsAndEncodings) {
  EXPECT_EQ(complaint("<!-- before -->" + small_xml("<!-- <Parameter> -->") + "<!-- after -->\n"),
            "");
  const std::string latin =
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" +
      small_xml("<Parameter name=\"Title\" type=\"string\" value=\"5 \xB5m\"/>");
  EXPECT_EQ(read_text(latin).title, "5 \xC2\xB5m");
  EXPECT_EQ(read_text("\xEF\xBB\xBF" + small_xml()).grid.element_size[0], 2.0);
  const std::string one_line =
      "<Parameter name=\"Title\" type=\"string\" value=\"a &lt; b&#32;c\"/>";
  EXPECT_EQ(read_text(small_xml(one_line)).title, "a < b c");
}

// Entities can blow up the memory, and nothing in a deck needs them.
TEST(XmlDeck, DocumentTypesAreRefused) {
  EXPECT_EQ(
      complaint("<!DOCTYPE a [<!ENTITY x \"xxxx\">]>\n" + small_xml()),
      "1 mistake in gel.xml\nline 1: a document type (<!DOCTYPE ...>) has no place in a deck");
}

TEST(XmlDeck, ABottomlessDeckIsRefused) {
  std::string deep = "<ParameterList name=\"Stroma\">";
  for (int i = 0; i < 100000; ++i) deep += "<ParameterList name=\"a\">";
  EXPECT_EQ(complaint(deep), "1 mistake in gel.xml\nline 1: sections are nested too deep");
}

}  // namespace
}  // namespace stroma::deck::sample
