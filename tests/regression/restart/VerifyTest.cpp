// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// `stroma verify` knows the contents of the files that a run left, wherever in them a byte changes.

#include <gtest/gtest.h>
#include <netcdf.h>

#include <functional>

#include "regression/restart/LongDeck.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

/// A run that leaves all kinds of files.
std::string deck_with_images(int seconds) {
  std::string deck = long_deck("", seconds);
  const std::string
      before = "Output: {",
      images =
          R"(Image Stacks: {Quantities: [displacement_y, strain_yy, label], Frame: Undeformed}, )";
  return deck.insert(deck.find(before) + before.size(), images);
}

/// All values of the element variables by three.
void scale_element_variables(const std::string& path) {
  int file = 0, variables = 0;
  ASSERT_EQ(nc_open(path.c_str(), NC_WRITE, &file), NC_NOERR);
  ASSERT_EQ(nc_inq_nvars(file, &variables), NC_NOERR);
  for (int v = 0; v < variables; ++v) {
    char name[NC_MAX_NAME + 1];
    ASSERT_EQ(nc_inq_varname(file, v, name), NC_NOERR);
    if (std::string(name).rfind("vals_elem_var", 0) != 0) continue;
    int dimensions = 0, of[NC_MAX_VAR_DIMS];
    ASSERT_EQ(nc_inq_varndims(file, v, &dimensions), NC_NOERR);
    ASSERT_EQ(nc_inq_vardimid(file, v, of), NC_NOERR);
    std::size_t count = 1;
    for (int d = 0; d < dimensions; ++d) {
      std::size_t length = 0;
      ASSERT_EQ(nc_inq_dimlen(file, of[d], &length), NC_NOERR);
      count *= length;
    }
    std::vector<double> values(count);
    ASSERT_EQ(nc_get_var_double(file, v, values.data()), NC_NOERR);
    for (double& value : values) value *= 3.0;
    ASSERT_EQ(nc_put_var_double(file, v, values.data()), NC_NOERR);
  }
  ASSERT_EQ(nc_close(file), NC_NOERR);
}

void expect_good(const TemporaryFolder& folder) {
  const Outcome verdict = run_stroma(folder.path(), "verify gel");
  EXPECT_EQ(verdict.status, 0) << verdict.standard_output << verdict.standard_error;
  EXPECT_NE(verdict.standard_output.find("files, SHA-256 as the run left them"), std::string::npos)
      << verdict.standard_output;
  EXPECT_NE(verdict.standard_output.find("\nall is as the run left it"), std::string::npos)
      << verdict.standard_output;
}

TEST(Verify, NamesEachFileThatWasChanged) {
  const TemporaryFolder folder;
  run_deck(folder, "gel", deck_with_images(2));
  expect_good(folder);
  folder.write("gel/notes.csv", "a user's own");
  ASSERT_EQ(run_stroma(folder.path(),
                       "run gel.yaml -o other --quiet --set 'Boundary "
                       "Conditions|top|Strain=0.07'")
                .status,
            0);
  const auto edit = [&](const std::string& file, const std::function<void(std::string&)>& change) {
    return [&folder, file, change] {
      std::string text = content_of(folder / ("gel/" + file));
      change(text);
      folder.write("gel/" + file, text);
    };
  };
  const std::vector<std::pair<std::string, std::function<void()>>> changes{
      {"particles.e", [&] { scale_element_variables(folder / "gel/particles.e"); }},
      {"grid.e",
       edit("grid.e", [&](std::string& text) { text = content_of(folder / "other/grid.e"); })},
      {"materials.csv",
       edit("materials.csv", [](std::string& text) { text[text.find_last_of("1234")] = '7'; })},
      {"image_undeformed.ome.tif",
       edit("image_undeformed.ome.tif",
            [](std::string& text) { text.replace(text.size() / 2, 4000, 4000, '\0'); })},
      {"report.html", edit("report.html", [](std::string& text) { text[text.size() / 2] ^= 1; })},
      {"history.csv", [&] { fs::remove(folder / "gel/history.csv"); }},
  };
  for (const auto& [file, change] : changes) {
    const std::string before = content_of(folder / ("gel/" + file));
    ASSERT_FALSE(before.empty()) << file;
    change();
    const Outcome verdict = run_stroma(folder.path(), "verify gel");
    EXPECT_EQ(verdict.status, 1) << file << verdict.standard_output;
    EXPECT_NE(
        verdict.standard_output.find("contents     WRONG " + file +
                                     (file == "history.csv" ? " is missing" : " was changed")),
        std::string::npos)
        << file << verdict.standard_output;
    folder.write("gel/" + file, before);
    expect_good(folder);
  }
}

TEST(Verify, KnowsWhatStromaMadeAnew) {
  const TemporaryFolder folder;
  run_deck(folder, "gel", deck_with_images(2));
  const std::string page = content_of(folder / "gel/report.html");
  fs::remove(folder / "gel/report.html");
  ASSERT_EQ(run_stroma(folder.path(), "report gel").status, 0);
  expect_good(folder);
  folder.write("gel.yaml", deck_with_images(4));
  ASSERT_EQ(run_stroma(folder.path(), "run gel.yaml --quiet --restart", 2).status, 0);
  EXPECT_NE(content_of(folder / "gel/report.html"), page);
  expect_good(folder);
}

// As a killed run leaves it.
TEST(Verify, SaysWhatItCouldNotCompare) {
  const TemporaryFolder folder;
  run_deck(folder, "gel", long_deck("", 2));
  fs::remove(folder / "gel/.stroma_files");
  const Outcome verdict = run_stroma(folder.path(), "verify gel");
  EXPECT_EQ(verdict.status, 0) << verdict.standard_output << verdict.standard_error;
  EXPECT_NE(verdict.standard_output.find("not compared"), std::string::npos);
  EXPECT_EQ(verdict.standard_output.find("\nall is as"), std::string::npos);
}

}  // namespace
}  // namespace stroma::test
