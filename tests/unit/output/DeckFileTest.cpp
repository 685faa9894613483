// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// deck.xml reads back as the same list, digit by digit, in spite of the comment at its head.

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_XMLParameterListCoreHelpers.hpp>

#include "TemporaryFolder.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/DeckFile.hpp"

namespace stroma {
namespace {

TEST(DeckFile, ReadsBackAsTheSameList) {
  const TemporaryFolder folder;
  Teuchos::ParameterList deck("Stroma");
  deck.set("Title", std::string("gel & vessels <10 %>, \"clamped\""));
  auto& grid = deck.sublist("Grid");
  grid.set("Element Size [um]", Teuchos::Array<double>(Teuchos::tuple(2.1, 1.0 / 3.0, 1e-300)));
  grid.set("Reset", false);
  deck.sublist("Solver").set("Newton Tolerance", 0.1 + 0.2);
  deck.sublist("Loading").set("Steps", 10);

  output::write_deck(base::Communicator::world(), folder / "deck.xml", deck,
                     {{"file", "/a--b---.raw"}});
  const auto read = Teuchos::getParametersFromXmlFile(folder / "deck.xml");
  // Teuchos's own reader drops the name of the outermost list.
  EXPECT_NE(content_of(folder / "deck.xml").find("<ParameterList name=\"Stroma\""),
            std::string::npos);
  EXPECT_EQ(read->get<std::string>("Title"), deck.get<std::string>("Title"));
  EXPECT_EQ(read->sublist("Solver").get<double>("Newton Tolerance"), 0.1 + 0.2);
  const auto size = read->sublist("Grid").get<Teuchos::Array<double>>("Element Size [um]");
  EXPECT_EQ(size[1], 1.0 / 3.0);
  EXPECT_EQ(size[2], 1e-300);
  EXPECT_EQ(read->sublist("Loading").get<int>("Steps"), 10);
}

TEST(DeckFile, NamesTheVersionsItRanWith) {
  const TemporaryFolder folder;
  output::write_deck(base::Communicator::world(), folder / "deck.xml",
                     Teuchos::ParameterList("Stroma"), {{"ranks", "2"}, {"SHA-256", "00ff"}});
  const std::string text = content_of(folder / "deck.xml");
  for (const auto& [name, fact] : output::program_facts()) {
    const std::string line = "     " + name + ": " + std::string(8 - name.size(), ' ') + fact;
    EXPECT_NE(text.find(line + "\n"), std::string::npos) << line << "\n" << text;
  }
  EXPECT_NE(text.find("\n\n     ranks:    2\n     SHA-256:  00ff\n-->\n"), std::string::npos)
      << text;
}

TEST(DeckFile, FullDiskIsARunErrorOnEveryRank) {
  EXPECT_EQ(message_of<base::RunError>([&] {
              output::write_deck(base::Communicator::world(), "/dev/full",
                                 Teuchos::ParameterList("Stroma"), {});
            }),
            "cannot write '/dev/full': No space left on device");
}

}  // namespace
}  // namespace stroma
