// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What a run could not write is refused by `check` as it is by `run`.

#include <gtest/gtest.h>

#include "support/Places.hpp"
#include "support/SmallDeck.hpp"

namespace stroma::test {
namespace {

void expect_both_refuse(const TemporaryFolder& folder, const std::string& arguments,
                        const std::string& told) {
  SCOPED_TRACE(arguments);
  const Outcome check = run_stroma(folder.path(), "check " + arguments);
  const Outcome run = run_stroma(folder.path(), "run " + arguments);
  EXPECT_EQ(check.status, 2);
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(check.standard_error, run.standard_error);
  EXPECT_NE(check.standard_error.find(told), std::string::npos) << check.standard_error;
}

// V-SAME.
TEST(CheckAndRun, RefuseNamesThatAreTooLong) {
  const TemporaryFolder folder;
  const fs::path deck = clone_folder() / "tests" / "data" / "cases" / "long_names" / "deck.yaml";
  fs::copy(deck, folder / "deck.yaml");
  expect_both_refuse(folder, "deck.yaml", "2 mistakes in deck.yaml\nline 15, Materials: the name");
  // The twin: the longest name that is admitted can be run.
  std::string text = small_deck();
  const std::string longest(200, 'g');
  text.replace(text.find("gel:"), 3, longest);
  text.replace(text.find("top:"), 3, std::string(200, 't'));
  folder.write("longest.yaml", text);
  const Outcome run = run_stroma(folder.path(), "run longest.yaml --quiet");
  EXPECT_EQ(run.status, 0) << run.standard_error;
  EXPECT_TRUE(History(folder / "longest/history.csv").has(longest + ".von_mises_mean"));
}

TEST(CheckAndRun, RefuseTextsThatDeckXmlCannotHold) {
  const TemporaryFolder folder;
  folder.write("base.yaml", small_deck());
  for (const std::string title : {"a\\001b", "a\\nb", "\\265m"})
    expect_both_refuse(folder, "base.yaml --set \"Title=$(printf '" + title + "x')\"",
                       "--set, Title: ");
  std::string text = small_deck();
  text.replace(text.find("gel:"), 3, "\"g\\x01l\"");
  text.replace(text.find("top:"), 3, "\"t\xB5p\"");
  folder.write("names.yaml", text);
  expect_both_refuse(folder, "names.yaml", "2 mistakes in names.yaml");
  // deck.xml holds the image's absolute path.
  fs::create_directory(folder / "\xB5m");
  folder.write("\xB5m/file.yaml", [&] {
    std::string file = small_deck();
    const std::size_t begin = file.find("    Phantom:"), end = file.find("  Materials:");
    return file.replace(begin, end - begin, "    File: gel.tif\n");
  }());
  expect_both_refuse(folder, "\xB5m/file.yaml", "Image|File: the path ");
}

}  // namespace
}  // namespace stroma::test
