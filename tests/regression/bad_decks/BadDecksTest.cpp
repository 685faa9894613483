// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Every deck of tests/decks/bad holds one mistake. The program must end with exit status 2, name
/// the mistake on standard error in a few plain lines, and leave nothing behind.
///
/// Beside NAME.xml or NAME.yaml stands NAME.expected: each line a text that standard error must
/// contain; a line 'command: check' asks for another subcommand than run.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

const fs::path corpus = clone_folder() / "tests" / "decks" / "bad";

bool is_deck(const fs::path& path) {
  return path.extension() == ".xml" || path.extension() == ".yaml" || path.extension() == ".yml";
}

std::vector<fs::path> all_decks() {
  std::vector<fs::path> decks;
  for (const fs::directory_entry& entry : fs::directory_iterator(corpus)) {
    if (is_deck(entry.path())) decks.push_back(entry.path());
  }
  std::sort(decks.begin(), decks.end());
  return decks;
}

struct Expected {
  std::string command = "run";
  std::vector<std::string> texts;
};

Expected expected_of(fs::path deck) {
  Expected expected;
  std::stringstream lines(content_of(deck.replace_extension(".expected")));
  const std::string command = "command: ";
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(command, 0) == 0) {
      expected.command = line.substr(command.size());
    } else if (!line.empty()) {
      expected.texts.push_back(line);
    }
  }
  return expected;
}

class BadDeck : public ::testing::TestWithParam<fs::path> {};

// V-BAD.
TEST_P(BadDeck, EndsWithAPlainMessage) {
  const fs::path deck = GetParam();
  const Expected expected = expected_of(deck);
  ASSERT_FALSE(expected.texts.empty()) << "no " << deck.stem() << ".expected, or an empty one";

  const TemporaryFolder working_folder;
  const Outcome outcome = run_stroma(working_folder.path(), expected.command + " " + quoted(deck));
  const std::string told = "standard error:\n" + outcome.standard_error;

  EXPECT_EQ(outcome.status, 2) << told;
  for (const std::string& text : expected.texts) {
    EXPECT_NE(outcome.standard_error.find(text), std::string::npos) << "not told: " << text << "\n"
                                                                    << told;
  }

  const std::ptrdiff_t lines =
      std::count(outcome.standard_error.begin(), outcome.standard_error.end(), '\n');
  EXPECT_LE(lines, 6) << "one mistake needs a few lines only\n" << told;
  for (const char* banner :
       {"MPI_ABORT", "MPI_Abort", "mpirun", "terminate called", "received signal",
        "Kokkos::", "Teuchos::", "std::", "Throw number", "core dumped"}) {
    EXPECT_EQ(outcome.standard_error.find(banner), std::string::npos) << banner << "\n" << told;
    EXPECT_EQ(outcome.standard_output.find(banner), std::string::npos) << banner;
  }

  EXPECT_TRUE(fs::is_empty(working_folder.path())) << "something was written";
  EXPECT_FALSE(fs::exists(corpus / deck.stem())) << "an output folder was made beside the deck";
}

std::string test_name(const ::testing::TestParamInfo<fs::path>& deck) {
  return deck.param.stem().string() + "_" + deck.param.extension().string().substr(1);
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadDeck, ::testing::ValuesIn(all_decks()), test_name);

TEST(BadDeckCorpus, IsCompleteAndHasNoOrphans) {
  const std::vector<fs::path> decks = all_decks();
  EXPECT_GE(decks.size(), 40u);
  std::set<fs::path> stems;
  for (const fs::path& deck : decks) {
    EXPECT_TRUE(stems.insert(deck.stem()).second) << deck << ": two decks share one .expected";
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(corpus)) {
    if (entry.path().extension() != ".expected") continue;
    EXPECT_EQ(stems.count(entry.path().stem()), 1u) << entry.path() << " has no deck";
  }
}

}  // namespace
}  // namespace stroma::test
