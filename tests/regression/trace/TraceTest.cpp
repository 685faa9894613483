// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What a run can be traced back to: program, machine, and every file of its images.

#include <gtest/gtest.h>

#include <ctime>
#include <regex>

#include "support/Places.hpp"
#include "support/SmallDeck.hpp"
#include "support/WriteStack.hpp"

namespace stroma::test {
namespace {

/// The comment at the head of a deck.xml.
std::string head_of(const fs::path& deck) {
  const std::string text = content_of(deck);
  return text.substr(0, text.find("-->\n"));
}

/// The first line of a command's output.
std::string answer(const TemporaryFolder& folder, const std::string& command) {
  const std::string output = run_script(folder, command).standard_output;
  return output.substr(0, output.find('\n'));
}

/// What a list says of a name; empty if nothing.
std::string fact(const std::string& list, const std::string& name) {
  std::smatch found;
  return std::regex_search(list, found, std::regex("(^|\n) *" + name + ": +([^\n]*)\n"))
             ? found[2].str()
             : "";
}

/// A deck with an image of labels and stiffness from another one, each with its values in a file
/// beside the header.
std::string deck_of_images() {
  std::string deck = small_deck();
  const std::size_t begin = deck.find("    Phantom:"), end = deck.find("  Materials:");
  deck.replace(begin, end - begin,
               "    File: labels--1.mhd\n    Voxel Size [um]: [1.0, 1.0, 1.0]\n"
               "    Segmentation: {Method: Labels}\n");
  const std::string stiffness = "      Shear Modulus [Pa]: 500.0\n";
  deck.replace(deck.find(stiffness), stiffness.size(),
               stiffness +
                   "      Fields:\n        shade:\n          Parameter: Shear Modulus [Pa]\n"
                   "          Image: shade.mhd\n          Intensities: [0, 255]\n"
                   "          Values: [400, 600]\n");
  return deck;
}

class Trace : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("gel.yaml", deck_of_images());
    write_stack<std::uint8_t>(folder_, "labels--1", {8, 8, 8},
                              [](int i, int, int) { return i < 4 ? 0 : 1; });
    write_stack<std::uint8_t>(folder_, "shade", {8, 8, 8},
                              [](int i, int j, int k) { return 16 * i + 4 * j + k; });
  }

  const TemporaryFolder folder_;
};

// V-TRACE-1.
TEST_F(Trace, EveryFileOfAnImageIsListedWithItsSizeAndSha256) {
  const Outcome outcome = run_stroma(folder_.path(), "run gel.yaml -o out --quiet", 2);
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  const std::string head = head_of(folder_ / "out/deck.xml");
  const fs::path folder = fs::absolute(folder_.path());
  std::size_t files = 0;
  for (const char* name : {"labels--1.mhd", "labels--1.raw", "shade.mhd", "shade.raw"}) {
    SCOPED_TRACE(name);
    const std::string sum = answer(folder_, std::string("sha256sum < ") + name).substr(0, 64);
    std::string listed = (folder / name).string();  // XML allows no two hyphens there
    const std::size_t hyphens = listed.find("--");
    if (hyphens != std::string::npos) listed.replace(hyphens, 2, "- ");
    const std::string lines = "     file:     " + listed +
                              "\n     bytes:    " + std::to_string(fs::file_size(folder / name)) +
                              "\n     SHA-256:  " + sum + "\n";
    EXPECT_NE(head.find(lines), std::string::npos) << lines << head;
    ++files;
  }
  const std::regex any("\n *file: ");
  EXPECT_EQ(std::distance(std::sregex_iterator(head.begin(), head.end(), any), {}),
            static_cast<std::ptrdiff_t>(files));
}

// V-TRACE-1.
TEST_F(Trace, RanksThreadsHostAndStartAreListed) {
  const std::time_t before = std::time(nullptr);
  ASSERT_EQ(run_stroma(folder_.path(), "run gel.yaml -o out --quiet", 2).status, 0);
  const std::string head = head_of(folder_ / "out/deck.xml");
  EXPECT_EQ(fact(head, "ranks"), "2");
  EXPECT_EQ(fact(head, "threads"), std::to_string(threads_of_test()) + " a rank");
  EXPECT_EQ(fact(head, "hosts"), "1 (" + answer(folder_, "uname -n") + ")");
  std::tm parts{};
  ASSERT_NE(strptime(fact(head, "start").c_str(), "%Y-%m-%dT%H:%M:%SZ", &parts), nullptr) << head;
  EXPECT_GE(timegm(&parts), before);
  EXPECT_LE(timegm(&parts), std::time(nullptr));
}

// V-TRACE-1.
TEST_F(Trace, DeckXmlRunsAgainToTheSameResult) {
  ASSERT_EQ(run_stroma(folder_.path(), "run gel.yaml -o first --quiet").status, 0);
  const Outcome again = run_stroma(folder_.path(), "run first/deck.xml -o again --quiet");
  ASSERT_EQ(again.status, 0) << again.standard_error;
  const auto deck_in = [&](const char* folder) {
    const std::string text = content_of(folder_ / folder / "deck.xml");
    return text.substr(text.find("-->\n"));
  };
  EXPECT_EQ(deck_in("first"), deck_in("again"));
  const History first(folder_ / "first/history.csv"), second(folder_ / "again/history.csv");
  EXPECT_EQ(first["top.reaction_y"], second["top.reaction_y"]);
}

// V-TRACE-1.
TEST_F(Trace, TheProgramSaysOfItselfWhatDeckXmlSaysOfIt) {
  const std::string brief = run_stroma(folder_.path(), "--version").standard_output;
  const Outcome verbose = run_stroma(folder_.path(), "--version --verbose");
  ASSERT_EQ(verbose.status, 0) << verbose.standard_error;
  const std::string list = verbose.standard_output;
  EXPECT_EQ(run_stroma(folder_.path(), "--verbose --version").standard_output, list);
  EXPECT_EQ(brief, "stroma " + fact(list, "Stroma") + "\n");

  ASSERT_EQ(run_stroma(folder_.path(), "run gel.yaml -o out --quiet").status, 0);
  const std::string head = head_of(folder_ / "out/deck.xml");
  for (const char* name : {"Stroma", "commit", "compiler", "build", "options", "Trilinos", "Kokkos",
                           "MPI", "HDF5", "Exodus"}) {
    EXPECT_NE(fact(list, name), "") << name << "\n" << list;
    EXPECT_EQ(fact(list, name), fact(head, name));
  }

  EXPECT_TRUE(std::regex_match(fact(list, "commit"), std::regex("unknown|[0-9a-f]{12,}(-dirty)?")))
      << list;
  const std::string commit =
      answer(folder_, "cd " + quoted(clone_folder()) +
                          " && [[ $(git rev-parse --show-toplevel) -ef . ]] && git rev-parse HEAD");
  if (!commit.empty()) {
    EXPECT_EQ(fact(list, "commit").substr(0, 12), commit.substr(0, 12));
  }
}

TEST_F(Trace, VerboseAloneIsAMistake) {
  const Outcome outcome = run_stroma(folder_.path(), "--verbose run gel.yaml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.standard_error.find("--verbose requires --version"), std::string::npos)
      << outcome.standard_error;
}

}  // namespace
}  // namespace stroma::test
