// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// deck.xml, the deck with every default written out, reads back to the same values.

#include <Teuchos_XMLParameterListHelpers.hpp>

#include "SampleDeck.hpp"
#include "support/TemporaryFolder.hpp"

namespace stroma::deck::sample {
namespace {

/// Writes a deck as a run does, and reads it back.
Sample written_and_read(const Sample& deck) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "filled.xml";
  Teuchos::writeParameterListToXmlFile(*filled(declaration(), deck), path);
  return read(load(path), declaration());
}

TEST(DeckFilled, RoundTrip) { expect_sample_values(written_and_read(read_text(xml))); }

TEST(DeckFilled, RoundTripOfWhatIsHardToWrite) {
  Sample deck = read_text(xml);
  deck.title = "a < b & \"c\" > 'd' \xC2\xB5m";
  deck.grid.element_size = {0.1, 1.0 / 3.0, 5e-324};
  deck.grid.fallback = Shape::linear;
  deck.phantom->radii = {1.7976931348623157e308, 0.1 + 0.2};
  deck.solver.tolerance = 1.0 / 7.0 / 10.0;
  deck.solver.seed = -9'223'372'036'854'775'807;
  const Sample again = written_and_read(deck);
  EXPECT_EQ(again.title, deck.title);
  EXPECT_EQ(again.grid.element_size, deck.grid.element_size);
  EXPECT_EQ(again.grid.fallback, Shape::linear);
  EXPECT_EQ(again.phantom->radii, deck.phantom->radii);
  EXPECT_EQ(again.solver.tolerance, deck.solver.tolerance);
  EXPECT_EQ(again.solver.seed, deck.solver.seed);
}

TEST(DeckFilled, DefaultsAreWrittenOut) {
  const auto list = filled(declaration(), read_text(small_xml()));
  EXPECT_EQ(list->name(), "Stroma");
  EXPECT_EQ(list->get<std::string>("Title"), "untitled");
  EXPECT_EQ(list->sublist("Grid").get<bool>("Reset"), false);
  EXPECT_EQ(list->sublist("Grid").get<std::string>("Shape Functions"), "Linear");
  EXPECT_EQ(list->sublist("Solver").get<double>("Newton Tolerance"), 1e-8);
  EXPECT_EQ(list->sublist("Solver").get<long long>("Seed"), 5'000'000'000);
  EXPECT_EQ(list->sublist("Materials").sublist("gel").get<int>("Label"), 0);
}

TEST(DeckFilled, WhatIsAbsentStaysAbsent) {
  const auto list = filled(declaration(), read_text(small_xml()));
  EXPECT_FALSE(list->isParameter("Phantom"));
  EXPECT_FALSE(list->sublist("Grid").isParameter("Fallback"));
  EXPECT_FALSE(list->sublist("Materials").sublist("gel").isParameter("Bulk Modulus [Pa]"));
  EXPECT_FALSE(list->sublist("Solver").isParameter("Belos"));
}

}  // namespace
}  // namespace stroma::deck::sample
