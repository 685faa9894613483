// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What a run does not go on from: a checkpoint of another body, or a damaged one.

#include <gtest/gtest.h>

#include <random>

#include "regression/restart/LongDeck.hpp"
#include "support/SmallDeck.hpp"

namespace stroma::test {
namespace {

/// Expects exit status 2 and a message with these words, and results as they were.
void expect_refusal(const TemporaryFolder& folder, const std::string& more,
                    const std::vector<std::string>& words) {
  const std::string before = content_of(folder / "gel/history.csv");
  const Outcome outcome = run_stroma(folder.path(), "run gel.yaml --quiet --restart " + more);
  EXPECT_EQ(outcome.status, 2) << more;
  for (const std::string& word : words)
    EXPECT_NE(outcome.standard_error.find(word), std::string::npos) << outcome.standard_error;
  EXPECT_EQ(content_of(folder / "gel/history.csv"), before);
}

// V-RESTART-3.
TEST(RestartRefusals, NameWhatDiffers) {
  const TemporaryFolder folder;
  run_deck(folder, "gel", long_deck("", 2));
  const auto set = [](const std::string& text) { return "--set '" + text + "'"; };
  expect_refusal(folder, set("Grid|Reset=true"), {"Grid|Reset: 0 there, 1 here"});
  expect_refusal(folder, set("Grid|Element Size [um]={3, 3, 3}"), {"- Grid|Element Size [um]: "});
  expect_refusal(folder, set("Materials|gel|C1 [Pa]=200.00000000001"),
                 {"- Materials|gel|C1 [Pa]: "});
  expect_refusal(folder, set("Materials|vessel|Density [kg/m^3]=1000"),
                 {"- Materials|vessel|Density [kg/m^3]: not there, and here"});
  expect_refusal(folder, set("Boundary Conditions|top|Strain=0.09"),
                 {"- Boundary Conditions|top|Strain: 0.08"});
  expect_refusal(folder, set("Load Curves|pull|Values={0, 2}"),
                 {"Boundary Conditions|top had 0.25 of its full value at time 1", "0.5"});
  expect_refusal(folder, set("Loading|Times [s]={1, 1.5}"), {"it is at 2 s already"});
  // What may change.
  const Outcome on = run_stroma(
      folder.path(), "run gel.yaml --quiet --restart " + set("Solver|Preconditioner=Jacobi") + " " +
                         set("Output|Grid Every=0") + " " + set("Title=another") + " " +
                         set("Load Curves|pull|Times [s]={0, 2, 5}") + " " +
                         set("Load Curves|pull|Values={0, 0.5, 0.6}") + " " +
                         set("Loading|Times [s]={1, 2, 5}"));
  EXPECT_EQ(on.status, 0) << on.standard_error;
}

TEST(RestartRefusals, AskForACheckpoint) {
  const TemporaryFolder folder;
  folder.write("gel.yaml", small_deck());
  const Outcome none = run_stroma(folder.path(), "run gel.yaml --restart");
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.standard_error.find("cannot read 'gel/checkpoint.h5': there is no such file"),
            std::string::npos)
      << none.standard_error;
  EXPECT_FALSE(fs::exists(folder / "gel"));
  fs::create_directories(folder / "gel");
  folder.write("gel/checkpoint.h5", "a user's own notes");
  EXPECT_EQ(run_stroma(folder.path(), "run gel.yaml --restart").status, 2);
  EXPECT_EQ(content_of(folder / "gel/checkpoint.h5"), "a user's own notes");
  EXPECT_EQ(run_stroma(folder.path(), "verify gel").status, 2);
}

TEST(RestartRefusals, KnowAnotherImage) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_stroma(folder.path(), "phantom -o a.tif --size 8,8,8 --fraction 0.2").status, 0);
  std::string deck = small_deck();
  const std::size_t image = deck.find("  Image:"), materials = deck.find("  Materials:");
  ASSERT_LT(image, materials);
  deck.replace(image, materials - image, "  Image: {File: a.tif}\n");
  run_deck(folder, "gel", deck);
  fs::rename(folder / "a.tif", folder / "b.tif");  // the same image by another name
  const Outcome moved =
      run_stroma(folder.path(), "run gel.yaml --quiet --restart --set 'Image|File=b.tif'");
  EXPECT_EQ(moved.status, 0) << moved.standard_error;
  EXPECT_EQ(run_stroma(folder.path(), "verify gel").status, 0);

  ASSERT_EQ(run_stroma(folder.path(), "phantom -o a.tif --size 8,8,8 --fraction 0.25").status, 0);
  expect_refusal(folder, "", {"the image files are not those that the run had"});
  fs::rename(folder / "a.tif", folder / "b.tif");
  const Outcome wrong = run_stroma(folder.path(), "verify gel");
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.standard_output.find("images       WRONG"), std::string::npos)
      << wrong.standard_output;
}

// V-RESTART-4. What HDF5 leaves unused between its pieces may change without harm: then the run is
// the same to the last bit.
TEST(RestartRefusals, TellADamagedCheckpoint) {
  const TemporaryFolder folder;
  run_deck(folder, "gel", long_deck(", Reset: true", 2));
  const std::string good = content_of(folder / "gel/checkpoint.h5");
  const std::string history = content_of(folder / "gel/history.csv");
  std::mt19937 chance(1);
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(chance);
  };
  int refused = 0;
  for (int n = 0; n < 100; ++n) {
    std::string bad = good;
    const std::size_t place = n % 3 == 0 ? below(4096) : below(good.size());
    if (n % 4 == 0) bad.resize(place);
    if (n % 4 == 1) bad[place] = static_cast<char>(bad[place] ^ (1 << below(8)));
    if (n % 4 == 2) bad.replace(place, 64, std::string(64, '\0'));
    if (n % 4 == 3)
      for (std::size_t i = 0; i < 8; ++i) bad[below(bad.size())] = static_cast<char>(below(256));
    folder.write("gel/checkpoint.h5", bad);
    const Outcome outcome = run_stroma(folder.path(), "run gel.yaml --quiet --restart");
    ASSERT_TRUE(outcome.status == 2 || outcome.status == 0)
        << n << ", at " << place << ": " << outcome.status << outcome.standard_error;
    if (outcome.status == 2) {
      ++refused;
      EXPECT_NE(outcome.standard_error.find("gel/checkpoint.h5'"), std::string::npos)
          << n << ": " << outcome.standard_error;
    }
    EXPECT_EQ(content_of(folder / "gel/history.csv"), history) << n;
  }
  EXPECT_GE(refused, 60);
}

}  // namespace
}  // namespace stroma::test
